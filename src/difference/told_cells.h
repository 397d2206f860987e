// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of cells of the parameter plane, for those beside them.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "difference/surface_chart.h"

namespace featuremesh {

/// Cells that come from halving one root and that no changed piece enters, with whether they belong to the difference.
/// No changed piece lies between two of them that share a border, so one answers for the other.
class ToldCells {
  public:
    explicit ToldCells(const UvBox& root) : root_(root) {}

    void add(const UvBox& cell, bool differs) {
        for (std::size_t k = 0; k < 2; ++k)
            for (const double end : {cell.low[k], cell.high[k]}) by_line_[k][line_of(k, end)].push_back(cells_.size());
        cells_.push_back({cell, differs});
    }

    /// Nothing where none is known that shares a border with the cell.
    std::optional<bool> beside(const UvBox& cell) const {
        for (std::size_t k = 0; k < 2; ++k)
            for (const double end : {cell.low[k], cell.high[k]}) {
                const auto found = by_line_[k].find(line_of(k, end));
                if (found == by_line_[k].end()) continue;
                for (const std::size_t other : found->second)
                    if (run_together(cell, cells_[other].cell, 1 - k)) return cells_[other].differs;
            }
        return std::nullopt;
    }

  private:
    struct Told {
        UvBox cell;
        bool differs;
    };

    /// Ends that meet are the same to the last bit or nearly so.
    std::int64_t line_of(std::size_t k, double end) const {
        constexpr double finest = double(1 << 30);
        return std::llround((end - root_.low[k]) / root_.size(int(k)) * finest);
    }

    static bool run_together(const UvBox& a, const UvBox& b, std::size_t k) {
        const double together = std::min(a.high[k], b.high[k]) - std::max(a.low[k], b.low[k]);
        return together > 0.5 * std::min(a.size(int(k)), b.size(int(k)));
    }

    UvBox root_;
    std::vector<Told> cells_;
    std::unordered_map<std::int64_t, std::vector<std::size_t>> by_line_[2];  ///< by the lines on which they end
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles that stay although the tets behind them go.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/run_context.h"
#include "update/keep.h"

namespace featuremesh {

/// A face that is as it was is best divided as it was, also where the wall behind it changes. So a triangle in place
/// stays when its nodes are clear of what changed on its own underlying surface, whatever changed elsewhere, and the
/// wanted size there is the old one.
class KeptSurfaces {
  public:
    explicit KeptSurfaces(const KeepInput& input) : in_(input) {}

    /// `motions` by old node: the index of its carried region, or dropped. `margin_of`: mm around a dropped node that
    /// have to be free of changes; 0 where it may not stay at all.
    void find(std::span<const std::int32_t> motions, const std::function<double(std::size_t)>& margin_of,
              const RunContext& context);

    /// Leaves out triangles with a node that has gone since.
    void settle(std::span<const std::int32_t> motions);

    bool is_kept(std::size_t triangle) const { return !is_kept_.empty() && is_kept_[triangle] != 0; }
    /// A kept triangle has the old node, corner or mid-side.
    bool has_kept(std::size_t node) const { return !is_used_.empty() && is_used_[node] != 0; }

  private:
    template <class Stays>
    void keep_where(Stays stays);

    const KeepInput& in_;
    std::vector<char> is_kept_, is_used_;  // by old triangle, by old node
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// A cell of the parameter plane, divided by straight lines.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "difference/surface_chart.h"

namespace featuremesh {

using UvLine = std::array<Uv, 2>;

/// A stretch of a cell between two u, divided by the lines that go all along it.
struct CellStrip {
    double left, right;
    double middle;  ///< the share of the way at which no line begins, ends or crosses another
    /// v at the left and at the right: of the cell's bottom, the lines from below, and the cell's top.
    std::vector<std::array<double, 2>> heights;

    Uv at(std::size_t height, double share) const {
        const auto& [from, to] = heights[height];
        return {left + share * (right - left), from + share * (to - from)};
    }
    /// Half way between a height and the next one.
    Uv between(std::size_t height, double share) const {
        const Uv below = at(height, share), above = at(height + 1, share);
        return {below[0], 0.5 * (below[1] + above[1])};
    }
    /// The height with most room above it, at the middle.
    std::size_t widest() const;
};

/// The part of the line inside the box, by Liang's and Barsky's way.
std::optional<UvLine> part_inside(const UvLine& line, const UvBox& box);

/// From left to right. Lines end inside the cell or at its border; what is nearer to another in u than `slack` is at
/// the same u.
std::vector<CellStrip> strips_of(const UvBox& cell, std::span<const UvLine> lines, double slack);

}  // namespace featuremesh

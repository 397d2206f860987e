// SPDX-License-Identifier: GPL-3.0-or-later
// The flatness of four tets at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "core/geometry.h"
#include "volume/tets/radius_ratios.h"

namespace featuremesh {

/// Four triangles that see a point, number by number: coordinate d of corner c is in row 3 c + d.
struct FourTriangles {
    static constexpr std::size_t count = 4;
    std::array<std::array<double, count>, 9> rows;

    void set(std::size_t i, const SeenTriangle& triangle) {
        for (std::size_t c = 0; c < 3; ++c)
            for (int d = 0; d < 3; ++d) rows[3 * c + static_cast<std::size_t>(d)][i] = triangle.corners[c][d];
    }
    /// Repeats the last of the first ones.
    void fill_up(std::size_t first) {
        for (auto& row : rows) std::fill(row.begin() + static_cast<std::ptrdiff_t>(first), row.end(), row[first - 1]);
    }
};

/// Of which tets the flatness says all: those with at least so much volume, mm^3, and with six volumes of at least
/// this share of the cube of twice the longest side at the point; and that are less flat than this, or have no side
/// below that share of the longest.
struct PlainTets {
    double least_volume, least_share, flatness, shortest_share;
};

/// By triangle the `flatness` of the tet (point, triangle), -1 where that does not say all. The same bits on every
/// machine.
std::array<double, 4> flatness_of_four(const Vec3& point, const FourTriangles& triangles, const PlainTets& plain);
/// How far the tets of a point are plain and less flat than a limit.
struct PlainRun {
    std::size_t end;                 ///< the first four with one that is not; else how many there are
    double most;                     ///< flatness of those before it, 0 for none
    std::array<double, 4> flatness;  ///< of the four at the end, as `flatness_of_four` gives it
};
PlainRun plain_run(const Vec3& point, std::span<const FourTriangles> fours, std::size_t begin, const PlainTets& plain,
                   double limit);
/// The same without the processor's wider registers, for tests.
std::array<double, 4> flatness_by_parts(const Vec3& point, const FourTriangles& triangles, const PlainTets& plain);

}  // namespace featuremesh

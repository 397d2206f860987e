// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/tets/needles.h"

#include <algorithm>
#include <limits>

#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

/// The side, by its place in edge_corners, that makes a tet a needle: the boundary has both its ends, and it is shorter
/// than `needle_share` of the longest side. -1 for none.
int needle_side(const std::array<Vec3, 4>& p, const std::array<bool, 4>& is_on_boundary) {
    int shortest = -1;
    double least = std::numeric_limits<double>::max(), most = 0;
    for (int side = 0; side < 6; ++side) {
        const auto& [i, j] = edge_corners[side];
        const double squared = squared_length(p[i] - p[j]);
        most = std::max(most, squared);
        if (squared < least && is_on_boundary[i] && is_on_boundary[j]) least = squared, shortest = side;
    }
    return least < needle_share * needle_share * most ? shortest : -1;
}

/// Largest squared cosine of the dihedral angles but that opposite the side.
double flatness_without(const std::array<Vec3, 4>& p, int side) {
    std::array<Vec3, 4> normal;
    for (int i = 0; i < 4; ++i) {
        const auto& [a, b, c] = opposite_face[i];
        normal[i] = normalized(cross(p[b] - p[a], p[c] - p[a]));
    }
    double worst = 0;
    for (int other = 0; other < 6; ++other) {
        // the triangles opposite the ends of the short side meet at the side opposite to it
        if (other == side) continue;
        const double cosine = dot(normal[edge_corners[other][0]], normal[edge_corners[other][1]]);
        worst = std::max(worst, std::min(1.0, cosine * cosine));
    }
    return worst;
}

}  // namespace

double unforced_flatness(double flatness, const std::array<Vec3, 4>& corners,
                         const std::array<bool, 4>& is_on_boundary) {
    if (flatness < least_flatness_of_needle || flatness > 1) return flatness;
    const int side = needle_side(corners, is_on_boundary);
    return side >= 0 ? flatness_without(corners, side) : flatness;
}

}  // namespace featuremesh

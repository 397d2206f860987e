// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/needles.h"

#include <algorithm>
#include <limits>

#include "volume/tet_topology.h"

namespace featuremesh {

namespace {

/// With more, the angle opposite the side is large enough to be worth something.
constexpr double needle_share = 0.005;

/// Largest squared cosine of the dihedral angles but that opposite the side.
double flatness_without(const std::array<Vec3, 4>& p, int side) {
    if (!(signed_volume(p[0], p[1], p[2], p[3]) > 0)) return inverted_flatness;
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

double unforced_flatness(double flatness, const std::array<Vec3, 4>& corners,
                         const std::array<bool, 4>& is_on_boundary) {
    if (flatness < least_flatness_of_needle || flatness == inverted_flatness) return flatness;
    const int side = needle_side(corners, is_on_boundary);
    return side >= 0 ? flatness_without(corners, side) : flatness;
}

bool has_needle(const TetComplex& complex) {
    return std::any_of(complex.tets.begin(), complex.tets.end(), [&](const Tet& tet) {
        if (tet[0] < 0) return false;
        const auto& p = complex.points;
        const std::array<Vec3, 4> corners{p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]};
        return flatness(corners[0], corners[1], corners[2], corners[3]) >= least_flatness_of_needle &&
               needle_side(corners, {may_have_needle(complex, tet[0]), may_have_needle(complex, tet[1]),
                                     may_have_needle(complex, tet[2]), may_have_needle(complex, tet[3])}) >= 0;
    });
}

double unforced_flatness(const TetComplex& complex, const std::array<int, 4>& tet) {
    const auto& [a, b, c, d] = tet;
    const auto& p = complex.points;
    const double all = flatness(p[a], p[b], p[c], p[d]);
    if (all < least_flatness_of_needle || all == inverted_flatness) return all;
    const auto is_outside = [&](int v) { return may_have_needle(complex, v); };
    return unforced_flatness(all, {p[a], p[b], p[c], p[d]},
                             {is_outside(a), is_outside(b), is_outside(c), is_outside(d)});
}

bool is_excused(const TetComplex& complex, const std::array<int, 4>& tet) {
    const auto& [a, b, c, d] = tet;
    const auto& p = complex.points;
    return unforced_flatness(complex, tet) < flatness(p[a], p[b], p[c], p[d]);
}

}  // namespace featuremesh

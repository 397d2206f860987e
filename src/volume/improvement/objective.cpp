// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/improvement/objective.h"

#include "mesh/quality.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

/// A change that leaves the worst angle as it is has to lower the penalty by at least this share.
constexpr double least_gain_of_penalty = 0.02;
/// A change has to leave at least this share of the mean shape: one angle is not worth the shapes of all others.
constexpr double least_kept_shape = 0.5;

/// The side, by its place in edge_corners, that makes a tet a needle: the boundary has both its ends, and it is shorter
/// than a share of the longest side. -1 for none.
int needle_side(const std::array<Vec3, 4>& p, const std::array<bool, 4>& is_on_boundary, double share) {
    int shortest = -1;
    double least = std::numeric_limits<double>::max(), most = 0;
    for (int side = 0; side < 6; ++side) {
        const auto& [i, j] = edge_corners[side];
        const double squared = squared_length(p[i] - p[j]);
        most = std::max(most, squared);
        if (squared < least && is_on_boundary[i] && is_on_boundary[j]) least = squared, shortest = side;
    }
    return least < share * share * most ? shortest : -1;
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

std::array<bool, 4> are_on_boundary(const TetComplex& complex, const Tet& tet) {
    const auto& m = complex.mobility;
    return {is_on_boundary(m[tet[0]]), is_on_boundary(m[tet[1]]), is_on_boundary(m[tet[2]]), is_on_boundary(m[tet[3]])};
}

}  // namespace

std::array<Vec3, 4> corners_of(const TetComplex& complex, const Tet& tet) {
    const auto& p = complex.points;
    return {p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]};
}

double Objective::unforced_flatness(double flatness, const std::array<Vec3, 4>& corners,
                                    const std::array<bool, 4>& is_on_boundary) {
    if (flatness < least_flatness_of_needle || flatness > 1) return flatness;
    const int side = needle_side(corners, is_on_boundary, needle_share);
    return side >= 0 ? flatness_without(corners, side) : flatness;
}

double Objective::flaw(const TetComplex& complex, const Tet& tet) const {
    return unless_barred(flaw(corners_of(complex, tet), are_on_boundary(complex, tet)), tet);
}

bool Objective::is_excused(const TetComplex& complex, const Tet& tet) const {
    const std::array<Vec3, 4> p = corners_of(complex, tet);
    const double all = flatness(p[0], p[1], p[2], p[3]);
    return unforced_flatness(all, p, are_on_boundary(complex, tet)) < all;
}

bool Objective::excuses_any(const TetComplex& complex, std::span<const int> tets) const {
    return std::any_of(tets.begin(), tets.end(), [&](int t) { return is_excused(complex, complex.tets[t]); });
}

double Objective::thickness(const std::array<Vec3, 4>& p) const {
    const double six_volumes = dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
    const double ab = squared_length(p[1] - p[0]), ac = squared_length(p[2] - p[0]), ad = squared_length(p[3] - p[0]),
                 bc = squared_length(p[2] - p[1]), bd = squared_length(p[3] - p[1]), cd = squared_length(p[3] - p[2]);
    // the largest product of the three edges at a corner
    const double lengths = std::sqrt(std::max({ab * ac * ad, ab * bc * bd, ac * bc * cd, ad * bd * cd}));
    return std::min(six_volumes / (6 * options_.least_volume), six_volumes / (least_share * lengths));
}

Value Objective::value(const TetComplex& complex, const Tet& tet) const {
    const double of = flaw(complex, tet);
    const std::array<Vec3, 4> p = corners_of(complex, tet);
    return {of, penalty(of), radius_ratio(p[0], p[1], p[2], p[3]), 1};
}

Value Objective::value(const TetComplex& complex, std::span<const Tet> tets) const {
    Value sum;
    for (const Tet& tet : tets) sum += value(complex, tet);
    return sum;
}

Value Objective::value(const TetComplex& complex, std::span<const int> tets) const {
    Value sum;
    for (const int t : tets) sum += value(complex, complex.tets[t]);
    return sum;
}

bool Objective::is_better(const Value& before, const Value& after, const Price& price) const {
    if (!(after.worst < inverted_flatness)) return false;
    const bool is_reached = after.worst <= target_;
    if (before.worst > target_ && (is_reached || !price.needs_target || before.worst > urgent_) &&
        (before.worst > 1 || after.mean_shape() >= least_kept_shape * before.mean_shape())) {
        if (after.worst < improved(before.worst, price.angle) && (is_reached || after.penalty < before.penalty))
            return true;
        if (after.worst <= before.worst &&
            after.penalty < (1 - std::max(price.angle, least_gain_of_penalty)) * before.penalty)
            return true;
    }
    return after.worst <= std::max(before.worst, target_) && after.penalty <= before.penalty &&
           (after.mean_shape() - before.mean_shape()) * before.count >= price.shape;
}

double Objective::need(const TetComplex& complex, const Tet& tet) const {
    if (const double value = flaw(complex, tet); value > target_) return 1 + value;
    if (!looks_at_shapes()) return 0;
    const std::array<Vec3, 4> p = corners_of(complex, tet);
    const double ratio = radius_ratio(p[0], p[1], p[2], p[3]);
    return is_poor(ratio) ? 1 - ratio : 0;
}

bool is_flat(const TetComplex& complex, const Tet& tet) {
    const auto [a, b, c, d] = corners_of(complex, tet);
    const Vec3 u = b - a, v = c - a, w = d - a;
    return !(dot(cross(u, v), w) > 1.01e-6 * length(u) * length(v) * length(w));
}

bool is_too_thin(const TetComplex& complex, const Tet& tet, double least_volume) {
    // tets are mended until they have the least volume; with this share of it they are still no reason to refuse a part
    constexpr double tolerated_share = 0.92;
    const auto [a, b, c, d] = corners_of(complex, tet);
    return is_flat(complex, tet) || signed_volume(a, b, c, d) < tolerated_share * least_volume;
}

}  // namespace featuremesh

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

}  // namespace

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

double Objective::worst(const TetComplex& complex, std::span<const int> tets) const {
    double result = 0;
    for (const int t : tets) result = std::max(result, flaw(complex, complex.tets[t]));
    return result;
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

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/cone_refill.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace featuremesh {

namespace {
/// A new vertex costs more than a flip.
constexpr double least_gain_of_insertion = 0.05;
/// For an insertion the cavity is grown and the point moved this often in turn.
constexpr int insertion_rounds = 2;
/// Above a side of the tet, in square roots of twice its area; a regular tet is 0.88 high.
constexpr std::array heights_of_insertion{0.5, 0.9};
}  // namespace

const ConePlan* ConeRefill::plan(int tet) {
    best_.flatness = inverted_flatness;
    plan_from_corners(tet);
    if (best_.flatness > target_) plan_collapses(tet);
    if (best_.flatness > target_) plan_insertions(tet);
    return best_.flatness < inverted_flatness ? &best_ : nullptr;
}

void ConeRefill::consider(double gain) {
    if (cavity_.worst_after() >= std::min(improved_flatness(cavity_.worst_before(), gain), best_.flatness)) return;
    if (cavity_.worst_after() > target_ && cavity_.burden_after(target_) >= cavity_.burden_before(target_)) return;
    const int apex = cavity_.apex();
    best_.flatness = cavity_.worst_after();
    best_.is_insertion = apex < 0;
    best_.point = cavity_.point();
    best_.removed.assign(cavity_.removed().begin(), cavity_.removed().end());
    const auto cones = cavity_.cones(apex < 0 ? static_cast<int>(editor_.complex().points.size()) : apex);
    best_.added.assign(cones.begin(), cones.end());
}

void ConeRefill::plan_from_corners(int tet) {
    const TetComplex& complex = editor_.complex();
    for (int face = 0; face < 4; ++face) {
        const int corner = complex.tets[tet][face];
        if (cavity_.grow(std::array{tet}, corner, complex.points[corner])) consider(least_gain);
        const int next = complex.neighbours[tet][face];
        if (next < 0) continue;
        const int apex = complex.tets[next][face_towards(complex.neighbours[next], tet)];
        if (cavity_.grow(std::array{tet, next}, apex, complex.points[apex])) consider(least_gain);
    }
}

void ConeRefill::plan_collapses(int tet) {
    const TetComplex& complex = editor_.complex();
    for (int v : complex.tets[tet]) {
        if (complex.is_fixed[v]) continue;
        if (!gather_star(complex, v, star_)) continue;
        gather_neighbours(complex, v, star_, others_);
        for (int apex : others_)
            if (cavity_.grow(star_, apex, complex.points[apex])) consider(least_gain);
    }
}

void ConeRefill::plan_insertions(int tet) {
    const TetComplex& complex = editor_.complex();
    const Tet& v = complex.tets[tet];
    const auto& p = complex.points;
    plan_insertion(std::array{tet}, (p[v[0]] + p[v[1]] + p[v[2]] + p[v[3]]) / 4);
    for (const auto& [from, to] : edge_corners) {
        EdgeRing ring;
        if (find_ring(complex, tet, from, to, ring)) plan_insertion(ring.all_tets(), (p[ring.from] + p[ring.to]) / 2);
    }
    if (is_last_resort_ && best_.flatness > target_) plan_insertions_above(tet);
}

void ConeRefill::plan_insertions_above(int tet) {
    const Tet& v = editor_.complex().tets[tet];
    const auto& p = editor_.complex().points;
    for (int face = 0; face < 4; ++face) {
        const auto& corner = opposite_face[face];
        const Vec3 &a = p[v[corner[0]]], &b = p[v[corner[1]]], &c = p[v[corner[2]]];
        const Vec3 middle = (a + b + c) / 3;
        Vec3 normal = cross(b - a, c - a);
        if (dot(normal, p[v[face]] - middle) < 0) normal = -1.0 * normal;
        const double reach = std::sqrt(length(normal));
        for (const double height : heights_of_insertion)
            plan_insertion(std::array{tet}, middle + (height / reach) * normal);
    }
}

void ConeRefill::plan_insertion(std::span<const int> start, const Vec3& point) {
    if (!cavity_.grow(start, -1, point)) return;
    for (int round = 1; round < insertion_rounds; ++round) {
        cavity_.climb(target_);
        consider_insertion();
        if (!cavity_.grow(start, -1, cavity_.point())) return;
    }
    cavity_.climb(target_);
    consider_insertion();
}

void ConeRefill::consider_insertion() {
    if (cavity_.worst_after() <= target_ || cavity_.worst_before() > urgent_) consider(least_gain_of_insertion);
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Removal of an edge: the best triangulation of its ring by dynamic programming (Klincsek 1980; Shewchuk, "Two discrete
// optimization algorithms for the topological improvement of tetrahedral meshes", 2002).
#pragma once

#include <array>
#include <limits>
#include <span>

#include "volume/tets/cavity_editor.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_measures.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

/// A triangulation of an edge's ring of at most so many vertices: for each side (i, j) of the triangulation the third
/// ring place.
template <int most = EdgeRing::max_size>
struct RingTriangulation {
    double cost = std::numeric_limits<double>::infinity();
    std::array<std::array<signed char, most>, most> apex{};
};

/// Minimises Total::combine over the costs of the size-2 triangles: all choices are covered in O(size^3). `cost(i,
/// j, k)`, i < j < k, is that of a triangle of ring places; `limit` is the cost from which on a solution is of no use.
template <class Total, int most = EdgeRing::max_size, class Cost>
RingTriangulation<most> triangulate_ring(int size, double limit, const Cost& cost) {
    RingTriangulation<most> result;
    std::array<std::array<double, most>, most> best;
    for (int i = 0; i + 1 < size; ++i) best[i][i + 1] = Total::nothing;
    for (int length = 2; length < size; ++length) {
        for (int i = 0; i + length < size; ++i) {
            const int j = i + length;
            best[i][j] = std::numeric_limits<double>::infinity();
            for (int k = i + 1; k < j; ++k) {
                const double sides = Total::combine(best[i][k], best[k][j]);
                if (sides >= best[i][j] || sides >= limit) continue;
                const double whole = Total::combine(sides, cost(i, k, j));
                if (whole < best[i][j]) {
                    best[i][j] = whole;
                    result.apex[i][j] = static_cast<signed char>(k);
                }
            }
        }
    }
    if (best[0][size - 1] < limit) result.cost = best[0][size - 1];
    return result;
}

/// The worst tet counts.
struct WorstOf {
    static constexpr double nothing = 0;
    static double combine(double a, double b) { return a < b ? b : a; }
};
/// The sum counts.
struct SumOf {
    static constexpr double nothing = 0;
    static double combine(double a, double b) { return a + b; }
};

/// Calls visit(i, j, k) for every triangle.
template <int most, class Visit>
void visit_triangles(const RingTriangulation<most>& ring, int i, int j, const Visit& visit) {
    if (j - i < 2) return;
    const int k = ring.apex[i][j];
    visit(i, k, j);
    visit_triangles(ring, i, k, visit);
    visit_triangles(ring, k, j, visit);
}

/// The tets of a ring's triangulation, 2 (size - 2) of them.
int tets_of_triangulation(const EdgeRing& ring, const RingTriangulation<>& triangulation,
                          std::array<Tet, 2 * EdgeRing::max_size>& tets);

/// The triangulation with the lowest ODT energy. Tets whose energy is no more than `flat` are not allowed: what a flat
/// tet has is rounding, of either sign.
RingTriangulation<> lowest_energy_triangulation(const TetComplex& complex, const EdgeRing& ring, double flat,
                                                double limit);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/edge_removal.h"

#include <algorithm>

namespace featuremesh {

namespace {

/// The corner points of a ring, next to each other.
struct RingPoints {
    RingPoints(const TetComplex& complex, const EdgeRing& ring)
        : from(complex.points[ring.from]), to(complex.points[ring.to]) {
        for (int i = 0; i < ring.size; ++i) corners[i] = complex.points[ring.vertices[i]];
    }
    Vec3 from, to;
    std::array<Vec3, EdgeRing::max_size> corners;
};

double flatness_of(const TetComplex& complex, const Tet& v) {
    const auto& p = complex.points;
    return flatness(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
}

}  // namespace

int tets_of_triangulation(const EdgeRing& ring, const RingTriangulation& triangulation,
                          std::array<Tet, 2 * EdgeRing::max_size>& tets) {
    int count = 0;
    visit_triangles(triangulation, 0, ring.size - 1, [&](int i, int j, int k) {
        const int a = ring.vertices[i], b = ring.vertices[j], c = ring.vertices[k];
        tets[count++] = {a, b, c, ring.to};
        tets[count++] = {b, a, c, ring.from};
    });
    return count;
}

RingTriangulation least_flat_triangulation(const TetComplex& complex, const EdgeRing& ring, double limit) {
    const RingPoints p(complex, ring);
    return triangulate_ring<WorstOf>(ring.size, limit, [&](int i, int j, int k) {
        const double upper = flatness(p.corners[i], p.corners[j], p.corners[k], p.to);
        return upper >= limit ? upper : std::max(upper, flatness(p.corners[j], p.corners[i], p.corners[k], p.from));
    });
}

RingTriangulation lowest_energy_triangulation(const TetComplex& complex, const EdgeRing& ring, double limit) {
    const RingPoints p(complex, ring);
    return triangulate_ring<SumOf>(ring.size, limit, [&](int i, int j, int k) {
        const double upper = odt_energy(p.corners[i], p.corners[j], p.corners[k], p.to);
        const double lower = odt_energy(p.corners[j], p.corners[i], p.corners[k], p.from);
        return upper > 0 && lower > 0 ? upper + lower : std::numeric_limits<double>::infinity();
    });
}

double worst_flatness(const TetComplex& complex, std::span<const int> tets) {
    double worst = 0;
    for (int tet : tets) worst = std::max(worst, flatness_of(complex, complex.tets[tet]));
    return worst;
}

double burden_of(const TetComplex& complex, std::span<const int> tets, double target) {
    double sum = 0;
    for (int tet : tets) sum += burden(flatness_of(complex, complex.tets[tet]), target);
    return sum;
}

double burden_of(const TetComplex& complex, std::span<const Tet> tets, double target) {
    double sum = 0;
    for (const Tet& tet : tets) sum += burden(flatness_of(complex, tet), target);
    return sum;
}

}  // namespace featuremesh

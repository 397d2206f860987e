// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/edge_removal.h"

#include <algorithm>

#include "volume/needles.h"

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

}  // namespace

int tets_of_triangulation(const EdgeRing& ring, const RingTriangulation<>& triangulation,
                          std::array<Tet, 2 * EdgeRing::max_size>& tets) {
    int count = 0;
    visit_triangles(triangulation, 0, ring.size - 1, [&](int i, int j, int k) {
        const int a = ring.vertices[i], b = ring.vertices[j], c = ring.vertices[k];
        tets[count++] = {a, b, c, ring.to};
        tets[count++] = {b, a, c, ring.from};
    });
    return count;
}

RingTriangulation<> least_flat_triangulation(const TetComplex& complex, const EdgeRing& ring, double limit) {
    const RingPoints p(complex, ring);
    return triangulate_ring<WorstOf>(ring.size, limit, [&](int i, int j, int k) {
        double upper = flatness(p.corners[i], p.corners[j], p.corners[k], p.to);
        if (upper >= least_flatness_of_needle)
            upper = unforced_flatness(complex, {ring.vertices[i], ring.vertices[j], ring.vertices[k], ring.to});
        if (upper >= limit) return upper;
        double lower = flatness(p.corners[j], p.corners[i], p.corners[k], p.from);
        if (lower >= least_flatness_of_needle)
            lower = unforced_flatness(complex, {ring.vertices[j], ring.vertices[i], ring.vertices[k], ring.from});
        return std::max(upper, lower);
    });
}

RingTriangulation<> lowest_energy_triangulation(const TetComplex& complex, const EdgeRing& ring, double limit) {
    const RingPoints p(complex, ring);
    return triangulate_ring<SumOf>(ring.size, limit, [&](int i, int j, int k) {
        const double upper = odt_energy(p.corners[i], p.corners[j], p.corners[k], p.to);
        const double lower = odt_energy(p.corners[j], p.corners[i], p.corners[k], p.from);
        return upper > 0 && lower > 0 ? upper + lower : std::numeric_limits<double>::infinity();
    });
}

double worst_flatness(const TetComplex& complex, std::span<const int> tets) {
    double worst = 0;
    for (int tet : tets) worst = std::max(worst, unforced_flatness(complex, complex.tets[tet]));
    return worst;
}

double burden_of(const TetComplex& complex, std::span<const int> tets, double target) {
    double sum = 0;
    for (int tet : tets) sum += burden(unforced_flatness(complex, complex.tets[tet]), target);
    return sum;
}

double burden_of(const TetComplex& complex, std::span<const Tet> tets, double target) {
    double sum = 0;
    for (const Tet& tet : tets) sum += burden(unforced_flatness(complex, tet), target);
    return sum;
}

}  // namespace featuremesh

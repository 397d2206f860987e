// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/tets/edge_removal.h"

#include "core/geometry.h"

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

RingTriangulation<> lowest_energy_triangulation(const TetComplex& complex, const EdgeRing& ring, double flat,
                                                double limit) {
    const RingPoints p(complex, ring);
    return triangulate_ring<SumOf>(ring.size, limit, [&](int i, int j, int k) {
        const double upper = odt_energy(p.corners[i], p.corners[j], p.corners[k], p.to);
        const double lower = odt_energy(p.corners[j], p.corners[i], p.corners[k], p.from);
        return upper > flat && lower > flat ? upper + lower : std::numeric_limits<double>::infinity();
    });
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Small complexes for the tests of the optimiser.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "volume/tet_complex.h"
#include "volume/tet_measures.h"
#include "volume/tet_topology.h"

namespace featuremesh {

/// count^3 unit cubes of six tets each, the outside fixed, inner vertices displaced by up to `jitter` (below 0.2
/// nothing inverts).
inline TetComplex box_of_tets(int count, double jitter, unsigned seed) {
    TetComplex box;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> displace(-jitter, jitter);
    const int side = count + 1;
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto is_inside = [&](int c) { return c > 0 && c < count; };
                const bool is_free = is_inside(x) && is_inside(y) && is_inside(z);
                Vec3 p{1.0 * x, 1.0 * y, 1.0 * z};
                if (is_free) p += {displace(random), displace(random), displace(random)};
                box.points.push_back(p);
                box.is_fixed.push_back(!is_free);
            }
    std::array<int, 3> axes{0, 1, 2};
    const std::array<int, 3> stride{1, side, side * side};
    do {
        const bool is_even = (axes[1] - axes[0] + 3) % 3 == 1;
        for (int z = 0; z < count; ++z)
            for (int y = 0; y < count; ++y)
                for (int x = 0; x < count; ++x) {
                    const int a = x + side * (y + side * z);
                    const int b = a + stride[axes[0]], c = b + stride[axes[1]], d = c + stride[axes[2]];
                    box.tets.push_back(is_even ? Tet{a, b, c, d} : Tet{a, c, b, d});
                }
    } while (std::next_permutation(axes.begin(), axes.end()));
    box.regions.assign(box.tets.size(), 0);
    connect(box);
    return box;
}

inline double volume_of(const TetComplex& complex, const Tet& v) {
    const auto& p = complex.points;
    return signed_volume(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
}

inline double total_volume(const TetComplex& complex) {
    double sum = 0;
    for (const Tet& v : complex.tets)
        if (v[0] >= 0) sum += volume_of(complex, v);
    return sum;
}

inline double total_energy(const TetComplex& complex) {
    double sum = 0;
    const auto& p = complex.points;
    for (const Tet& v : complex.tets)
        if (v[0] >= 0) sum += odt_energy(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
    return sum;
}

inline double worst_flatness(const TetComplex& complex) {
    double worst = 0;
    const auto& p = complex.points;
    for (const Tet& v : complex.tets)
        if (v[0] >= 0) worst = std::max(worst, flatness(p[v[0]], p[v[1]], p[v[2]], p[v[3]]));
    return worst;
}

/// The triangles on the outside, by vertices.
inline std::set<std::array<int, 3>> outside_of(const TetComplex& complex) {
    std::set<std::array<int, 3>> faces;
    for (std::size_t t = 0; t < complex.tets.size(); ++t)
        for (int face = 0; face < 4; ++face)
            if (complex.tets[t][0] >= 0 && complex.neighbours[t][face] < 0)
                faces.insert(sorted_face(complex.tets[t], face));
    return faces;
}

inline bool are_same_bytes(const TetComplex& a, const TetComplex& b) {
    return a.points == b.points && a.is_fixed == b.is_fixed && a.tets == b.tets && a.neighbours == b.neighbours &&
           a.regions == b.regions && a.tet_of_vertex == b.tet_of_vertex;
}

/// Fixed vertices are where they were, bit for bit.
inline bool are_fixed_kept(const TetComplex& before, const TetComplex& after) {
    for (std::size_t v = 0; v < before.points.size(); ++v)
        if (before.is_fixed[v] && before.points[v] != after.points[v]) return false;
    return true;
}

}  // namespace featuremesh

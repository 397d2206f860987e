// SPDX-License-Identifier: GPL-3.0-or-later
// Small complexes for the tests of the optimiser.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_measures.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

/// Unit cubes of six tets each, the outside fixed, inner vertices displaced by up to `jitter` (below 0.2 nothing
/// inverts).
inline TetComplex bar_of_tets(const std::array<int, 3>& count, double jitter, unsigned seed) {
    TetComplex bar;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> displace(-jitter, jitter);
    for (int z = 0; z <= count[2]; ++z)
        for (int y = 0; y <= count[1]; ++y)
            for (int x = 0; x <= count[0]; ++x) {
                const bool is_free = x > 0 && x < count[0] && y > 0 && y < count[1] && z > 0 && z < count[2];
                Vec3 p{1.0 * x, 1.0 * y, 1.0 * z};
                if (is_free) p += {displace(random), displace(random), displace(random)};
                bar.points.push_back(p);
                bar.mobility.push_back(is_free ? Mobility::free : Mobility::fixed);
            }
    std::array<int, 3> axes{0, 1, 2};
    const std::array<int, 3> stride{1, count[0] + 1, (count[0] + 1) * (count[1] + 1)};
    do {
        const bool is_even = (axes[1] - axes[0] + 3) % 3 == 1;
        for (int z = 0; z < count[2]; ++z)
            for (int y = 0; y < count[1]; ++y)
                for (int x = 0; x < count[0]; ++x) {
                    const int a = x + stride[1] * y + stride[2] * z;
                    const int b = a + stride[axes[0]], c = b + stride[axes[1]], d = c + stride[axes[2]];
                    bar.tets.push_back(is_even ? Tet{a, b, c, d} : Tet{a, c, b, d});
                }
    } while (std::next_permutation(axes.begin(), axes.end()));
    bar.regions.assign(bar.tets.size(), 0);
    connect(bar);
    return bar;
}

inline TetComplex box_of_tets(int count, double jitter, unsigned seed) {
    return bar_of_tets({count, count, count}, jitter, seed);
}

inline void fix_all(TetComplex& complex) { complex.mobility.assign(complex.points.size(), Mobility::fixed); }

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
    return a.points == b.points && a.mobility == b.mobility && a.tets == b.tets && a.neighbours == b.neighbours &&
           a.regions == b.regions && a.tet_of_vertex == b.tet_of_vertex;
}

/// Fixed vertices are where they were, bit for bit.
inline bool are_fixed_kept(const TetComplex& before, const TetComplex& after) {
    for (std::size_t v = 0; v < before.points.size(); ++v)
        if (before.mobility[v] == Mobility::fixed && before.points[v] != after.points[v]) return false;
    return true;
}

}  // namespace featuremesh

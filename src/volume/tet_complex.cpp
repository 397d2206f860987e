// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/tet_complex.h"

#include <cstdint>
#include <string>

#include "core/errors.h"
#include "volume/tet_topology.h"

namespace featuremesh {

namespace {

/// One side of a triangle, filed under the triangle's smallest vertex.
struct Side {
    std::uint64_t others;  // the two larger vertices
    int tet, face;
};

/// Counting sort of all sides by their smallest vertex; first[v] is where the sides of v begin.
std::vector<Side> sort_sides(const TetComplex& complex, std::vector<std::size_t>& first) {
    first.assign(complex.points.size() + 1, 0);
    for (const Tet& tet : complex.tets) {
        if (tet[0] < 0) continue;
        for (int face = 0; face < 4; ++face) ++first[static_cast<std::size_t>(sorted_face(tet, face)[0]) + 1];
    }
    for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
    std::vector<Side> sides(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (std::size_t t = 0; t < complex.tets.size(); ++t) {
        if (complex.tets[t][0] < 0) continue;
        for (int face = 0; face < 4; ++face) {
            const auto v = sorted_face(complex.tets[t], face);
            sides[next[static_cast<std::size_t>(v[0])]++] = {static_cast<std::uint64_t>(v[1]) << 32 | static_cast<std::uint32_t>(v[2]),
                                                           static_cast<int>(t), face};
        }
    }
    return sides;
}

void link(TetComplex& complex, const Side& a, const Side& b) {
    if (!complex.regions.empty() && complex.regions[a.tet] != complex.regions[b.tet]) return;
    complex.neighbours[a.tet][a.face] = b.tet;
    complex.neighbours[b.tet][b.face] = a.tet;
}

void link_equal_sides(TetComplex& complex, const Side* begin, const Side* end) {
    for (const Side* a = begin; a != end; ++a) {
        const Side* match = nullptr;
        for (const Side* b = a + 1; b != end; ++b) {
            if (a->others != b->others) continue;
            if (match)
                throw MeshError("a triangle of the volume mesh belongs to more than two tets (near tet " +
                                std::to_string(a->tet) + "); try a smaller size there");
            match = b;
        }
        if (match) link(complex, *a, *match);
    }
}

}  // namespace

void connect(TetComplex& complex) {
    complex.neighbours.assign(complex.tets.size(), {-1, -1, -1, -1});
    complex.tet_of_vertex.assign(complex.points.size(), -1);
    std::vector<std::size_t> first;
    const std::vector<Side> sides = sort_sides(complex, first);
    for (std::size_t v = 0; v + 1 < first.size(); ++v)
        link_equal_sides(complex, sides.data() + first[v], sides.data() + first[v + 1]);
    for (std::size_t t = 0; t < complex.tets.size(); ++t)
        for (int v : complex.tets[t])
            if (complex.tets[t][0] >= 0) complex.tet_of_vertex[v] = static_cast<int>(t);
}

}  // namespace featuremesh

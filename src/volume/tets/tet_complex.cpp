// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/tets/tet_complex.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "core/errors.h"
#include "core/messages.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

/// A triangle seen from one tet, filed under the triangle's smallest vertex.
struct HalfFacet {
    std::uint64_t others;  // the two larger vertices
    int tet, face;
};

/// Counting sort of all half-facets by their smallest vertex; first[v] is where those of v begin.
std::vector<HalfFacet> sort_half_facets(const TetComplex& complex, std::vector<std::size_t>& first) {
    first.assign(complex.points.size() + 1, 0);
    for (const Tet& tet : complex.tets) {
        if (tet[0] < 0) continue;
        for (int face = 0; face < 4; ++face) ++first[static_cast<std::size_t>(sorted_face(tet, face)[0]) + 1];
    }
    for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
    std::vector<HalfFacet> half_facets(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (std::size_t t = 0; t < complex.tets.size(); ++t) {
        if (complex.tets[t][0] < 0) continue;
        for (int face = 0; face < 4; ++face) {
            const auto v = sorted_face(complex.tets[t], face);
            half_facets[next[static_cast<std::size_t>(v[0])]++] = {
                static_cast<std::uint64_t>(v[1]) << 32 | static_cast<std::uint32_t>(v[2]), static_cast<int>(t), face};
        }
    }
    return half_facets;
}

void link(TetComplex& complex, const HalfFacet& a, const HalfFacet& b) {
    if (!complex.regions.empty() && complex.regions[a.tet] != complex.regions[b.tet]) return;
    complex.neighbours[a.tet][a.face] = b.tet;
    complex.neighbours[b.tet][b.face] = a.tet;
}

void link_equal(TetComplex& complex, const HalfFacet* begin, const HalfFacet* end) {
    for (const HalfFacet* a = begin; a != end; ++a) {
        const HalfFacet* match = nullptr;
        for (const HalfFacet* b = a + 1; b != end; ++b) {
            if (a->others != b->others) continue;
            if (match) throw MeshError(say<Code::triangle_of_many_tets>(a->tet));
            match = b;
        }
        if (match) link(complex, *a, *match);
    }
}

class FlawFinder {
  public:
    explicit FlawFinder(const TetComplex& complex) : complex_(complex) {}

    std::vector<std::string> run() {
        for (std::size_t t = 0; t < complex_.tets.size() && flaws_.size() < 10; ++t)
            if (complex_.tets[t][0] >= 0) check_tet(static_cast<int>(t));
        for (std::size_t v = 0; v < complex_.tet_of_vertex.size() && flaws_.size() < 10; ++v) check_vertex(v);
        return flaws_;
    }

  private:
    void report(int tet, const char* what) { flaws_.push_back("tet " + std::to_string(tet) + ": " + what); }

    void check_tet(int tet) {
        const Tet& v = complex_.tets[tet];
        const auto& p = complex_.points;
        if (!(signed_volume(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) > 0)) report(tet, "no positive volume");
        for (int corner : v)
            if (complex_.tet_of_vertex[corner] < 0) report(tet, "a corner has no tet_of_vertex");
        for (int face = 0; face < 4; ++face)
            if (complex_.neighbours[tet][face] >= 0) check_neighbour(tet, face, complex_.neighbours[tet][face]);
    }

    void check_neighbour(int tet, int face, int next) {
        if (complex_.tets[next][0] < 0) return report(tet, "a neighbour was removed");
        const auto& back = complex_.neighbours[next];
        int from = 0;
        while (from < 4 && back[from] != tet) ++from;
        if (from == 4) return report(tet, "a neighbour does not know it");
        if (sorted_face(complex_.tets[tet], face) != sorted_face(complex_.tets[next], from))
            report(tet, "shares another triangle with its neighbour");
        if (!complex_.regions.empty() && complex_.regions[tet] != complex_.regions[next])
            report(tet, "is linked to another region");
    }

    void check_vertex(std::size_t vertex) {
        const int tet = complex_.tet_of_vertex[vertex];
        if (tet < 0) return;
        const Tet& v = complex_.tets[tet];
        if (std::find(v.begin(), v.end(), static_cast<int>(vertex)) == v.end())
            report(tet, "is not a tet of the vertex that names it");
    }

    const TetComplex& complex_;
    std::vector<std::string> flaws_;
};

}  // namespace

std::vector<std::string> find_flaws(const TetComplex& complex) { return FlawFinder(complex).run(); }

void connect(TetComplex& complex) {
    complex.neighbours.assign(complex.tets.size(), {-1, -1, -1, -1});
    complex.tet_of_vertex.assign(complex.points.size(), -1);
    std::vector<std::size_t> first;
    const std::vector<HalfFacet> half_facets = sort_half_facets(complex, first);
    for (std::size_t v = 0; v + 1 < first.size(); ++v)
        link_equal(complex, half_facets.data() + first[v], half_facets.data() + first[v + 1]);
    for (std::size_t t = 0; t < complex.tets.size(); ++t)
        for (int v : complex.tets[t])
            if (complex.tets[t][0] >= 0) complex.tet_of_vertex[v] = static_cast<int>(t);
}

}  // namespace featuremesh

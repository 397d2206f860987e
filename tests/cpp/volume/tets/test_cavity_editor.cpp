// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <set>

#include "catch.h"
#include "volume/tets/box_of_tets.h"
#include "volume/tets/cavity_editor.h"

using namespace featuremesh;

namespace {

bool has(const Tet& tet, int vertex) { return std::find(tet.begin(), tet.end(), vertex) != tet.end(); }

std::set<std::set<int>> tets_by_vertices(const TetComplex& complex) {
    std::set<std::set<int>> result;
    for (const Tet& tet : complex.tets)
        if (tet[0] >= 0) result.insert(std::set<int>(tet.begin(), tet.end()));
    return result;
}

}  // namespace

TEST_CASE("the star of an inner vertex is all its tets, a boundary vertex has none") {
    TetComplex box = box_of_tets(3, 0.1, 3);
    std::vector<int> star;
    for (int v = 0; v < static_cast<int>(box.points.size()); ++v) {
        const bool is_inside = gather_star(box, v, star);
        REQUIRE(is_inside == box.is_free(static_cast<int>(v)));
        if (!is_inside) continue;
        const auto count = std::count_if(box.tets.begin(), box.tets.end(), [&](const Tet& t) { return has(t, v); });
        REQUIRE(static_cast<long>(star.size()) == count);
        REQUIRE(std::set<int>(star.begin(), star.end()).size() == star.size());
        for (int tet : star) REQUIRE(has(box.tets[tet], v));
    }
}

TEST_CASE("the ring of an inner edge is all its tets in order, with their orientation") {
    const TetComplex box = box_of_tets(3, 0.1, 4);
    int inner = 0;
    for (int t = 0; t < static_cast<int>(box.tets.size()); ++t)
        for (const auto& [i, j] : edge_corners) {
            EdgeRing ring;
            const int a = box.tets[t][i], b = box.tets[t][j];
            const bool is_found = find_ring(box, t, i, j, ring);
            const bool is_inner = box.is_free(static_cast<int>(a)) || box.is_free(static_cast<int>(b));
            REQUIRE((is_found || !is_inner));
            if (!is_found) continue;
            ++inner;
            REQUIRE(ring.size == std::count_if(box.tets.begin(), box.tets.end(),
                                               [&](const Tet& v) { return has(v, a) && has(v, b); }));
            for (int k = 0; k < ring.size; ++k) {
                const Tet wanted{a, b, ring.vertices[k], ring.vertices[(k + 1) % ring.size]};
                REQUIRE(volume_of(box, wanted) == Approx(volume_of(box, box.tets[ring.tets[k]])));
            }
        }
    CHECK(inner > 100);
}

TEST_CASE("the star of a hub with very many tets is complete") {
    // the cone over an octahedron's sphere, split three times: 8 * 4^3 triangles
    TetComplex hub;
    hub.points = {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<std::array<int, 3>> triangles{{1, 3, 5}, {3, 2, 5}, {2, 4, 5}, {4, 1, 5},
                                              {3, 1, 6}, {2, 3, 6}, {4, 2, 6}, {1, 4, 6}};
    for (int level = 0; level < 3; ++level) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(hub.points.size()));
            if (is_new) hub.points.push_back(normalized(hub.points[a] + hub.points[b]));
            return at->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : triangles) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = finer;
    }
    for (const auto& [a, b, c] : triangles) hub.tets.push_back({0, a, b, c});
    hub.mobility.assign(hub.points.size(), Mobility::free);
    connect(hub);
    REQUIRE(find_flaws(hub).empty());
    std::vector<int> star;
    CHECK(gather_star(hub, 0, star));
    std::sort(star.begin(), star.end());
    star.erase(std::unique(star.begin(), star.end()), star.end());
    CHECK(star.size() == 512);
    CHECK_FALSE(gather_star(hub, 1, star));
}

TEST_CASE("replacing a cavity keeps the complex sound, and undoing it gives the old tets") {
    TetComplex box = box_of_tets(2, 0.1, 5);
    const auto before = tets_by_vertices(box);
    const auto outside = outside_of(box);
    CavityEditor editor(box);
    const int center = editor.add_vertex({1.2, 0.9, 1.1});
    std::vector<int> all(box.tets.size());
    for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<int>(t);
    std::vector<Tet> old = box.tets, cone;
    for (const Tet& tet : box.tets)
        for (int face = 0; face < 4; ++face) {
            Tet spoke{center, tet[opposite_face[face][0]], tet[opposite_face[face][1]], tet[opposite_face[face][2]]};
            if (outside.count(sorted_face(spoke, 0))) cone.push_back(spoke);
        }
    const auto added = editor.replace(all, cone);
    const std::vector<int> ids(added.begin(), added.end());
    CHECK(ids.size() == cone.size());
    CHECK(find_flaws(box).empty());
    CHECK(outside_of(box) == outside);
    CHECK(box.tet_of_vertex[13] == -1);
    std::vector<int> star;
    CHECK(gather_star(box, center, star));
    CHECK(star.size() == cone.size());
    editor.replace(ids, old);
    CHECK(find_flaws(box).empty());
    CHECK(tets_by_vertices(box) == before);
    CHECK(box.tet_of_vertex[center] == -1);
    CHECK(std::count(box.regions.begin(), box.regions.end(), 0) == static_cast<long>(box.regions.size()));
}

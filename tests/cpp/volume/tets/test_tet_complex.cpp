// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "catch.h"
#include "core/errors.h"
#include "volume/tets/box_of_tets.h"

using namespace featuremesh;

TEST_CASE("connect finds the tets that share a triangle") {
    const TetComplex box = box_of_tets(3, 0.1, 1);
    CHECK(find_flaws(box).empty());
    std::map<std::array<int, 3>, int> uses;
    for (const Tet& tet : box.tets)
        for (int face = 0; face < 4; ++face) ++uses[sorted_face(tet, face)];
    for (std::size_t t = 0; t < box.tets.size(); ++t)
        for (int face = 0; face < 4; ++face)
            REQUIRE((box.neighbours[t][face] >= 0) == (uses[sorted_face(box.tets[t], face)] == 2));
    CHECK(outside_of(box).size() == 6 * 9 * 2);
}

TEST_CASE("a triangle between two regions is boundary on both sides") {
    TetComplex box = box_of_tets(2, 0, 1);
    const std::size_t outside = outside_of(box).size();
    for (std::size_t t = 0; t < box.tets.size(); ++t)
        for (int v : box.tets[t])
            if (box.points[v].x > 1) box.regions[t] = 1;
    connect(box);
    CHECK(find_flaws(box).empty());
    CHECK(outside_of(box).size() == outside + 8);
}

TEST_CASE("removed tets have no neighbours and a vertex without tets is told so") {
    TetComplex box = box_of_tets(1, 0, 1);
    for (Tet& tet : box.tets)
        if (std::find(tet.begin(), tet.end(), 1) != tet.end()) tet = {-1, -1, -1, -1};
    connect(box);
    CHECK(find_flaws(box).empty());
    CHECK(box.tet_of_vertex[1] == -1);
    CHECK(box.tet_of_vertex[0] >= 0);
}

TEST_CASE("a triangle with three tets is refused") {
    TetComplex fan;
    fan.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}};
    fan.tets = {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}};
    CHECK_THROWS_AS(connect(fan), MeshError);
}

TEST_CASE("find_flaws sees what is broken") {
    const TetComplex good = box_of_tets(2, 0, 1);
    TetComplex bad = good;
    std::swap(bad.tets[0][0], bad.tets[0][1]);
    CHECK_FALSE(find_flaws(bad).empty());
    bad = good;
    bad.neighbours[0] = {-1, -1, -1, -1};
    CHECK_FALSE(find_flaws(bad).empty());
    bad = good;
    bad.regions[0] = 5;
    CHECK_FALSE(find_flaws(bad).empty());
    bad = good;
    bad.tet_of_vertex[bad.tets[0][0]] = bad.tet_of_vertex.back();
    CHECK_FALSE(find_flaws(bad).empty());
}

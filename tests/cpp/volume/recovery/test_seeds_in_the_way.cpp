// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/seeds_in_the_way.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <algorithm>
#include <random>

#include "catch.h"
#include "volume/filled_parts.h"
#include "volume/recovery/flip_facets.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// A plate of so many squares with a boss in every third and holes in the others. The bosses' lower edges are one side
/// of a triangle each, whose third corner is near: seeds in the plate are in all their balls.
TopoDS_Shape plate_with_bosses(int columns, int rows) {
    TopoDS_Shape plate = box_part({0, 0, 0}, {10.0 * columns, 10.0 * rows, 5});
    for (int i = 0; i < columns * rows; ++i) {
        const double x = 10 * (i % columns) + 5, y = 10 * (i / columns) + 5;
        if (i % columns % 3 == 0)
            plate = BRepAlgoAPI_Fuse(plate, box_part({x - 2, y - 2, 5}, {4, 4, 6})).Shape();
        else
            plate =
                BRepAlgoAPI_Cut(plate, BRepPrimAPI_MakeCylinder(gp_Ax2({x, y, 0}, {0, 0, 1}), 2.5, 5).Shape()).Shape();
    }
    return plate;
}

/// A filling of these points by Delaunay, in which all facets are looked for.
CavityFill delaunay_of(const Cavity& cavity, std::vector<Vec3> points, RunContext& context) {
    Triangulation triangulation = delaunay(points, context);
    return label_cavity(cavity, std::move(points), std::move(triangulation), context);
}

/// The tets by their corners alone.
std::vector<std::array<int, 4>> sorted_tets(const Triangulation& triangulation) {
    std::vector<std::array<int, 4>> tets = triangulation.tets;
    for (auto& tet : tets) std::sort(tet.begin(), tet.end());
    std::sort(tets.begin(), tets.end());
    return tets;
}

std::vector<Vec3> random_points(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(0, 10);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.push_back({coordinate(random), coordinate(random), coordinate(random)});
    return points;
}

/// A facet across the middle of eight corners far away, and these points beside it.
struct Crowd {
    Cavity cavity;
    std::vector<Vec3> points;

    explicit Crowd(const std::vector<Vec3>& own, const std::vector<Vec3>& seeds) {
        cavity.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
        for (int k = 0; k < 8; ++k)
            cavity.points.push_back({k & 1 ? 21.0 : -20.0, k & 2 ? 22.0 : -20.0, k & 4 ? 23.0 : -20.0});
        cavity.points.insert(cavity.points.end(), own.begin(), own.end());
        cavity.facets = {{{0, 1, 2}, {0, 0}}};
        points = cavity.points;
        points.insert(points.end(), seeds.begin(), seeds.end());
    }
    std::vector<Vec3> named() const {
        RunContext context;
        const CavityFill fill = delaunay_of(cavity, points, context);
        REQUIRE(fill.places.missing == std::vector<int>{0});
        std::vector<Vec3> found;
        for (const int i : seeds_in_the_way(cavity, fill, fill.places.missing)) found.push_back(fill.points[i]);
        return found;
    }
};

}  // namespace

TEST_CASE("the Delaunay triangulation without some points is that of the others") {
    const unsigned seed = GENERATE(1u, 2u, 3u);
    INFO("seed " << seed);
    RunContext context;
    const Cavity nothing;
    const CavityFill fill = delaunay_of(nothing, random_points(400, seed), context);
    const std::vector<int> dropped{17, 18, 90, 200, 201, 202, 399};
    std::vector<Vec3> others;
    for (int i = 0; i < static_cast<int>(fill.points.size()); ++i)
        if (!std::binary_search(dropped.begin(), dropped.end(), i)) others.push_back(fill.points[i]);
    const auto without = triangulation_without(dropped, nothing, fill, context);
    REQUIRE(without);
    CHECK(sorted_tets(*without) == sorted_tets(delaunay(others, context)));
    for (std::size_t i = 0; i < without->tets.size(); ++i)
        for (int k = 0; k < 4; ++k)
            if (const int other = without->neighbours[i][k]; other >= 0)
                CHECK(std::count(without->neighbours[other].begin(), without->neighbours[other].end(),
                                 static_cast<int>(i)) == 1);
}

TEST_CASE("seeds are named that are in every ball of a missing facet") {
    const Vec3 above{1, 1, 0.3}, below{0.9, 1, -0.3}, far{1, 1, 5};
    SECTION("one at either side") { CHECK(Crowd({}, {above, below, far}).named() == std::vector<Vec3>{above, below}); }
    SECTION("none where a point of the boundary is in every ball, too") {
        CHECK(Crowd({below}, {above, far}).named().empty());
    }
    SECTION("only the seed where a point of the boundary is in some balls") {
        CHECK(Crowd({{1, 1, -1.2}}, {{1, 1, 1.9}, {1, 1, 0.3}}).named() == std::vector<Vec3>{{1, 1, 0.3}});
    }
    SECTION("none where they are many") {
        CHECK(Crowd({}, {above, {0.9, 1, 0.35}, {1, 0.8, 0.4}, below}).named().empty());
    }
}

TEST_CASE("a plate with bosses is filled without points of the recovery") {
    const Part part = prepare(plate_with_bosses(6, 2), 4.0);
    RunContext context;
    const Cavity cavity = find_cavity(part.surface, part.brep.solids_beside_faces());
    const CavityFill at_first = fill_cavity(cavity, {}, {}, wanted_size(part.sizing, part.surface), context);
    std::vector<int> missing = at_first.places.missing;
    for (const auto& piece : flip_missing(cavity, at_first, part.surface).pieces) std::erase(missing, piece.facet);
    REQUIRE_FALSE(seeds_in_the_way(cavity, at_first, missing).empty());
    const VolumeResult filled = fill(part);
    CHECK(filled.report.recovered_triangles > 0);
    CHECK(filled.report.recovery_points == 0);
    CHECK(findings(part.brep, filled.mesh).empty());
    CHECK(are_same_bytes(filled.mesh, fill(part, 2).mesh));
}

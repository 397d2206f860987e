// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>

#include "catch.h"
#include "volume/fill_cavity.h"
#include "volume/filled_parts.h"
#include "volume/recovery/flip_recovery.h"
#include "volume/recovery/local_recovery.h"
#include "volume/recovery/stray_pieces.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

struct Filled {
    Part part;
    Cavity cavity;
    CavityFill fill;
};

Filled delaunay_fill(const TopoDS_Shape& shape, double size) {
    SizingOptions options;
    options.size = options.min_size = size;  // or the bottom of a slot would get shorter pieces
    Part part = prepare(shape, options);
    Cavity cavity = find_cavity(part.surface, part.brep.solids_beside_faces());
    const WantedSize wanted{[size](const Vec3&) { return size; }, size, true};
    RunContext context;
    CavityFill fill = fill_cavity(cavity, {}, {}, wanted, context);
    return {std::move(part), std::move(cavity), std::move(fill)};
}

/// The cavity with its cut facets replaced by their pieces, added points after its own.
Cavity cut_cavity(const Cavity& cavity, const FacetSplit& split) {
    Cavity cut;
    cut.points = cavity.points;
    for (const auto& added : split.added) cut.points.push_back(added.point);
    std::vector<bool> is_cut(cavity.facets.size(), false);
    for (const auto& piece : split.pieces) {
        is_cut[piece.facet] = true;
        cut.facets.push_back({piece.corners, cavity.facets[piece.facet].regions});
    }
    for (std::size_t i = 0; i < cavity.facets.size(); ++i)
        if (!is_cut[i]) cut.facets.push_back(cavity.facets[i]);
    return cut;
}

void check_recovered(const Filled& filled, const ConstrainedTriangulation& recovered) {
    REQUIRE(recovered.failed.empty());
    const Cavity cut = cut_cavity(filled.cavity, recovered.split);
    std::vector<Vec3> points = cut.points;
    points.insert(points.end(), filled.fill.points.begin() + static_cast<std::ptrdiff_t>(filled.cavity.points.size()),
                  filled.fill.points.end());
    const Triangulation& t = recovered.triangulation;
    for (std::size_t i = 0; i < t.tets.size(); ++i)
        for (int k = 0; k < 4; ++k)
            if (const int other = t.neighbours[i][k]; other >= 0)
                CHECK(std::count(t.neighbours[other].begin(), t.neighbours[other].end(), static_cast<int>(i)) == 1);
    RunContext context;
    const CavityFill again = label_cavity(cut, points, t, context);
    REQUIRE(again.is_complete());
    double volume = 0;
    for (std::size_t i = 0; i < t.tets.size(); ++i)
        if (again.regions[i] >= 0)
            volume +=
                signed_volume(points[t.tets[i][0]], points[t.tets[i][1]], points[t.tets[i][2]], points[t.tets[i][3]]);
    CHECK(volume == Approx(filled.part.brep.volume_of(SolidId(std::size_t{0}))).epsilon(1e-9));
}

}  // namespace

TEST_CASE("missing triangles come back by constraint, in the whole cavity and around them alike") {
    const Filled filled = delaunay_fill(slotted_block(), 2.0);
    REQUIRE(!filled.fill.places.missing.empty());
    const std::vector<Vec3> seeds(filled.fill.points.begin() + static_cast<std::ptrdiff_t>(filled.cavity.points.size()),
                                  filled.fill.points.end());
    check_recovered(filled, constrained_delaunay(filled.cavity, seeds, 0));
    const auto local = recover_locally(filled.cavity, filled.fill);
    REQUIRE(local.has_value());
    check_recovered(filled, *local);
}

TEST_CASE("flips bring all missing triangles back and add no point") {
    const auto [name, shape, expected] = GENERATE(table<std::string, TopoDS_Shape, double>(
        {{"walls and slits of 0.05", comb_part(6, 0.05), 1800 - 0.05 * 3 * 66},
         {"in a skew place", turned(comb_part(6, 0.05), 0.4, {3, 4, 5}), 1800 - 0.05 * 3 * 66},
         {"sides that stand in one another's way", comb_part(10, 0.03), 1800 - 0.03 * 3 * 109},
         {"planes that rounding bends", turned(comb_part(5, 0.03), 0.7, {3, 4, 5}), 1800 - 0.03 * 3 * 54}}));
    INFO(name);
    const Filled filled = delaunay_fill(shape, 4.0);
    REQUIRE(filled.fill.places.missing.size() > 50);
    RunContext context;
    const auto [flipped, left] = recover_by_flips(filled.cavity, filled.fill, context);
    REQUIRE(flipped);
    CHECK(left.empty());
    for (std::size_t i = 0; i < flipped->tets.size(); ++i) {
        const auto& [a, b, c, d] = flipped->tets[i];
        const auto& p = filled.fill.points;
        CHECK(signed_volume(p[a], p[b], p[c], p[d]) > -1e-12);
        for (const int other : flipped->neighbours[i])
            if (other >= 0)
                CHECK(std::count(flipped->neighbours[other].begin(), flipped->neighbours[other].end(),
                                 static_cast<int>(i)) == 1);
    }
    const CavityFill again = label_cavity(filled.cavity, filled.fill.points, *flipped, context);
    CHECK(again.is_complete());
    double volume = 0;
    for (std::size_t i = 0; i < again.regions.size(); ++i)
        if (again.regions[i] >= 0) {
            const auto& [a, b, c, d] = again.triangulation.tets[i];
            volume += signed_volume(again.points[a], again.points[b], again.points[c], again.points[d]);
        }
    CHECK(volume == Approx(expected).epsilon(1e-9));
}

TEST_CASE("flips give up a triangle that others cut") {
    const Filled filled = delaunay_fill(comb_part(6, 0.05), 4.0);
    CavityFill impossible = filled.fill;
    Cavity cavity = filled.cavity;
    // a triangle through the whole part, from corner to corner, which the walls' own triangles cut
    int far = 0, near = 0;
    for (int i = 0; i < static_cast<int>(cavity.points.size()); ++i) {
        const auto key = [&](int n) { return cavity.points[n].x + cavity.points[n].y; };
        if (key(i) > key(far)) far = i;
        if (key(i) < key(near)) near = i;
    }
    int other = 0;
    while (other == far || other == near) ++other;
    impossible.places.missing.push_back(static_cast<int>(cavity.facets.size()));
    cavity.facets.push_back({{near, far, other}, {0, 0}});
    RunContext context;
    const auto [flipped, left] = recover_by_flips(cavity, impossible, context);
    CHECK_FALSE(flipped);
    CHECK(left == std::vector<int>{static_cast<int>(cavity.facets.size()) - 1});
}

TEST_CASE("of the pieces of a facet those that lie over others go") {
    // a square of two facets; points are added on the diagonal, on the first one's side along x, and inside the first
    Cavity cavity;
    cavity.points = {{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {6, 6, 0}};
    cavity.facets = {{{0, 1, 2}, {0, -1}}, {{1, 3, 2}, {0, -1}}};
    FacetSplit split;
    split.added = {{{3, 3, 0}, {1, 2}, -1}, {{3, 0, 0}, {0, 1}, -1}, {{2, 2, 0}, {-1, -1}, 0}};
    const std::vector<FacetSplit::Piece> first{
        {{0, 5, 6}, 0}, {{5, 1, 6}, 0}, {{1, 4, 6}, 0}, {{4, 2, 6}, 0}, {{2, 0, 6}, 0}};
    const std::vector<FacetSplit::Piece> second{{{1, 3, 4}, 1}, {{4, 3, 2}, 1}};
    split.pieces = first;
    SECTION("none lies over another") {}
    SECTION("one spans a point that was added") { split.pieces.push_back({{0, 1, 6}, 0}); }
    SECTION("one that hangs on another") { split.pieces.push_back({{1, 2, 5}, 0}); }
    split.pieces.insert(split.pieces.end(), second.begin(), second.end());
    CHECK(drop_stray_pieces(cavity, split).empty());
    std::vector<FacetSplit::Piece> all = first;
    all.insert(all.end(), second.begin(), second.end());
    CHECK(std::equal(split.pieces.begin(), split.pieces.end(), all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.facet == b.facet && a.corners == b.corners; }));
    split.pieces.erase(split.pieces.begin() + 1);
    CHECK(drop_stray_pieces(cavity, split) == std::vector<int>{0});
}

TEST_CASE("a facet without a normal is left to its neighbours, and the library writes no file about it") {
    Cavity cavity;
    cavity.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {2, 0, 0}};
    cavity.facets = {{{0, 2, 1}, {0, -1}}, {{1, 2, 3}, {0, -1}}, {{0, 3, 2}, {0, -1}},
                     {{0, 4, 3}, {0, -1}}, {{4, 1, 3}, {0, -1}}, {{0, 1, 4}, {0, -1}}};
    const auto files = [] {
        const std::filesystem::directory_iterator here(std::filesystem::current_path());
        return std::distance(begin(here), end(here));
    };
    const auto before = files();
    const ConstrainedTriangulation recovered = constrained_delaunay(cavity, {}, 0);
    CHECK(files() == before);
    CHECK(recovered.failed.empty());
    CHECK(recovered.split.added.empty());
    CHECK(recovered.triangulation.tets.size() == 2);
}

TEST_CASE("facets that cross others are found, and those that only meet are not") {
    Cavity cavity;
    cavity.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {1, 1, -1}, {1, 1, 1}, {5, 5, 1}};
    cavity.facets = {{{0, 1, 2}, {0, -1}}, {{1, 3, 2}, {0, -1}}};
    CHECK(crossing_facets(cavity).empty());
    cavity.facets.push_back({{4, 5, 6}, {0, -1}});
    CHECK(crossing_facets(cavity) == std::vector<int>{0, 1, 2});
    CHECK(crossing_facets(cavity, std::vector<int>{2}) == std::vector<int>{0, 1, 2});
    CHECK(crossing_facets(cavity, std::vector<int>{}).empty());
}

TEST_CASE("halving cuts every facet around an edge and keeps area and turn") {
    const Filled filled = delaunay_fill(box_part({0, 0, 0}, {6, 6, 6}), 3.0);
    const std::vector<int> some{0, 5, 9};
    const FacetSplit split = halve_longest_edges(filled.cavity, some);
    CHECK(!split.added.empty());
    const Cavity cut = cut_cavity(filled.cavity, split);
    CHECK(open_facets(cut).empty());
    double volume = 0;
    for (const Facet& f : cut.facets) {
        const double part =
            dot(cut.points[f.corners[0]], cross(cut.points[f.corners[1]], cut.points[f.corners[2]])) / 6;
        volume += f.regions[0] >= 0 ? part : -part;
    }
    CHECK(volume == Approx(216.0));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <tuple>

#include "catch.h"
#include "core/distances.h"
#include "core/errors.h"
#include "mesh/box_mesh.h"
#include "volume/cavity.h"
#include "volume/delaunay/lattice_seeds.h"
#include "volume/delaunay/region_locator.h"
#include "volume/delaunay/triangulation.h"

using namespace featuremesh;

namespace {

Cavity box_boundary(int n, double scale) {
    Mesh mesh = box_mesh(n);
    for (Vec3& p : mesh.points) p *= scale;
    return find_cavity(mesh, std::vector<std::array<SolidId, 2>>(6, {SolidId(std::size_t{0}), SolidId()}),
                       std::vector<std::uint8_t>(mesh.tets.size(), 1));
}

double distance_to_facets(const Cavity& cavity, const Vec3& p) {
    double nearest = 1e300;
    for (const Facet& f : cavity.facets)
        nearest =
            std::min(nearest, squared_distance_to_triangle(p, cavity.points[f.corners[0]], cavity.points[f.corners[1]],
                                                           cavity.points[f.corners[2]]));
    return std::sqrt(nearest);
}

WantedSize uniform(double size) {
    return {[size](const Vec3&) { return size; }, size, true};
}

bool is_in_box(const Vec3& p, double scale) { return Box{{0, 0, 0}, {scale, scale, scale}}.contains(p); }

}  // namespace

TEST_CASE("seeds are inside, clear of the facets and of balls") {
    const Cavity cavity = box_boundary(8, 12);
    const std::vector<Ball> balls{{{6, 6, 6}, 2.5}};
    const RunContext context;
    const SeedOptions options;
    const auto seeds = SeedSpace(cavity.points, cavity.facets, balls, uniform(1.5), options, context).seeds({}).points;
    CHECK(seeds.size() > 200);
    for (const Vec3& p : seeds) {
        CHECK(is_in_box(p, 12));
        CHECK(distance_to_facets(cavity, p) > options.clearance * 1.5 - 1e-5);
        CHECK(distance(p, balls[0].center) > balls[0].radius - 1e-5);
    }
}

TEST_CASE("active points without room leave the lattice as it is") {
    const Cavity cavity = box_boundary(8, 12);
    const RunContext context;
    const auto seeds_with = [&](std::span<const Vec3> active) {
        return SeedSpace(cavity.points, cavity.facets, {}, uniform(1.5), {}, context).seeds(active).points;
    };
    std::vector<Vec3> on_boundary;
    for (const double x : {11.9, 6.1, 0.1})
        for (const double y : {11.9, 0.1})
            for (const double z : {11.9, 0.1}) on_boundary.push_back({x, y, z});
    CHECK(seeds_with(on_boundary) == seeds_with({}));
}

TEST_CASE("the lattice is anchored: another box around gives the same points inside") {
    const RunContext context;
    const Cavity small = box_boundary(6, 9), large = box_boundary(12, 18);
    const auto few = SeedSpace(small.points, small.facets, {}, uniform(1.5), {}, context).seeds({}).points;
    auto many = SeedSpace(large.points, large.facets, {}, uniform(1.5), {}, context).seeds({}).points;
    const auto before = [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
    std::sort(many.begin(), many.end(), before);
    REQUIRE(!few.empty());
    for (const Vec3& p : few) CHECK(std::binary_search(many.begin(), many.end(), p, before));
}

TEST_CASE("graded seeds are as dense as the sizes ask") {
    const Cavity cavity = box_boundary(10, 10);
    const WantedSize graded{[](const Vec3& p) { return 0.4 + 0.16 * p.x; }, 2.0, false};
    const RunContext context;
    const auto seeds = SeedSpace(cavity.points, cavity.facets, {}, graded, {}, context).seeds({}).points;
    for (const double x : {1.0, 2.0, 4.0, 7.0}) {
        const auto count = std::count_if(seeds.begin(), seeds.end(), [&](const Vec3& p) {
            return std::abs(p.x - x) < 0.5 && p.y > 2 && p.y < 8 && p.z > 2 && p.z < 8;
        });
        const double constant = lattice_constant(graded.at({x, 5, 5}));
        const double expected = 2 * 36 / (constant * constant * constant);  // two points a cube
        CHECK(static_cast<double>(count) > expected / 3.2);
        CHECK(static_cast<double>(count) < expected * 3.2);
    }
}

TEST_CASE("active points need room") {
    const Cavity cavity = box_boundary(8, 12);
    const RunContext context;
    const std::vector<Vec3> active{{5, 5, 5}, {5.1, 5, 5}, {-1, 5, 5}, {0.2, 5, 5}, {8, 8, 8}};
    const auto seeds = SeedSpace(cavity.points, cavity.facets, {}, uniform(1.5), {}, context).seeds(active).points;
    REQUIRE(seeds.size() > 2);
    CHECK(seeds[0] == active[0]);
    CHECK(seeds[1] == active[4]);
    for (std::size_t i = 2; i < seeds.size(); ++i) {
        CHECK(distance(seeds[i], active[0]) > 0.7 * 1.5 - 1e-5);
        CHECK(distance(seeds[i], active[4]) > 0.7 * 1.5 - 1e-5);
    }
}

TEST_CASE("points keep the distance that the size wants where they are, small sizes beside large ones") {
    const Cavity cavity = box_boundary(8, 12);
    const WantedSize graded{[](const Vec3& p) { return 0.02 + 0.15 * std::abs(p.x - 6); }, 0.92, false};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(2, 10);
    std::vector<Vec3> candidates, expected;
    for (int i = 0; i < 3000; ++i)
        candidates.push_back({6 + (i % 2 == 0 ? 0.02 : 1) * (place(random) - 6), place(random), place(random)});
    constexpr double spacing = 0.7;
    for (const Vec3& p : candidates)
        if (std::none_of(expected.begin(), expected.end(),
                         [&](const Vec3& q) { return distance(p, q) < spacing * graded.at(p); }))
            expected.push_back(p);
    REQUIRE(expected.size() < candidates.size());
    const RunContext context;
    SeedSpace space(cavity.points, cavity.facets, {}, graded, {}, context);
    CHECK(space.with_room(candidates, {.clearance = 0.5, .spacing = spacing}) == expected);
}

TEST_CASE(
    "a point that comes closer than the lattice stays out of the balls around the facets where they are to be spared") {
    const Cavity cavity = box_boundary(8, 12);  // right-angled facets, their sides 1.5, the balls' radius 1.06
    const RunContext context;
    SeedSpace space(cavity.points, cavity.facets, {}, uniform(1.5), {}, context);
    const std::vector<Vec3> above_corner{{6, 6, 0.9}}, above_middle{{6.75, 6.75, 0.9}}, beyond{{6.75, 6.75, 1.1}};
    SeedOptions closer{.clearance = 0.5, .spacing = 0.5};
    CHECK(space.with_room(above_middle, closer) == above_middle);
    closer.spares_facets = true;
    CHECK(space.with_room(above_corner, closer) == above_corner);
    CHECK(space.with_room(above_middle, closer).empty());
    CHECK(space.with_room(beyond, closer) == beyond);
}

TEST_CASE("the region of a point is found, rays through edges and corners included") {
    const Cavity cavity = box_boundary(4, 4);
    const RegionLocator locator(cavity.points, cavity.facets);
    for (int i = -2; i <= 12; ++i)
        for (int j = -2; j <= 12; ++j)
            for (int k = -2; k <= 12; ++k) {
                const Vec3 p{0.5 * i + 0.25 * (i % 2), 0.5 * j, 0.5 * k};
                if (distance_to_facets(cavity, p) < 1e-9) continue;
                CHECK(locator.region_at(p, 0.01) == (is_in_box(p, 4) ? 0 : -1));
            }
}

TEST_CASE("Delaunay: no point inside a circumsphere, volumes add up, neighbours agree") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Vec3> points;
    for (int i = 0; i < 60; ++i) points.push_back({unit(random), unit(random), unit(random)});
    RunContext context;
    const Triangulation t = delaunay(points, context);
    for (std::size_t i = 0; i < t.tets.size(); ++i) {
        const auto& v = t.tets[i];
        CHECK(signed_volume(points[v[0]], points[v[1]], points[v[2]], points[v[3]]) > 0);
        const Ball ball = circumsphere(points[v[0]], points[v[1]], points[v[2]], points[v[3]]);
        for (const Vec3& p : points) CHECK(distance(p, ball.center) > ball.radius * (1 - 1e-9));
        for (int k = 0; k < 4; ++k)
            if (const int other = t.neighbours[i][k]; other >= 0)
                CHECK(std::count(t.neighbours[other].begin(), t.neighbours[other].end(), static_cast<int>(i)) == 1);
    }
    points.push_back(points.front());
    CHECK_THROWS_AS(delaunay(points, context), MeshError);
}

TEST_CASE("a triangulation that points are added to is that of all of them") {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Vec3> points;
    for (int i = 0; i < 60; ++i) points.push_back({unit(random), unit(random), unit(random)});
    RunContext context;
    GrowingDelaunay growing;
    growing.insert(std::span(points).first(50), context);
    growing.insert(std::span(points).subspan(50), context);
    const auto sorted = [](std::vector<std::array<int, 4>> tets) {
        for (auto& tet : tets) std::sort(tet.begin(), tet.end());
        std::sort(tets.begin(), tets.end());
        return tets;
    };
    CHECK(sorted(growing.tets(context).tets) == sorted(delaunay(points, context).tets));
    std::vector<int> reversed(points.size());
    std::iota(reversed.rbegin(), reversed.rend(), 0);
    std::vector<Vec3> other_way(points.rbegin(), points.rend());
    CHECK(sorted(growing.tets(context, reversed).tets) == sorted(delaunay(other_way, context).tets));
}

TEST_CASE("labels stay within closed facets, and a leak is seen") {
    std::vector<Vec3> points{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<Facet> facets;
    for (int k = 0; k < 4; ++k) {
        facets.push_back({{k, (k + 1) % 4, 4}, {0, -1}});
        facets.push_back({{k, (k + 1) % 4, 5}, {-1, 0}});
    }
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-0.2, 0.2);
    for (int i = 0; i < 30; ++i) points.push_back({unit(random), unit(random), unit(random)});
    for (const Vec3& corner : {Vec3{-30, -30, -30}, Vec3{60, -30, -30}, Vec3{-30, 60, -30}, Vec3{-30, -30, 80}})
        points.push_back(corner);
    RunContext context;
    const Triangulation t = delaunay(points, context);
    const FacetPlaces all = find_facets(t, points.size(), facets);
    REQUIRE(all.missing.empty());
    const std::vector<int> regions = label_regions(t, facets, all, context);
    REQUIRE(regions.size() == t.tets.size());
    double volume = 0;
    for (std::size_t i = 0; i < regions.size(); ++i)
        if (regions[i] == 0)
            volume +=
                signed_volume(points[t.tets[i][0]], points[t.tets[i][1]], points[t.tets[i][2]], points[t.tets[i][3]]);
    CHECK(volume == Approx(4.0 / 3));
    facets.pop_back();
    CHECK(label_regions(t, facets, find_facets(t, points.size(), facets), context).empty());
}

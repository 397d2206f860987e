// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <numeric>

#include "catch.h"
#include "held_box.h"
#include "statics/loads.h"

using namespace featuremesh;

TEST_CASE("a box weighs its volume times its density") {
    for (const int order : {1, 2}) {
        const Mesh mesh = solved_box(2, order, {10, 20, 30});
        std::vector<double> loads(3 * mesh.node_count(), 0.0);
        const std::vector<Material> materials{steel};
        const std::vector<std::int32_t> of_tets(mesh.tets.size(), 0);
        add_weight(mesh, materials, of_tets, {0, 0, -9806}, loads);
        const Vec3 sum = sum_of(loads);
        CHECK(std::abs(sum.x) < 1e-12);
        CHECK(sum.z == Approx(-9806 * 7.85e-9 * 6000));
    }
}

TEST_CASE("pressure pushes against its face, and all around it balances") {
    for (const int order : {1, 2}) {
        const Mesh mesh = solved_box(2, order, {10, 20, 30});
        std::vector<double> loads(3 * mesh.node_count(), 0.0);
        add_pressure(mesh, triangles_of(mesh, 1), 2.5, loads);  // x = 10
        CHECK(distance(sum_of(loads), {-2.5 * 600, 0, 0}) < 1e-9);
        for (int face = 0; face < 6; ++face)
            if (face != 1) add_pressure(mesh, triangles_of(mesh, face), 2.5, loads);
        CHECK(length(sum_of(loads)) < 1e-9);
    }
}

TEST_CASE("pressure on a curved side pushes with the area that it closes") {
    // The side bulges, but its border stays: the sum of the pressure's forces depends on the border alone.
    Mesh mesh = solved_box(1, 2);
    const auto side = triangles_of(mesh, 1);
    const NodeId diagonal = mesh.triangle_mids[std::size_t(side[0])][0];
    std::vector<double> plane(3 * mesh.node_count(), 0.0), bulged = plane;
    add_pressure(mesh, side, 1, plane);
    for (const std::int32_t t : side)
        for (const NodeId mid : mesh.triangle_mids[std::size_t(t)])
            if (mesh.entities[mid.index()].dim == 2) mesh.points[mid.index()].x += 0.2;
    add_pressure(mesh, side, 1, bulged);
    CHECK(bulged != plane);
    CHECK(distance(sum_of(plane), {-1, 0, 0}) < 1e-12);
    CHECK(distance(sum_of(bulged), sum_of(plane)) < 1e-12);
    CHECK(diagonal.is_valid());
}

TEST_CASE("shares of area and length sum to the whole, mid-side nodes having what FreeCAD gives them") {
    for (const int order : {1, 2}) {
        const Mesh mesh = solved_box(3, order, {10, 20, 30});
        const auto areas = area_shares(mesh, triangles_of(mesh, 5));
        CHECK(std::accumulate(areas.begin(), areas.end(), 0.0) == Approx(200));
        if (order == 2)
            for (std::size_t i = 0; i < mesh.corner_count; ++i) CHECK(areas[i] == 0);
        std::vector<std::int32_t> segments;
        for (std::size_t s = 0; s < mesh.segments.size(); ++s)
            if (mesh.segment_edges[s].value == 6 * 0 + 2) segments.push_back(std::int32_t(s));  // x = 0, y = 0
        const auto lengths = length_shares(mesh, segments);
        CHECK(std::accumulate(lengths.begin(), lengths.end(), 0.0) == Approx(30));
    }
}

TEST_CASE("a bent side is as long, and a bulged one as large, as its halves and quarters together") {
    Mesh mesh = solved_box(1, 2);
    const std::array<NodeId, 2> ends = mesh.segments[0];
    const NodeId mid = mesh.segment_mids[0];
    mesh.points[mid.index()] += Vec3{0.1, 0.2, 0.3};
    const std::vector<std::int32_t> segment{0};
    const auto lengths = length_shares(mesh, segment);
    const double bent = distance(mesh.point(ends[0]), mesh.point(mid)) + distance(mesh.point(mid), mesh.point(ends[1]));
    CHECK(std::accumulate(lengths.begin(), lengths.end(), 0.0) == Approx(bent));
    CHECK(bent > 1.01 * distance(mesh.point(ends[0]), mesh.point(ends[1])));

    const auto side = triangles_of(mesh, 1);
    for (const std::int32_t t : side)
        for (const NodeId n : mesh.triangle_mids[std::size_t(t)]) mesh.points[n.index()].x += 0.2;
    double bulged = 0;
    for (const std::int32_t t : side) {
        const auto& [a, b, c] = mesh.triangles[std::size_t(t)];
        const auto& [ab, bc, ca] = mesh.triangle_mids[std::size_t(t)];
        for (const auto& [i, j, k] : {std::array{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
            bulged += 0.5 * length(cross(mesh.point(j) - mesh.point(i), mesh.point(k) - mesh.point(i)));
    }
    const auto areas = area_shares(mesh, side);
    CHECK(std::accumulate(areas.begin(), areas.end(), 0.0) == Approx(bulged));
    CHECK(bulged > 1.01);
}

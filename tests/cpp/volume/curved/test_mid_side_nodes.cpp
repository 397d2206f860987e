// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <limits>
#include <numbers>

#include "catch.h"
#include "core/errors.h"
#include "core/messages.h"
#include "mesh/quality.h"
#include "mesh/second_order.h"
#include "mesh/validation.h"
#include "surface/projection.h"
#include "surface/surface_checks.h"
#include "volume/curved/curved_tet_repair.h"
#include "volume/curved/low_tets.h"
#include "volume/curved/mid_side_nodes.h"
#include "volume/curved/straight_sides.h"

using namespace featuremesh;
using featuremesh::testing::mesh_surface;

namespace {

/// Tets from one inner node to every boundary triangle: a mesh of any shape that is star-shaped around it.
Mesh fan_mesh(const Brep& brep, double size, const Vec3& center) {
    Mesh mesh = mesh_surface(brep, size).mesh;
    const NodeId middle = mesh.add_node(center, entity_of(SolidId(0)));
    mesh.corner_count = mesh.points.size();
    const std::size_t count = mesh.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
        const auto& n = mesh.triangles[t];
        mesh.add_tet({n[0], n[2], n[1], middle}, SolidId(0));
    }
    return mesh;
}

/// The largest distance of a boundary node, mid-side nodes included, from its entity.
double largest_distance(const Brep& brep, const Mesh& mesh) {
    const Projector projector(brep);
    double largest = 0;
    for (std::size_t n = 0; n < mesh.points.size(); ++n) {
        const Entity entity = mesh.entities[n];
        if (entity.dim == 1)
            largest = std::max(
                largest, distance(projector.on_edge(EdgeId(entity.index), mesh.parameters[n][0]), mesh.points[n]));
        if (entity.dim == 2)
            largest = std::max(largest,
                               distance(projector.on_face(FaceId(entity.index), mesh.parameters[n]), mesh.points[n]));
    }
    return largest;
}

Expectation expectation_of(const Brep& brep) {
    Expectation expected;
    expected.solids_beside_face = brep.solids_beside_faces();
    return expected;
}

/// Volume of the curved elements: the mean of the Bernstein coefficients is the integral's.
double curved_volume(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
        for (double c : jacobian_coefficients(tet_nodes(mesh, TetId(t)))) sum += c / 120;
    return sum;
}

double straight_volume(const Mesh& mesh) {
    double sum = 0;
    for (const auto& n : mesh.tets)
        sum += signed_volume(mesh.point(n[0]), mesh.point(n[1]), mesh.point(n[2]), mesh.point(n[3]));
    return sum;
}

double least_straight_volume(const Mesh& mesh) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& n : mesh.tets)
        least = std::min(least, signed_volume(mesh.point(n[0]), mesh.point(n[1]), mesh.point(n[2]), mesh.point(n[3])));
    return least;
}

TopoDS_Shape filleted_box(double radius) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 24, 18).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next()) fillet.Add(radius, TopoDS::Edge(it.Current()));
    return fillet.Shape();
}

Mesh with_mid_side_nodes_on_faces(const Brep& brep, Mesh mesh) {
    add_mid_side_nodes(mesh);
    const Projector projector(brep);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (NodeId n : mesh.triangle_mids[i])
            if (mesh.entities[n.index()].dim == 2)
                mesh.points[n.index()] = projector.nearest(mesh.triangle_faces[i], mesh.point(n)).point;
    return mesh;
}

}  // namespace

TEST_CASE("mid-side nodes are on the exact entities and no element is folded, coarse as the mesh may be") {
    struct Case {
        std::string name;
        TopoDS_Shape shape;
        double size;
        Vec3 center;
    };
    // sizes 14 and 6: four and ten elements around the cylinder
    const std::vector<Case> cases{{"cylinder, four around", BRepPrimAPI_MakeCylinder(10, 12).Shape(), 14, {0, 0, 6}},
                                  {"cylinder, ten around", BRepPrimAPI_MakeCylinder(10, 12).Shape(), 6, {0, 0, 6}},
                                  {"sphere", BRepPrimAPI_MakeSphere(10).Shape(), 9, {0, 0, 0}},
                                  {"fillet of 2 at size 10", filleted_box(2), 10, {15, 12, 9}}};
    for (const Case& c : cases) {
        INFO(c.name);
        RunContext context;
        const Brep brep(c.shape);
        const Mesh straight = fan_mesh(brep, c.size, c.center);
        REQUIRE(broken_invariants(straight, expectation_of(brep)).empty());
        const Mesh mesh = curve_to_second_order(brep, straight, nullptr, context);
        CHECK(broken_invariants(mesh, expectation_of(brep)).empty());
        CHECK(largest_distance(brep, mesh) < 1e-9);
        CHECK(measure_quality(mesh).min_scaled_jacobian > 0.1);
        const double wanted = brep.volume_of(SolidId(0));
        CHECK(std::abs(curved_volume(mesh) - wanted) <
              0.3 * std::abs(straight_volume(straight) - wanted) + 1e-9 * wanted);
    }
}

TEST_CASE("moving corners takes no volume below the least one from a tet that has it") {
    RunContext context;
    const Brep brep(BRepPrimAPI_MakeCylinder(10, 12).Shape());
    const Projector projector(brep);
    Mesh start = with_mid_side_nodes_on_faces(brep, fan_mesh(brep, 14, {3, 1, 4}));
    for (NodeId n(0); n.index() < start.points.size(); n = NodeId(n.index() + 1))
        if (start.entities[n.index()].dim == 1) {
            const OnEdge on = projector.nearest(EdgeId(start.entities[n.index()].index), start.point(n));
            start.points[n.index()] = on.point, start.parameters[n.index()] = {on.t, 0};
        }
    const double least = least_straight_volume(start);
    const auto least_after = [&](double floor) {
        Mesh mesh = start;
        unfold_tets(mesh, projector, std::vector<bool>(mesh.points.size(), true), {0.8, floor}, context);
        CHECK(mesh.points != start.points);
        return least_straight_volume(mesh);
    };
    CHECK(least_after(0) < 0.9 * least);
    CHECK(least_after(least) > 0.949 * least);
}

TEST_CASE("a mid-side node on an edge is half way in arc length") {
    RunContext context;
    const Brep brep(BRepPrimAPI_MakeCylinder(10, 12).Shape());
    const Mesh mesh = curve_to_second_order(brep, fan_mesh(brep, 6, {0, 0, 6}), nullptr, context);
    for (std::size_t i = 0; i < mesh.segments.size(); ++i) {
        const Vec3 &a = mesh.point(mesh.segments[i][0]), &b = mesh.point(mesh.segments[i][1]),
                   &m = mesh.point(mesh.segment_mids[i]);
        CHECK(distance(a, m) == Approx(distance(m, b)));
        if (a.z == b.z) CHECK(std::hypot(m.x, m.y) == Approx(10.0));
    }
}

TEST_CASE("a part with plane faces only stays straight") {
    RunContext context;
    const Brep brep(BRepPrimAPI_MakeBox(10, 8, 6).Shape());
    const Mesh mesh = curve_to_second_order(brep, fan_mesh(brep, 3, {5, 4, 3}), nullptr, context);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) CHECK_FALSE(has_curved_side(mesh, TetId(t)));
    CHECK(tets_at_most(mesh, 0.99, context).empty());
}

TEST_CASE("curving again with what was curved keeps every bit") {
    RunContext context;
    const Brep brep(BRepPrimAPI_MakeCylinder(10, 12).Shape());
    const Mesh straight = fan_mesh(brep, 6, {0, 0, 6});
    const Mesh curved = curve_to_second_order(brep, straight, nullptr, context);
    REQUIRE(curved.tets.size() == straight.tets.size());
    Mesh next = straight;
    next.next_node_number = curved.next_node_number;
    next.next_element_number = curved.next_element_number;
    const Mesh again = curve_to_second_order(brep, next, &curved, context);
    CHECK(again.points == curved.points);
    CHECK(again.node_numbers == curved.node_numbers);
    CHECK(again.tet_mids == curved.tet_mids);
    CHECK(again.parameters == curved.parameters);
}

TEST_CASE("a tet that stays folded is told to be at the face that it has most corners on") {
    RunContext context;
    const Brep brep(BRepPrimAPI_MakeCylinder(10, 12).Shape());
    const Mesh straight = fan_mesh(brep, 6, {0, 0, 6});
    Mesh folded = curve_to_second_order(brep, straight, nullptr, context);
    const FaceId around = folded.triangle_faces.front(), top = folded.triangle_faces.back();
    REQUIRE(around != top);
    const auto dim = [&](NodeId n) { return folded.entities[n.index()].dim; };
    NodeId from_rim;
    for (std::size_t t = 0; t < folded.triangles.size(); ++t)
        for (int s = 0; s < 3; ++s)
            if (folded.triangle_faces[t] == top && dim(folded.triangles[t][s]) < 2 &&
                dim(folded.triangle_mids[t][s]) == 2)
                from_rim = folded.triangle_mids[t][s];
    REQUIRE(from_rim.is_valid());
    folded.points[from_rim.index()] = {0, 0, -20};
    Mesh next = straight;
    next.next_node_number = folded.next_node_number;
    next.next_element_number = folded.next_element_number;
    const SecondOrder result = try_second_order(brep, next, &folded, context);
    REQUIRE_FALSE(result.is_valid());
    CHECK(result.place == std::vector<Entity>{entity_of(top)});
}

TEST_CASE("the same mesh gives the same bytes for any number of threads") {
    const Brep brep(BRepPrimAPI_MakeCylinder(10, 12).Shape());
    const Mesh straight = fan_mesh(brep, 14, {0, 0, 6});
    RunContext one, three;
    three.threads = 3;
    const Mesh a = curve_to_second_order(brep, straight, nullptr, one),
               b = curve_to_second_order(brep, straight, nullptr, three);
    CHECK(a.points == b.points);
    CHECK(a.tets == b.tets);
}

TEST_CASE("low tets are found again where nodes move, and where they move back") {
    const Brep brep(BRepPrimAPI_MakeCylinder(10, 12).Shape());
    Mesh mesh = with_mid_side_nodes_on_faces(brep, fan_mesh(brep, 8, {0, 0, 6}));
    RunContext context;
    const TetsAtNode tets_at(mesh, context);
    LowTets low(mesh, 0.5, context);
    const std::vector<TetId> at_first = low.found();
    CHECK(at_first == tets_at_most(mesh, 0.5, context));
    const std::vector<Vec3> points = mesh.points;
    std::size_t most = 0;
    for (std::size_t n = 0; n < mesh.points.size(); n += 3) {
        mesh.points[n] += 0.5 * (Vec3{0, 0, 6} - mesh.points[n]);
        low.look_again(tets_at);
        CHECK(low.found() == tets_at_most(mesh, 0.5, context));
        most = std::max(most, low.found().size());
    }
    CHECK(most > at_first.size() + 5);
    mesh.points = points;
    low.look_again(tets_at);
    CHECK(low.found() == at_first);
}

TEST_CASE("sides that fold tets are straight in the end, others stay, and what is off the shape is told") {
    const Brep brep(BRepPrimAPI_MakeCylinder(10, 12).Shape());
    Mesh mesh = with_mid_side_nodes_on_faces(brep, fan_mesh(brep, 8, {0, 0, 6}));
    const NodeId middle = mesh.tets.front()[3];
    const auto on_curved_face = std::find_if(mesh.entities.begin() + std::ptrdiff_t(mesh.corner_count),
                                             mesh.entities.end(), [](const Entity& e) {
                                                 return e == Entity{2, 0};
                                             });
    const std::size_t pushed = std::size_t(on_curved_face - mesh.entities.begin());
    mesh.points[pushed] += 0.9 * (mesh.point(middle) - mesh.points[pushed]);
    RunContext context;
    const std::vector<TetId> folded = tets_at_most(mesh, 0, context);
    REQUIRE(folded.size() >= 2);
    const StraightSides result = straighten(brep, mesh, {folded, {}}, context);
    CHECK(tets_at_most(result.mesh, 0.05, context).empty());
    CHECK(result.mesh.tets == mesh.tets);
    std::size_t moved = 0, moved_on_shape = 0;
    double furthest = 0;
    for (std::size_t n = 0; n < mesh.points.size(); ++n) {
        const double off = distance(mesh.points[n], result.mesh.points[n]);
        moved += off > 0, moved_on_shape += off > 1e-8 && mesh.entities[n].dim < 3;
        furthest = std::max(furthest, off);
    }
    CHECK(result.distance == furthest);
    CHECK(distance(mesh.points[pushed], result.mesh.points[pushed]) > 0.5 * furthest);
    CHECK(result.sides == moved_on_shape);
    CHECK(moved < (mesh.points.size() - mesh.corner_count) / 4);
    CHECK(std::find(result.places.begin(), result.places.end(), Entity{2, 0}) != result.places.end());
}

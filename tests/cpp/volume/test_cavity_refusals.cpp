// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/cavity_refusals.h"

#include <algorithm>
#include <set>

#include "../mesh/box_mesh.h"
#include "catch.h"
#include "core/messages.h"
#include "volume/filled_parts.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

const std::vector<std::array<SolidId, 2>> outer_faces(6, {SolidId(0), SolidId()});

Mesh without_tets(Mesh mesh) {
    mesh.tets.clear(), mesh.tet_solids.clear(), mesh.tet_numbers.clear();
    return mesh;
}

/// Three nodes, and the same triangle on Face5, on Face3 and at an interface.
struct Triangles {
    Triangles() {
        for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{3, 0, 0}, Vec3{0, 4, 0}}) mesh.add_node(p, entity_of(FaceId(4)));
        cavity.points = mesh.points;
        for (const int face : {4, 2}) {
            cavity.triangle_of_facet.emplace_back(mesh.triangles.size());
            mesh.add_triangle({NodeId(0), NodeId(1), NodeId(2)}, FaceId(face));
        }
        cavity.triangle_of_facet.emplace_back();
        cavity.facets.resize(3, {{0, 1, 2}, {0, -1}});
    }
    Mesh mesh;
    Cavity cavity;
};

/// Half of the longest side, at the middle.
void check_halves(const Obstacle& obstacle, std::size_t count) {
    REQUIRE(obstacle.shorter.size() == count);
    for (const SizeSource& half : obstacle.shorter) {
        CHECK(half.size == Approx(2.5));
        CHECK(distance(half.point, {1, 4.0 / 3, 0}) < 1e-12);
    }
}

/// The nodes of a box's vertices, as a cavity without facets.
Cavity vertices_of(const Brep& brep, Mesh& mesh) {
    Cavity cavity;
    for (std::size_t v = 0; v < brep.vertex_count(); ++v) {
        cavity.nodes.push_back(mesh.add_node(brep.point_of(VertexId(v)), entity_of(VertexId(v))));
        cavity.points.push_back(mesh.points.back());
    }
    return cavity;
}

}  // namespace

TEST_CASE("where the surface does not close its faces are named, and no other size is asked for") {
    Mesh mesh = without_tets(box_mesh(3));
    CHECK_FALSE(if_open(mesh, find_cavity(mesh, outer_faces)));
    const auto inner = std::find(mesh.triangle_faces.begin(), mesh.triangle_faces.end(), FaceId(4));
    const auto t = inner - mesh.triangle_faces.begin();
    mesh.triangles.erase(mesh.triangles.begin() + t), mesh.triangle_faces.erase(inner);
    mesh.triangle_numbers.erase(mesh.triangle_numbers.begin() + t);
    const std::optional<Obstacle> open = if_open(mesh, find_cavity(mesh, outer_faces));
    REQUIRE(open);
    CHECK(std::count(open->place.begin(), open->place.end(), entity_of(FaceId(4))) == 1);
    CHECK(open->place.size() <= 3);  // a triangle has three neighbours
    CHECK(open->message == say<Code::surface_not_closed>(open->place));
    CHECK(open->shorter.empty());
}

TEST_CASE("nodes in one plane, and facets that cut one another, ask for half of their sides where they are triangles") {
    const Triangles given;
    const std::vector<Entity> both{{2, 2}, {2, 4}};
    const Obstacle flat = in_one_plane(given.mesh, given.cavity, std::vector<int>{0, 1, 2});
    CHECK(flat.place == both);
    CHECK(flat.message == say<Code::nodes_in_one_plane>(both));
    check_halves(flat, 2);
    const Obstacle cut = cut_one_another(given.mesh, given.cavity, std::vector<int>{2, 1});
    CHECK(cut.place == std::vector<Entity>{{2, 2}});
    CHECK(cut.message == say<Code::triangles_cut>(cut.place, Vec3{0, 0, 0}));
    check_halves(cut, 1);
    CHECK(in_one_plane(given.mesh, given.cavity, std::vector<int>{2}).place.empty());
}

TEST_CASE("the faces nearest to a tet are those that most of its corners lie on") {
    const Brep brep(box_part({0, 0, 0}, {3, 2, 1}));
    Mesh mesh;
    const Cavity cavity = vertices_of(brep, mesh);
    const FaceId face(std::size_t{3});
    std::vector<int> on;
    for (std::size_t v = 0; v < brep.vertex_count(); ++v) {
        const std::vector<FaceId> at = brep.faces_at(entity_of(VertexId(v)));
        if (std::count(at.begin(), at.end(), face)) on.push_back(static_cast<int>(v));
    }
    REQUIRE(on.size() == 4);
    const int inside = static_cast<int>(cavity.nodes.size());
    CHECK(nearest_faces(brep, mesh, cavity, {on[0], on[1], on[2], on[3]}) == std::vector<FaceId>{face});
    CHECK(nearest_faces(brep, mesh, cavity, {inside, on[2], on[0], on[1]}) == std::vector<FaceId>{face});
    CHECK(nearest_faces(brep, mesh, cavity, {on[0], inside, inside + 1, inside + 2}) ==
          brep.faces_at(entity_of(VertexId(on[0]))));
    CHECK(nearest_faces(brep, mesh, cavity, {inside, inside + 1, inside + 2, inside + 3}).empty());
}

TEST_CASE("two nodes in one place are refused with the faces of both") {
    const Brep brep(box_part({0, 0, 0}, {3, 2, 1}));
    Mesh mesh;
    Cavity cavity = vertices_of(brep, mesh);
    CHECK_NOTHROW(require_distinct(brep, mesh, cavity));
    cavity.points[6] = cavity.points[1];
    std::set<FaceId> faces;
    for (const int v : {1, 6})
        for (const FaceId face : brep.faces_at(entity_of(VertexId(v)))) faces.insert(face);
    try {
        require_distinct(brep, mesh, cavity);
        FAIL("not refused");
    } catch (const MeshError& error) {
        CHECK(error.message == say<Code::shape_touches_itself>(faces, cavity.points[1]));
    }
}

TEST_CASE("a refusal names a face once, however many cavities miss triangles of it") {
    Mesh mesh;
    for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) mesh.add_node(p, entity_of(FaceId(4)));
    const std::array<NodeId, 3> corners{NodeId(0), NodeId(1), NodeId(2)};
    for (const int face : {4, 2, 4}) mesh.add_triangle(corners, FaceId(face));
    std::vector<Cavity> cavities(2);
    std::vector<CavityFill> fills(2);
    for (std::size_t i = 0; i < 2; ++i) {
        cavities[i].points = mesh.points;
        for (const int triangle : {2 * static_cast<int>(i), 1}) {
            fills[i].places.missing.push_back(static_cast<int>(cavities[i].facets.size()));
            cavities[i].facets.push_back({{0, 1, 2}, {0, -1}});
            cavities[i].triangle_of_facet.emplace_back(triangle);
        }
    }
    const Obstacle obstacle = unrecovered(mesh, cavities, fills);
    CHECK(obstacle.place == std::vector<Entity>{{2, 2}, {2, 4}});
    CHECK_THAT(obstacle.message.in_english(),
               Catch::Matchers::Contains("Face3, Face5") && !Catch::Matchers::Contains("Face5, Face"));
    CHECK(obstacle.shorter.size() == 4);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <cmath>
#include <random>

#include "catch.h"
#include "surface/projection.h"
#include "surface_checks.h"

using namespace featuremesh;
using namespace featuremesh::testing;

TEST_CASE("a point of a face or an edge projects on itself, with and without a guess") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0.02, 0.98);
    for (const NamedShape& s : named_shapes()) {
        INFO(s.name);
        const Brep brep(s.shape);
        const Projector projector(brep);
        const Mesh mesh = mesh_surface(brep, s.size).mesh;
        for (std::size_t n = 0; n < mesh.node_count(); n += 5) {
            const Entity e = mesh.entities[n];
            if (e.dim == 2) {
                const FaceId face(e.index);
                const auto uv = mesh.parameters[n];
                const Vec3 off = mesh.points[n] + 0.3 * share(random) * projector.normal(face, uv);
                for (const OnFace& foot : {projector.nearest(face, off, uv), projector.nearest(face, off)}) {
                    CHECK(distance(foot.point, mesh.points[n]) < 1e-7);
                    CHECK(distance(projector.on_face(face, foot.uv), foot.point) < 1e-12);
                    CHECK(foot.distance == Approx(distance(off, foot.point)));
                }
                CHECK(projector.is_inside_trim(face, uv));
            } else if (e.dim == 1) {
                const EdgeId edge(e.index);
                for (const OnEdge& foot : {projector.nearest(edge, mesh.points[n], mesh.parameters[n][0]),
                                           projector.nearest(edge, mesh.points[n])})
                    CHECK(distance(foot.point, mesh.points[n]) < 1e-9);
            }
        }
    }
}

TEST_CASE("a step on an entity ends on it, and the way along it is what its tangents hold") {
    std::mt19937 random(8);
    std::normal_distribution<double> normal;
    std::size_t on_edges = 0, on_faces = 0;
    for (const NamedShape& s : named_shapes()) {
        INFO(s.name);
        const Brep brep(s.shape);
        const Projector projector(brep);
        const Mesh mesh = mesh_surface(brep, s.size).mesh;
        for (std::size_t n = 0; n < mesh.node_count(); n += 3) {
            const Entity e = mesh.entities[n];
            if (e.dim != 1 && e.dim != 2) continue;
            const auto& at = mesh.parameters[n];
            const Vec3 way{normal(random), normal(random), normal(random)};
            const Vec3 along = projector.along(e, at, way), across = way - along;
            CHECK(std::abs(dot(along, across)) < 1e-9);
            const auto foot = projector.nearest_by_steps(e, mesh.points[n] + 0.1 * way, at);
            if (e.dim == 1) {
                ++on_edges;
                REQUIRE(foot);
                CHECK(length(cross(along, projector.tangent(EdgeId(e.index), at[0]))) < 1e-9);
                CHECK(distance(projector.on_edge(EdgeId(e.index), foot->parameters[0]), foot->point) < 1e-12);
            } else if (foot) {
                ++on_faces;
                CHECK(length(cross(across, projector.normal(FaceId(e.index), at))) < 1e-9);
                CHECK(distance(projector.on_face(FaceId(e.index), foot->parameters), foot->point) < 1e-12);
            }
        }
    }
    CHECK(on_edges > 50);
    CHECK(on_faces > 50);
}

TEST_CASE("steps beside a pole stay near the face's period") {
    const Brep brep(ellipsoid({12, 2, 5}));
    const Projector projector(brep);
    const FaceId face(0);
    double furthest = 0;
    for (double height : {1e-1, 1e-2, 1e-4, 1e-6})
        for (double from = 0; from < 2 * M_PI; from += 0.1)
            for (double to = 0; to < 2 * M_PI; to += 0.1) {
                const Vec3 p = projector.on_face(face, {to, M_PI / 2 - height});
                const auto foot = projector.nearest_by_steps(face, p, {from, M_PI / 2 - 0.1 * height});
                if (!foot) continue;
                furthest = std::max(furthest, std::abs(foot->uv[0]));
            }
    CHECK(furthest < 100);
    CHECK(projector.is_inside_trim(face, {-3e13, 1.5}));
}

TEST_CASE("half way between two points of a closed face is the shorter way round") {
    const Brep brep(BRepPrimAPI_MakeCylinder(10, 12).Shape());
    const Projector projector(brep);
    const FaceId side(0);
    const auto between = [&](double from, double to) {
        return projector.on_face(side, projector.half_way(side, {from, 3}, {to, 5}));
    };
    const double turn = 2 * std::acos(-1.0);
    for (const auto& [from, to] : {std::pair{0.2, 0.8}, {0.9, 0.1}, {0.3, turn - 0.1}, {turn - 0.4, 0.2}}) {
        INFO(from << " to " << to);
        const double chord = 2 * 10 * std::sin(0.25 * std::abs(std::remainder(to - from, turn)));
        for (const double end : {from, to}) {
            const Vec3 at = projector.on_face(side, {end, 4});
            CHECK(distance(between(from, to), at) == Approx(chord));
        }
        CHECK(between(from, to).z == Approx(4));
    }
}

TEST_CASE("the nearest point of an edge is within the edge") {
    const NamedShape box = named_shapes().front();
    const Brep brep(box.shape);
    const Projector projector(brep);
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        const auto ends = brep.ends_of(EdgeId(e));
        const Vec3 a = brep.point_of(ends[0]), b = brep.point_of(ends[1]);
        const Vec3 beyond = b + (b - a);
        CHECK(distance(projector.nearest(EdgeId(e), beyond).point, b) < 1e-12);
        CHECK(distance(projector.nearest(EdgeId(e), a - (b - a)).point, a) < 1e-12);
    }
}

TEST_CASE("normals point out of the solid") {
    for (const NamedShape& s : named_shapes()) {
        INFO(s.name);
        const Brep brep(s.shape);
        const Mesh mesh = mesh_surface(brep, s.size).mesh;
        double volume = 0;
        for (const auto& t : mesh.triangles)
            volume += signed_volume({}, mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]));
        CHECK(volume == Approx(brep.volume_of(SolidId(0))).epsilon(0.06));
    }
}

TEST_CASE("in a face with many holes each point is inside or in a hole") {
    TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 50, 40, 2).Shape();
    for (int i = 0; i < 20; ++i) {
        const gp_Ax2 axis(gp_Pnt(5 + 10 * (i % 5), 5 + 10 * (i / 5), -1), gp_Dir(0, 0, 1));
        plate = BRepAlgoAPI_Cut(plate, BRepPrimAPI_MakeCylinder(axis, 3, 4).Shape()).Shape();
    }
    const Brep brep(plate);
    const Projector projector(brep);
    FaceId top;
    for (std::size_t f = 0; f < brep.face_count(); ++f)
        if (std::abs(projector.nearest(FaceId(f), {25, 20, 2}).distance) < 1e-9 && brep.edges_of(FaceId(f)).size() > 20)
            top = FaceId(f);
    REQUIRE(top.is_valid());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(-0.1, 1.1);
    for (int i = 0; i < 500; ++i) {
        const Vec3 p{50 * share(random), 40 * share(random), 2};
        const double x = p.x - 10 * std::floor(p.x / 10) - 5, y = p.y - 10 * std::floor(p.y / 10) - 5;
        const bool is_in_plate = p.x > 0 && p.x < 50 && p.y > 0 && p.y < 40;
        CHECK(projector.is_inside_trim(top, projector.nearest(top, p).uv) == (is_in_plate && std::hypot(x, y) > 3));
    }
    CHECK(projector.is_inside_trim(top, projector.nearest(top, {8, 5, 2}).uv));  // its border counts
    CHECK(projector.is_inside_trim(top, projector.nearest(top, {0, 7, 2}).uv));
}

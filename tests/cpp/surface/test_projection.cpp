// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"
#include "surface/face_parameters.h"
#include "surface/projection.h"
#include "surface/wanted_length.h"
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

TEST_CASE("half way round a closed face whose parameters end at its seam is beside the seam, too") {
    const double turn = 2 * std::acos(-1.0);
    const Handle(Geom_Curve) circle = new Geom_Circle(gp_Ax2(), 10);
    Handle(Geom_BSplineCurve) curve =
        GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(circle, 0, turn), Convert_QuasiAngular);
    curve->SetNotPeriodic();
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve));
    const Brep brep(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire), gp_Vec(0, 0, 12)).Shape());
    const Projector projector(brep);
    const FaceId side(0);
    const double height = projector.on_face(side, {0, 1}).z > 0 ? 1 : -1;
    for (const auto& [from, to] : {std::pair{0.1, turn - 0.3}, {turn - 0.1, 0.3}, {0.0, turn - 0.4}, {1.0, 1.5}}) {
        INFO(from << " to " << to);
        const auto uv = projector.half_way(side, {from, 3 * height}, {to, 5 * height});
        CHECK((uv[0] >= 0 && uv[0] <= turn));
        const Vec3 a = projector.on_face(side, {from, 4 * height}), b = projector.on_face(side, {to, 4 * height});
        const Vec3 between = projector.on_face(side, uv);
        CHECK(std::max(distance(between, a), distance(between, b)) < 0.6 * distance(a, b));
    }
}

TEST_CASE("nodes of a face and of its border have their parameters on it") {
    for (const NamedShape& s : named_shapes()) {
        INFO(s.name);
        const Brep brep(s.shape);
        const Projector projector(brep);
        const Mesh mesh = mesh_surface(brep, s.size).mesh;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (const NodeId node : mesh.triangles[t]) {
                const FaceId face = mesh.triangle_faces[t];
                const auto uv = parameters_on(brep, face, mesh, node);
                REQUIRE(uv);
                CHECK(distance(projector.on_face(face, *uv), mesh.point(node)) < 1e-6 * s.size);
            }
    }
}

TEST_CASE("a length is no longer than its limits, however many") {
    const Brep brep(BRepPrimAPI_MakeBox(10, 10, 10).Shape());
    RunContext context;
    SizingOptions options;
    options.size = 3;
    const SizingField field = make_sizing(brep, options, {}, context);
    WantedLength wanted(field);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0, 10), size(0.1, 1);
    std::vector<SizeSource> limits;
    for (int i = 0; i < 200; ++i) limits.push_back({{place(random), place(random), place(random)}, size(random)});
    const std::size_t half = limits.size() / 2;
    wanted.limit(std::span(limits).first(half));
    wanted.limit(std::span(limits).subspan(half));
    for (const SizeSource& at : limits) {
        CHECK(wanted.at(at.point) <= 1.2 * at.size);
        double least = field.at(at.point);
        for (const SizeSource& other : limits)
            least = std::min(least, other.size + 0.3 * distance(at.point, other.point));
        CHECK(wanted.at(at.point) >= least);
    }
}

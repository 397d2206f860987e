// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "core/errors.h"
#include "surface/triangle_crossings.h"
#include "surface_checks.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// One triangle per list of corners, all new, each on a face of its own.
Mesh triangles_at(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& corners) {
    Mesh mesh;
    for (const Vec3& p : points) mesh.add_node(p, Entity{2, 0});
    for (const auto& c : corners)
        mesh.add_triangle({NodeId(c[0]), NodeId(c[1]), NodeId(c[2])}, FaceId(mesh.triangles.size()));
    return mesh;
}

std::size_t crossings_of(const Mesh& mesh) {
    // The first face is a cylinder: its triangle does not lie in it, so the pair is looked at.
    const Brep brep(BRepPrimAPI_MakeCylinder(1, 1).Shape());
    RunContext context;
    return crossing_triangles(brep, mesh, 0, context).within.size();
}

}  // namespace

TEST_CASE("triangles cross when they have more in common than their shared nodes") {
    const std::vector<Vec3> points{{0, 0, 0},     {1, 0, 0},     {0, 1, 0}, {0.2, 0.2, -1},
                                   {0.2, 0.2, 1}, {0.9, 0.9, 1}, {0, 0, 2}, {0.3, 0.3, 0}};
    CHECK(crossings_of(triangles_at(points, {{0, 1, 2}, {3, 4, 5}})) == 1);
    CHECK(crossings_of(triangles_at(points, {{0, 1, 2}, {4, 5, 6}})) == 0);
    CHECK(crossings_of(triangles_at(points, {{0, 1, 2}, {0, 6, 4}})) == 0);
    CHECK(crossings_of(triangles_at(points, {{0, 1, 2}, {0, 3, 4}})) == 1);
    CHECK(crossings_of(triangles_at(points, {{0, 1, 2}, {1, 0, 6}})) == 0);
    CHECK(crossings_of(triangles_at(points, {{0, 1, 2}, {0, 1, 7}})) == 1);
    CHECK(crossings_of(triangles_at(points, {{0, 1, 2}, {2, 1, 0}})) == 1);
}

TEST_CASE("of the pairs that cross those with a new triangle are found, the new one first") {
    // a fan through the axis of the cylinder, whose triangles on its wall do not lie in it: each crosses each other
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> corners;
    for (int i = 0; i < 6; ++i) {
        const double angle = 0.5 * i, x = std::cos(angle), y = std::sin(angle);
        for (const Vec3& p : {Vec3{-x, -y, 0.1 * i}, Vec3{x, y, -0.1 * i}, Vec3{0, 0, 5}}) points.push_back(p);
        corners.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    Mesh mesh = triangles_at(points, corners);
    const Brep brep(BRepPrimAPI_MakeCylinder(1, 1).Shape());
    for (std::size_t t = 0; t < corners.size(); ++t) mesh.triangle_faces[t] = FaceId(t % brep.face_count());
    RunContext context;
    const auto all = crossing_triangles(brep, mesh, 0, context).within;
    REQUIRE(all.size() > 6);
    for (std::size_t first_new = 1; first_new <= corners.size(); ++first_new) {
        auto wanted = all, found = crossing_triangles(brep, mesh, first_new, context).within;
        std::erase_if(wanted, [&](const auto& pair) { return pair[0].index() < first_new; });
        std::sort(wanted.begin(), wanted.end()), std::sort(found.begin(), found.end());
        CHECK(found == wanted);
    }
}

TEST_CASE("a thin tube is meshed finer than asked where its walls would cross") {
    const gp_Ax2 turned(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(1, 0.4, 0));
    const TopoDS_Shape tube =
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(20, 60).Shape(), BRepPrimAPI_MakeCylinder(turned, 19, 60).Shape())
            .Shape();
    const Brep brep(tube);
    const SurfaceResult result = mesh_surface(brep, 20);
    CHECK(surface_findings(brep, result.mesh).empty());
    CHECK(euler_characteristic(result.mesh) == 0);
    CHECK(!result.report.warnings.empty());
    RunContext context;
    CHECK(crossing_triangles(brep, result.mesh, 0, context).within.empty());
}

namespace {

const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 5, 5), gp_Dir(0, 0, 1)), 3, 10).Shape();

}  // namespace

TEST_CASE("a solid that crosses itself is refused with the names of its faces and a place") {
    TopoDS_Solid both;
    BRep_Builder builder;
    builder.MakeSolid(both);
    for (const TopoDS_Shape& part : {box, pin}) builder.Add(both, TopExp_Explorer(part, TopAbs_SHELL).Current());
    const Brep brep(both);
    try {
        mesh_surface(brep, 2);
        FAIL("not refused");
    } catch (const MeshError& error) {
        const std::string message = error.what();
        const std::string names = "Face6 and Face7 near (";
        REQUIRE(message.find(names) != std::string::npos);
        Vec3 p;
        REQUIRE(std::sscanf(message.c_str() + message.find(names) + names.size(), "%lf, %lf, %lf)", &p.x, &p.y, &p.z) ==
                3);
        CHECK(std::abs(std::hypot(p.x - 5, p.y - 5) - 3) < 1);
        CHECK(std::abs(p.z - 10) < 1);
    }
}

TEST_CASE("solids that overlap or touch have each a mesh of its own, and a warning names them") {
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(8, 8, 8), gp_Pnt(14, 15, 16)).Shape();
    const auto beside_over_gap = [](double gap) {
        return BRepPrimAPI_MakeBox(gp_Pnt(10 + gap, 2, 3), gp_Pnt(14, 6, 7)).Shape();
    };
    const TopoDS_Shape beside = beside_over_gap(0), nearly = beside_over_gap(7e-15), apart = beside_over_gap(1e-5);
    for (const TopoDS_Shape& other : {pin, block, beside, nearly, apart}) {
        TopoDS_Compound two;
        BRep_Builder builder;
        builder.MakeCompound(two);
        builder.Add(two, box);
        builder.Add(two, other);
        const Brep brep(two);
        const SurfaceResult result = mesh_surface(brep, 2);
        CHECK(surface_findings(brep, result.mesh).empty());
        REQUIRE(result.report.warnings.size() == (other.IsSame(apart) ? 0 : 1));
        if (other.IsSame(apart)) continue;
        const std::string warning = result.report.warnings[0].in_english();
        CHECK(warning.find("Solid1 and Solid2") != std::string::npos);
        if (other.IsSame(beside) ||
            other.IsSame(
                nearly))  // the faces that lie on one another, before those that only meet the first one in an edge
            CHECK(warning.find("(Face2 and Face7") != std::string::npos);
    }
}

TEST_CASE("a face whose boundary crosses itself is refused by its name and those of the edges") {
    BRepBuilderAPI_MakePolygon outline(gp_Pnt(0, 0, 0), gp_Pnt(20, 0, 0), gp_Pnt(20, 10, 0), gp_Pnt(5, -5, 0), true);
    const Brep brep(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 6)).Shape());
    std::string message;
    try {
        mesh_surface(brep, 2);
    } catch (const MeshError& error) {
        message = error.what();
    }
    CHECK(message.find("Face") != std::string::npos);
    CHECK(message.find("Edge") != std::string::npos);
    CHECK(message.find("Check geometry") != std::string::npos);
}

TEST_CASE("solids that touch are found among kept triangles, too") {
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    for (const TopoDS_Shape& part : {box, pin}) builder.Add(both, part);
    const Brep brep(both);
    const Mesh mesh = mesh_surface(brep, 3).mesh;
    RunContext context;
    const auto all_new = crossing_triangles(brep, mesh, 0, context),
               all_kept = crossing_triangles(brep, mesh, mesh.triangles.size(), context);
    CHECK(!all_new.between.empty());
    CHECK(all_kept.between == all_new.between);
    CHECK(all_kept.within.empty());
}

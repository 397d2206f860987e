// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

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
    return crossing_triangles(brep, mesh, 0, context).size();
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

TEST_CASE("a thin tube is meshed finer than asked where its walls would cross") {
    const gp_Ax2 turned(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(1, 0.4, 0));
    const TopoDS_Shape tube =
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(20, 60).Shape(), BRepPrimAPI_MakeCylinder(turned, 19, 60).Shape())
            .Shape();
    const Brep brep(tube);
    const SurfaceResult result = mesh_surface(brep, 20);
    CHECK(findings(brep, result.mesh).empty());
    CHECK(euler_characteristic(result.mesh) == 0);
    CHECK(!result.report.warnings.empty());
    RunContext context;
    CHECK(crossing_triangles(brep, result.mesh, 0, context).empty());
}

TEST_CASE("a shape that crosses itself is refused with the names of its faces") {
    TopoDS_Compound two;
    BRep_Builder builder;
    builder.MakeCompound(two);
    builder.Add(two, BRepPrimAPI_MakeBox(10, 10, 10).Shape());
    builder.Add(two, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 5, 5), gp_Dir(0, 0, 1)), 3, 10).Shape());
    const Brep brep(two);
    try {
        mesh_surface(brep, 2);
        FAIL("not refused");
    } catch (const MeshError& error) {
        CHECK(std::string(error.what()).find("Face6 and Face7") != std::string::npos);
    }
}

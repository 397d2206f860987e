// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/flat_strips.h"

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "catch.h"
#include "surface_checks.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

constexpr double width = 0.15, size = 3;

/// Two plates joined by a narrow strip, all three as thick, whose ends lie apart: fused, and the faces not joined.
TopoDS_Shape plates() {
    const auto box = [](double x, double y, double dx, double dy) {
        return BRepPrimAPI_MakeBox(gp_Pnt(x, y, 0), dx, dy, 2).Shape();
    };
    const TopoDS_Shape first = BRepAlgoAPI_Fuse(box(0, 0, 20, 40), box(20, 0.4, width, 38)).Shape();
    return BRepAlgoAPI_Fuse(first, box(20 + width, 1.5, 20, 35)).Shape();
}

/// A disc with so many sides, of wedges with a corner in common: its top and bottom are fans of needles, as STL files
/// have them.
TopoDS_Shape disc_of_needles(int sides) {
    const auto corner = [&](int i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        return gp_Pnt(20 * std::cos(angle), 20 * std::sin(angle), 0);
    };
    TopoDS_Shape all;
    for (int i = 1; i + 1 < sides; ++i) {
        BRepBuilderAPI_MakePolygon needle(corner(0), corner(i), corner(i + 1), true);
        const auto face = BRepBuilderAPI_MakeFace(needle.Wire()).Face();
        const TopoDS_Shape wedge = BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, 2)).Shape();
        all = i == 1 ? wedge : BRepAlgoAPI_Fuse(all, wedge).Shape();
    }
    return all;
}

/// Of the nodes on one long side of the strip's top, those with none across.
int nodes_alone(const Mesh& mesh) {
    int count = 0;
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
        const Vec3& p = mesh.points[n];
        const bool is_on_side = std::abs(p.x - 20) < 1e-9 && std::abs(p.z - 2) < 1e-9;
        if (mesh.entities[n].dim != 1 || !is_on_side || p.y < 2.5 || p.y > 35.5) continue;
        count += std::none_of(mesh.points.begin(), mesh.points.end(), [&](const Vec3& q) {
            return distance(q, p + Vec3{width, 0, 0}) < 1e-6;
        });
    }
    return count;
}

}  // namespace

TEST_CASE("a narrow strip in a plane gets its nodes opposite one another") {
    const Brep brep(plates());
    const SurfaceResult result = mesh_surface(brep, size, NarrowFaces::opposite_nodes);
    CHECK(surface_findings(brep, result.mesh).empty());
    CHECK(result.report.has_opposite_nodes);
    CHECK(nodes_alone(result.mesh) == 0);
    CHECK(edges_of_flat_strips(result.mesh, 0).empty());

    const SurfaceResult own = mesh_surface(brep, size, NarrowFaces::own_chains);
    CHECK(nodes_alone(own.mesh) > 5);
    CHECK(edges_of_flat_strips(own.mesh, 0).size() > 5);
    CHECK(edges_of_flat_strips(own.mesh, own.mesh.triangles.size()).empty());
}

TEST_CASE("a fan of needles, of which each makes the next one narrow, is filled a few times only") {
    const Brep brep(disc_of_needles(80));
    const SurfaceResult result = mesh_surface(brep, 10, NarrowFaces::opposite_nodes);
    CHECK(surface_findings(brep, result.mesh).empty());
    CHECK(result.report.has_opposite_nodes);
    CHECK(result.report.fillings <= 8);
}

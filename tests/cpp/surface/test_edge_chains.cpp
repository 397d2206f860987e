// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_chains.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>

#include "catch.h"
#include "surface_checks.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// A trough whose bulging sides come as near to one another as twice the gap at (0, 4, z).
TopoDS_Wire outline_of_trough(double z, double gap) {
    BRepBuilderAPI_MakeWire wire;
    const auto line = [&](double x, double y, double u, double v) {
        wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(x, y, z), gp_Pnt(u, v, z)).Edge());
    };
    const auto arc = [&](const gp_Pnt& from, const gp_Pnt& through, const gp_Pnt& to) {
        wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(from, through, to).Value()).Edge());
    };
    line(-10, -10, 10, -10), line(10, -10, 10, 8), line(10, 8, 3, 8);
    arc({3, 8, z}, {gap, 4, z}, {3, 0, z});
    line(3, 0, 3, -5), line(3, -5, -3, -5), line(-3, -5, -3, 0);
    arc({-3, 0, z}, {-gap, 4, z}, {-3, 8, z});
    line(-3, 8, -10, 8), line(-10, 8, -10, -10);
    return wire.Wire();
}

/// Two edges of it touch at one point, between their vertices.
TopoDS_Shape touching_trough() {
    BRepOffsetAPI_ThruSections loft(true, true);
    loft.AddWire(outline_of_trough(0, 1.5));
    loft.AddWire(outline_of_trough(3, 0));
    loft.AddWire(outline_of_trough(6, 1.5));
    return loft.Shape();
}

}  // namespace

TEST_CASE("where two edges of a solid touch between their vertices neither has a node") {
    const Brep brep(touching_trough());
    for (const double size : {1.78, 0.89, 0.446}) {
        INFO(size);
        const Mesh mesh = mesh_surface(brep, size).mesh;
        CHECK(findings(brep, mesh).empty());
        const auto is_at_contact = [](const Vec3& p) { return distance(p, {0, 4, 3}) < 1e-3; };
        CHECK(std::none_of(mesh.points.begin(), mesh.points.end(), is_at_contact));
        CHECK(euler_characteristic(mesh) == 2);
    }
}

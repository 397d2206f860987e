// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include "catch.h"
#include "filled_parts.h"
#include "mesh/quality.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

TopoDS_Shape cylinder(const gp_Pnt& base, double radius, double height) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(base, gp_Dir(0, 0, 1)), radius, height).Shape();
}

void check_angles(const TopoDS_Shape& shape, double size, double least_deg) {
    const Part part = prepare(shape, size);
    const Mesh mesh = fill(part).mesh;
    CHECK(findings(part.brep, mesh) == "");
    CHECK(measure_quality(mesh).min_dihedral_unforced > least_deg);
}

}  // namespace

TEST_CASE("a ledge far narrower than the size has no needles") {
    for (const double width : {0.2, 0.3, 0.5})
        check_angles(
            BRepAlgoAPI_Fuse(box_part({0, 0, 0}, {60, 40, 20}), box_part({0, 0, 20}, {60, 40 - width, 10})).Shape(), 4,
            15);
}

TEST_CASE("a boss that nearly touches a side leaves no needles between") {
    check_angles(BRepAlgoAPI_Fuse(box_part({0, 0, 0}, {40, 40, 20}), cylinder({20, 29.8, 20}, 10, 10)).Shape(), 4, 20);
}

TEST_CASE("cylinders that nearly touch on one side leave no needles between") {
    check_angles(BRepAlgoAPI_Fuse(cylinder({0, 0, 0}, 10, 10), cylinder({0.3, 0, 10}, 9.5, 10)).Shape(), 4, 20);
}

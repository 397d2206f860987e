// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>

#include "catch.h"
#include "filled_parts.h"
#include "mesh/quality.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

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

TEST_CASE("a low rib far narrower than the size has no needles") {
    check_angles(BRepAlgoAPI_Fuse(box_part({0, 0, 0}, {60, 40, 10}), box_part({0, 20, 10}, {60, 0.3, 1.2})).Shape(), 4,
                 12);
}

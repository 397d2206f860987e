// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/booleans/glued_filler.h"

#include <BOPAlgo_Builder.hxx>
#include <BOPDS_DS.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <gp_Ax3.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <numbers>

#include "catch.h"

using namespace featuremesh;

namespace {

TopoDS_Face square(double z, double half) {
    return BRepBuilderAPI_MakeFace(gp_Pln({0, 0, z}, {0, 0, 1}), -half, half, -half, half);
}

/// Intersects the two faces; pairs that the kernel was shown of an edge or a vertex and a face, and pieces of the
/// first.
struct Glued {
    int edges = 0, vertices = 0, pieces = 0;

    Glued(const TopoDS_Face& a, const TopoDS_Face& b) {
        GluedFiller filler;
        TopTools_ListOfShape faces;
        faces.Append(a);
        faces.Append(b);
        filler.SetArguments(faces);
        filler.SetNonDestructive(true);
        filler.Perform();
        edges = filler.PDS()->InterfEF().Length();
        vertices = filler.PDS()->InterfVF().Length();
        BOPAlgo_Builder builder;
        builder.SetArguments(faces);
        builder.PerformWithFiller(filler);
        pieces = std::max(1, builder.Modified(a).Extent());
    }
};

}  // namespace

TEST_CASE("edges on a face divide it") {
    const Glued in_a_plane(square(0, 10), square(0, 4));
    CHECK(in_a_plane.edges == 4);
    CHECK(in_a_plane.vertices == 4);
    CHECK(in_a_plane.pieces == 2);
    const gp_Cylinder cylinder(gp_Ax3(), 3);
    const Glued on_a_cylinder(BRepBuilderAPI_MakeFace(cylinder, 0, 2 * std::numbers::pi, 0, 10).Face(),
                              BRepBuilderAPI_MakeFace(cylinder, 1, 2, 4, 6).Face());
    CHECK(on_a_cylinder.pieces == 2);
}

TEST_CASE("edges that cross a face are not asked for") {
    const TopoDS_Face wall = BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(), 3), 0, 2 * std::numbers::pi, -5, 5);
    const Glued crossing(square(0, 10), wall);
    CHECK(crossing.edges == 0);
    CHECK(crossing.vertices == 0);
    CHECK(crossing.pieces == 1);
}

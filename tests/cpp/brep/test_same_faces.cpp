// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/same_faces.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_TEdge.hxx>
#include <TopExp_Explorer.hxx>
#include <numbers>

#include "brep/same_solids.h"
#include "brep/shapes.h"
#include "catch.h"

using namespace featuremesh;
using namespace featuremesh::test;

namespace {

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Vec& way) {
    gp_Trsf motion;
    motion.SetTranslation(way);
    return BRepBuilderAPI_Transform(shape, motion, true).Shape();
}

/// A disc with a socket for a key of so many sides, turned by that angle.
TopoDS_Shape disc_with_socket(int sides, double angle_deg) {
    BRepBuilderAPI_MakePolygon polygon;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides + angle_deg * std::numbers::pi / 180;
        polygon.Add(gp_Pnt(4 * std::cos(angle), 4 * std::sin(angle), 3));
    }
    polygon.Close();
    const TopoDS_Shape socket = BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Face(), gp_Vec(0, 0, 9));
    return cut(cylinder({0, 0, 0}, {0, 0, 1}, 10, 8), socket);
}

}  // namespace

TEST_CASE("a face with the same hole turned on the spot is another face") {
    for (const int sides : {3, 4, 6}) {
        const TopoDS_Shape disc = disc_with_socket(sides, 0), turned = disc_with_socket(sides, 10);
        CHECK(unshared_faces(disc, disc_with_socket(sides, 0)).empty());
        CHECK(unshared_faces(disc, turned).size() == std::size_t(sides) + 2);  // walls, top and the socket's bottom
    }
}

TEST_CASE("solids of equal volume, box and inertia are the same where their faces lie on one another") {
    for (const int sides : {3, 4, 6}) {
        CHECK(same_solids(disc_with_socket(sides, 0), disc_with_socket(sides, 360.0 / sides)));
        CHECK_FALSE(same_solids(disc_with_socket(sides, 0), disc_with_socket(sides, 10)));
    }
    const TopoDS_Shape whole = box(0, 0, 0, 20, 10, 5), halves = fused(box(0, 0, 0, 8, 10, 5), box(8, 0, 0, 12, 10, 5));
    CHECK(same_solids(whole, halves));  // with the same walls in two pieces each
    CHECK_FALSE(same_solids(whole, cut(whole, box(0, 0, 0, 1, 1, 1))));
}

TEST_CASE("solids that the kernel cannot compare are not the same") {
    const TopoDS_Shape disc = disc_with_socket(3, 0), other = disc_with_socket(3, 120);
    REQUIRE(same_solids(disc, other));
    for (TopExp_Explorer it(other, TopAbs_EDGE); it.More(); it.Next())
        Handle(BRep_TEdge)::DownCast(it.Current().TShape())->ChangeCurves().Clear();
    CHECK_FALSE(same_solids(disc, other));
}

TEST_CASE("the outline of a change is known again where rounding has moved it") {
    const TopoDS_Shape block = box(0, 0, 0, 40, 20, 10), drilled = cut(block, cylinder({10, 10, -1}, {0, 0, 1}, 3, 12));
    const auto outline_of = [](const TopoDS_Shape& before, const TopoDS_Shape& after) {
        return ChangeOutline(unshared_faces(before, after), unshared_faces(after, before));
    };
    const auto outline_after = [&](const gp_Vec& way) { return outline_of(moved(block, way), moved(drilled, way)); };
    const ChangeOutline outline = outline_of(block, drilled);
    CHECK(outline.matches(outline));
    CHECK(outline.matches(outline_after({3e-9, -2e-9, 1e-9})));
    CHECK_FALSE(outline.matches(outline_after({1e-4, 0, 0})));
}

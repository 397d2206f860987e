// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/girth.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Circ.hxx>
#include <numbers>

#include "catch.h"

using namespace featuremesh;

namespace {

constexpr double round_one = 2 * std::numbers::pi;  // of a rod of radius 1

Brep rod(double length) { return Brep(BRepPrimAPI_MakeCylinder(1, length).Shape()); }

/// A rod along z with two faces of half a turn each.
Brep rod_of_halves(double length) {
    const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 1);
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle, 0, std::numbers::pi),
                                                     BRepBuilderAPI_MakeEdge(circle, std::numbers::pi, round_one));
    return Brep(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire).Face(), gp_Vec(0, 0, length)).Shape());
}

/// A rod along z, a face for each quarter of a turn: of a cylinder, or as a spline.
Brep rod_of_quarters(double length, bool is_spline) {
    const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 1);
    BRepBuilderAPI_MakeWire wire;
    for (int i = 0; i < 4; ++i) {
        const double begin = i * 0.25 * round_one, end = (i + 1) * 0.25 * round_one;
        const Handle(Geom_Curve) arc = new Geom_TrimmedCurve(new Geom_Circle(circle), begin, end);
        const Handle(Geom_Curve) curve = is_spline ? GeomConvert::CurveToBSplineCurve(arc) : arc;
        wire.Add(BRepBuilderAPI_MakeEdge(curve));
    }
    return Brep(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, 0, length)).Shape());
}

SizingOptions coarse(double size) {
    SizingOptions options;
    options.size = size;
    options.min_size = 0.1 * size;
    return options;
}

double smallest_of(const Brep& brep, const SizingOptions& options) {
    RunContext context;
    return make_sizing(brep, options, {}, context).smallest();
}

}  // namespace

TEST_CASE("however large the size is, six elements go round a rod") {
    for (const double length : {200.0, 5000.0})
        for (const double share : {0.1, 0.8}) {
            const SizingOptions options = coarse(share * length);
            CHECK(smallest_of(rod(length), options) == Approx(round_one / 6));
            CHECK(smallest_of(rod_of_halves(length), options) == Approx(round_one / 6));
            for (const bool is_spline : {false, true})
                CHECK(smallest_of(rod_of_quarters(length, is_spline), options) == Approx(round_one / 6).epsilon(1e-6));
        }
    SizingOptions plain = coarse(80);
    plain.elements_per_circle = 0;
    CHECK(smallest_of(rod(1000), plain) == Approx(round_one / 6));
    // where circles ask for more elements anyway, nothing changes
    CHECK(smallest_of(rod(200), coarse(4)) == Approx(round_one / 12));
}

TEST_CASE("rods that bend or become thinner have six elements round them everywhere") {
    const Brep ring(BRepPrimAPI_MakeTorus(200, 1).Shape());
    CHECK(smallest_of(ring, coarse(100)) == Approx(round_one / 6).epsilon(0.01));
    const Brep cone(BRepPrimAPI_MakeCone(1, 0.5, 1000).Shape());
    RunContext context;
    const SizingField field = make_sizing(cone, coarse(500), {}, context);
    for (const double share : {0.0, 0.3, 0.7, 1.0}) {
        const double radius = 1 - 0.5 * share;
        CHECK(field.at({radius, 0, 1000 * share}) == Approx(round_one * radius / 6).epsilon(0.05));
    }
}

TEST_CASE("what has material around it, or on both sides of a small part of a circle, is no rod") {
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-50, -50, 0), 100, 100, 100).Shape();
    const Brep holed(BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(1, 100).Shape()).Shape());
    CHECK(smallest_of(holed, coarse(100)) == Approx(10));
    const Brep rounded(
        BRepAlgoAPI_Fuse(block, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(50, 0, 0), gp_Dir(0, 0, 1)), 1, 100).Shape())
            .Shape());
    CHECK(smallest_of(rounded, coarse(100)) == Approx(10));
    const TopoDS_Shape through = BRepPrimAPI_MakeBox(gp_Pnt(-50, -50, 1), 100, 100, 98).Shape();
    const Brep holed_in_quarters(BRepAlgoAPI_Cut(through, rod_of_quarters(100, true).shape()).Shape());
    CHECK(smallest_of(holed_in_quarters, coarse(100)) == Approx(10));
    CHECK(warnings_of_thin_rods(holed, coarse(100)).empty());
    CHECK(warnings_of_thin_rods(rounded, coarse(100)).empty());
}

TEST_CASE("the report says once where elements are smaller than asked because of a thin rod") {
    const auto lines = warnings_of_thin_rods(rod_of_halves(1000), coarse(80));
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].in_english().find("2 mm thick at Face") != std::string::npos);
    CHECK(lines[0].in_english().find(", Face") != std::string::npos);
    CHECK(warnings_of_thin_rods(rod(200), coarse(4)).empty());
    SizingOptions finer = coarse(80);
    for (std::int32_t face = 0; face < 3; ++face) finer.local.push_back({entity_of(FaceId(std::size_t(face))), 0.5});
    CHECK(warnings_of_thin_rods(rod(1000), finer).empty());
}

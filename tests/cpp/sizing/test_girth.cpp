// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/girth.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeSegment.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <array>
#include <cmath>
#include <gp.hxx>
#include <gp_Circ.hxx>
#include <numbers>
#include <utility>

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
    // with more of it outside than inside, whichever parameter goes round the rod
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 16);
    for (int i = 0; i < 16; ++i) {
        const double angle = (i - 6) * std::numbers::pi / 12;
        points->SetValue(
            i + 1, i <= 12 ? gp_Pnt(200 + std::cos(angle), 0, std::sin(angle)) : gp_Pnt(200, 0, 1 - 0.5 * (i - 12)));
    }
    GeomAPI_Interpolate interpolate(points, true, 1e-9);
    interpolate.Perform();
    for (const bool is_exchanged : {false, true}) {
        const Handle(Geom_BSplineSurface) surface =
            GeomConvert::SurfaceToBSplineSurface(new Geom_SurfaceOfRevolution(interpolate.Curve(), gp::OZ()));
        surface->SetUNotPeriodic(), surface->SetVNotPeriodic();
        if (is_exchanged) surface->ExchangeUV();
        const BRep_Builder builder;
        TopoDS_Shell shell;
        TopoDS_Solid solid;
        builder.MakeShell(shell), builder.MakeSolid(solid);
        builder.Add(shell, BRepBuilderAPI_MakeFace(surface, 1e-7).Face());
        builder.Add(solid, shell);
        BRepLib::OrientClosedSolid(solid);
        const Brep spline(solid);
        const auto girth = Girth::of(spline, FaceId(0), BRepAdaptor_Surface(spline.face(FaceId(0)), false));
        REQUIRE(girth.has_value());
        CHECK(girth->widest() == Approx(std::numbers::pi + 2).epsilon(0.05));
    }
    const Brep cone(BRepPrimAPI_MakeCone(1, 0.5, 1000).Shape());
    RunContext context;
    const SizingField field = make_sizing(cone, coarse(500), {}, context);
    for (const double share : {0.0, 0.3, 0.7, 1.0}) {
        const double radius = 1 - 0.5 * share;
        CHECK(field.at({radius, 0, 1000 * share}) == Approx(round_one * radius / 6).epsilon(0.05));
    }
}

TEST_CASE(
    "rods of several curved faces that become thinner have six elements round their thin end, if that is no tip") {
    const auto tapered = [](double radius) {
        BRepOffsetAPI_ThruSections loft(true, true);
        for (const auto& [z, r] : {std::pair(0.0, 1.0), std::pair(100.0, radius)}) {
            const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), r);
            BRepBuilderAPI_MakeWire wire;
            for (int i = 0; i < 4; ++i)
                wire.Add(BRepBuilderAPI_MakeEdge(circle, i * 0.25 * round_one, (i + 1) * 0.25 * round_one));
            loft.AddWire(wire.Wire());
        }
        return Brep(loft.Shape());
    };
    SizingOptions plain = coarse(50);
    plain.elements_per_circle = 0, plain.refines_narrow_faces = false;
    CHECK(smallest_of(tapered(0.5), plain) == Approx(0.5 * round_one / 6).epsilon(1e-3));
    CHECK(smallest_of(tapered(0.05), plain) == Approx(0.25 * round_one / 6).epsilon(1e-3));
}

TEST_CASE("at the tip of a rod elements are a quarter as long as where it is widest") {
    SizingOptions plain = coarse(50);
    plain.elements_per_circle = 0;
    const Brep cone(BRepPrimAPI_MakeCone(1, 0, 100).Shape());
    CHECK(smallest_of(cone, plain) == Approx(0.25 * round_one / 6).epsilon(1e-3));
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

TEST_CASE("a rim that is rounded and a bar with straight sides are no rods, whatever their surfaces are") {
    SizingOptions plain = coarse(30);
    plain.elements_per_circle = 0, plain.refines_narrow_faces = false;
    const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 10);
    BRepBuilderAPI_MakeWire border, square;
    for (int i = 0; i < 4; ++i)
        border.Add(BRepBuilderAPI_MakeEdge(circle, i * 0.25 * round_one, (i + 1) * 0.25 * round_one));
    const TopoDS_Shape disk =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(border.Wire()).Face(), gp_Vec(0, 0, 40)).Shape();
    BRepFilletAPI_MakeFillet fillet(disk);
    for (TopExp_Explorer it(disk, TopAbs_EDGE); it.More(); it.Next()) {
        const BRepAdaptor_Curve curve(TopoDS::Edge(it.Current()));
        if (curve.GetType() == GeomAbs_Circle && curve.Value(curve.FirstParameter()).Z() > 39)
            fillet.Add(1, TopoDS::Edge(it.Current()));
    }
    const Brep rounded(fillet.Shape());
    for (std::size_t f = 0; f < rounded.face_count(); ++f)
        if (const BRepAdaptor_Surface surface(rounded.face(FaceId(f)), false); surface.GetType() == GeomAbs_Torus)
            CHECK_FALSE(Girth::of(rounded, FaceId(f), surface).has_value());

    const std::array<gp_Pnt, 4> corners{gp_Pnt(1, 1, 0), gp_Pnt(-1, 1, 0), gp_Pnt(-1, -1, 0), gp_Pnt(1, -1, 0)};
    for (std::size_t i = 0; i < 4; ++i) {
        const Handle(Geom_TrimmedCurve) line = GC_MakeSegment(corners[i], corners[(i + 1) % 4]).Value();
        square.Add(BRepBuilderAPI_MakeEdge(GeomConvert::CurveToBSplineCurve(line)));
    }
    const Brep bar(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(square.Wire()).Face(), gp_Vec(0, 0, 100)).Shape());
    CHECK(smallest_of(bar, plain) == 30);
    CHECK(warnings_of_thin_rods(bar, plain).empty());
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

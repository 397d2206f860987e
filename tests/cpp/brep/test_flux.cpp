// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/volumes/flux.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "brep/booleans/shape_difference.h"
#include "brep/same_faces.h"
#include "brep/shape_print.h"
#include "brep/shapes.h"
#include "brep/solid_probe.h"
#include "catch.h"
#include "core/errors.h"

using namespace featuremesh;
using namespace featuremesh::test;
constexpr double pi = std::numbers::pi;

TEST_CASE("volumes of the primitives, wherever the apex is") {
    for (const Vec3 apex : {Vec3{0, 0, 0}, Vec3{3, -4, 50}}) {
        CHECK(flux(box(1, 2, 3, 4, 5, 6), apex) == Approx(120).epsilon(1e-12));
        CHECK(flux(cylinder({1, 2, 3}, {1, 1, 0}, 2, 5), apex) == Approx(20 * pi).epsilon(1e-11));
        CHECK(flux(BRepPrimAPI_MakeSphere(3.0).Solid(), apex) == Approx(36 * pi).epsilon(1e-10));
        CHECK(flux(BRepPrimAPI_MakeTorus(5.0, 2.0).Solid(), apex) == Approx(2 * pi * pi * 5 * 4).epsilon(1e-9));
        CHECK(flux(BRepPrimAPI_MakeCone(3.0, 1.0, 6.0).Solid(), apex) ==
              Approx(pi * 6 / 3 * (9 + 3 + 1)).epsilon(1e-11));
    }
}

namespace {

/// Of a face that is all of a surface.
double flux_of_surface(const Handle(Geom_Surface) & surface) {
    return flux(BRepBuilderAPI_MakeFace(surface, 1e-7).Shape(), {7, -3, 11});
}

/// Without weights, as a loft makes it, of one stretch along u and so many along v.
Handle(Geom_Surface) wavy_spline(int v_degree, int stretches = 3) {
    const int count = v_degree + stretches;
    TColgp_Array2OfPnt poles(1, 4, 1, count);
    for (int i = 1; i <= 4; ++i)
        for (int k = 1; k <= count; ++k) poles(i, k) = {i + 0.1 * k, 2.0 * k, std::sin(3.0 * i + 5.0 * k)};
    const int last = stretches + 1;
    TColStd_Array1OfReal u_knots(1, 2), v_knots(1, last);
    TColStd_Array1OfInteger u_times(1, 2), v_times(1, last);
    for (int i = 1; i <= 2; ++i) u_knots(i) = i, u_times(i) = 4;
    for (int i = 1; i <= last; ++i) v_knots(i) = i * i, v_times(i) = i == 1 || i == last ? v_degree + 1 : 1;
    return new Geom_BSplineSurface(poles, u_knots, v_knots, u_times, v_times, 3, v_degree);
}

}  // namespace

TEST_CASE("a spline's flux does not depend on which parameter is which, with and without weights") {
    const Handle(Geom_Surface) round = new Geom_CylindricalSurface(gp_Ax3({1, 2, 3}, {0, 1, 1}), 4);
    std::vector<Handle(Geom_Surface)> surfaces{new Geom_RectangularTrimmedSurface(round, 0.2, 3.1, -1.0, 6.0)};
    for (const int degree : {2, 3, 4}) surfaces.push_back(wavy_spline(degree));
    for (const auto& surface : surfaces) {
        const auto one = GeomConvert::SurfaceToBSplineSurface(surface);
        const auto turned = Handle(Geom_BSplineSurface)::DownCast(one->Copy());
        turned->ExchangeUV();
        CHECK(flux_of_surface(one) == Approx(-flux_of_surface(turned)).epsilon(1e-9));
        CHECK(flux_of_surface(one) == Approx(flux_of_surface(surface)).epsilon(1e-9));
    }
}

namespace {

/// The part of a surface between corners in its parameters, joined by straight lines there.
TopoDS_Shape part_of_surface(const Handle(Geom_Surface) & surface, const std::array<gp_Pnt2d, 4>& corners) {
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < 4; ++i) {
        const gp_Pnt2d &from = corners[i], &to = corners[(i + 1) % 4];
        const Handle(Geom2d_Line) line = new Geom2d_Line(from, gp_Dir2d(gp_Vec2d(from, to)));
        wire.Add(BRepBuilderAPI_MakeEdge(line, surface, 0, from.Distance(to)));
    }
    const TopoDS_Shape face = BRepBuilderAPI_MakeFace(surface, wire.Wire(), true).Shape();
    BRepLib::BuildCurves3d(face);
    return face;
}

}  // namespace

TEST_CASE("what is above and below a slanted cut of a surface adds up to it, however narrow it is") {
    const Handle(Geom_Surface) ring = new Geom_ToroidalSurface(gp_Ax3({1, 2, 3}, {0, 1, 1}), 5, 2);
    const Handle(Geom_Surface) part = new Geom_RectangularTrimmedSurface(ring, 0.2, 1.7, 0.1, 1.6);
    for (const Handle(Geom_Surface) & surface :
         {part, Handle(Geom_Surface)(GeomConvert::SurfaceToBSplineSurface(part)), wavy_spline(3), wavy_spline(4)}) {
        double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
        surface->Bounds(u1, u2, v1, v2);
        for (const auto& [left, right] : {std::pair{1e-3, 0.03}, {0.05, 0.02}, {0.2, 0.1}, {0.4, 0.7}}) {
            const gp_Pnt2d a(u1, v1 + left * (v2 - v1)), b(u2, v1 + right * (v2 - v1));
            const auto share = [&](const std::array<gp_Pnt2d, 4>& corners) {
                return flux(part_of_surface(surface, corners), {7, -3, 11});
            };
            const double below = share({gp_Pnt2d(u1, v1), gp_Pnt2d(u2, v1), b, a});
            const double above = share({a, b, gp_Pnt2d(u2, v2), gp_Pnt2d(u1, v2)});
            CHECK(below + above == Approx(flux_of_surface(surface)).epsilon(1e-9));
        }
    }
}

TEST_CASE("a part of a face that is long along one parameter has the same flux whichever that is") {
    const auto along_v = Handle(Geom_BSplineSurface)::DownCast(wavy_spline(3, 40));
    const auto along_u = Handle(Geom_BSplineSurface)::DownCast(along_v->Copy());
    along_u->ExchangeUV();
    const std::array<gp_Pnt2d, 4> corners{gp_Pnt2d(1.1, 2), gp_Pnt2d(1.9, 40), gp_Pnt2d(1.7, 1500),
                                          gp_Pnt2d(1.2, 1600)};
    std::array<gp_Pnt2d, 4> turned;
    std::transform(corners.rbegin(), corners.rend(), turned.begin(),
                   [](const gp_Pnt2d& p) { return gp_Pnt2d(p.Y(), p.X()); });
    const Vec3 apex{7, -3, 11};
    CHECK(std::abs(flux(part_of_surface(along_v, corners), apex)) > 1);
    CHECK(flux(part_of_surface(along_v, corners), apex) ==
          Approx(-flux(part_of_surface(along_u, turned), apex)).margin(1e-5));
}

TEST_CASE("the shares of the faces add up, cut and whole") {
    const TopoDS_Shape one = box(0, 0, 0, 10, 10, 10), other = cylinder({5, 5, -1}, {0, 0.3, 1}, 2, 20);
    const double common = flux(BRepAlgoAPI_Common(one, other).Shape(), {1, 2, 3});
    CHECK(flux(cut(one, other), {}) + common == Approx(1000).epsilon(1e-7));
    CHECK(flux(cut(other, one), {7, 0, 0}) + common == Approx(flux(other, {})).epsilon(1e-7));
    CHECK(flux(one.Reversed(), {}) == Approx(-1000));
}

namespace {

/// The shape with another curve under the first edge of its kind that has `middle` for its middle.
TopoDS_Shape with_loose_edge(const TopoDS_Shape& shape, const gp_Pnt& middle, const Handle(Geom_Curve) & curve) {
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape).Shape();
    for (TopExp_Explorer it(copy, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
        const BRepAdaptor_Curve old(edge);
        if (old.Value((old.FirstParameter() + old.LastParameter()) / 2).Distance(middle) > 1e-6) continue;
        BRep_Builder().UpdateEdge(edge, curve, 0.01);
        return copy;
    }
    return {};
}

}  // namespace

TEST_CASE("edges beside their faces make no difference to a volume") {
    // a circle a hundredth too wide on top of a cylinder, and a line that leaves a box's top edge at both ends
    const TopoDS_Shape round = with_loose_edge(cylinder({0, 0, 0}, {0, 0, 1}, 4, 10), {-4, 0, 10},
                                               new Geom_Circle(gp_Ax2({0, 0, 10}, {0, 0, 1}, {1, 0, 0}), 4.01));
    const TopoDS_Shape square =
        with_loose_edge(box(0, 0, 0, 10, 10, 10), {5, 0, 10}, new Geom_Line({0, -0.01, 10}, {10, 0.02, 0}));
    for (const Vec3 apex : {Vec3{0, 0, 0}, Vec3{30, -40, 50}}) {
        CHECK(flux(round, apex) == Approx(160 * pi).epsilon(1e-9));
        CHECK(flux(square, apex) == Approx(1000).epsilon(1e-6));
    }
}

TEST_CASE("points in, out and on") {
    const TopoDS_Shape solid = cut(box(0, 0, 0, 10, 10, 10), cylinder({5, 5, -1}, {0, 0, 1}, 2, 12));
    const SolidProbe probe(solid);
    CHECK(probe.containment_of({1, 1, 1}) == Containment::inside);
    CHECK(probe.containment_of({5, 5, 5}) == Containment::outside);
    CHECK(probe.containment_of({20, 5, 5}) == Containment::outside);
    CHECK(probe.containment_of({5, 5, 10.5}) == Containment::outside);
    CHECK(probe.containment_of({0, 3, 3}) != Containment::outside);
    const auto inner = point_inside(solid);
    REQUIRE(inner);
    CHECK(probe.containment_of(*inner) == Containment::inside);
}

TEST_CASE("faces are recognised after a copy, not after a move") {
    const TopoDS_Shape solid = cut(box(0, 0, 0, 10, 10, 10), cylinder({5, 5, -1}, {0, 0, 1}, 2, 12));
    CHECK(unshared_faces(solid, BRepBuilderAPI_Copy(solid).Shape()).empty());
    CHECK(unshared_faces(solid, {}).size() == 7);
    const TopoDS_Shape other = cut(box(0, 0, 0, 10, 10, 10), cylinder({5, 5.001, -1}, {0, 0, 1}, 2, 12));
    CHECK(unshared_faces(solid, other).size() == 3);  // wall, top and bottom
}

TEST_CASE("added and removed parts account for the change of volume") {
    const TopoDS_Shape before = box(0, 0, 0, 20, 10, 10);
    const TopoDS_Shape after = fused(cut(before, cylinder({15, 5, 5}, {0, 0, 1}, 2, 10)), box(2, 2, 8, 4, 4, 6));
    RunContext context;
    const ShapeDifference difference = difference_of(before, after, work_of_seconds(8), context);
    CHECK(difference.closed);
    REQUIRE(difference.added.size() == 1);
    REQUIRE(difference.removed.size() == 1);
    CHECK(flux(difference.added[0], {}) == Approx(64));
    CHECK(flux(difference.removed[0], {}) == Approx(20 * pi));
    CHECK(difference_of(before, before, work_of_seconds(8), context).added.empty());
    CHECK(difference_of({}, before, work_of_seconds(8), context).added.size() == 1);
    CHECK(difference_of(before, {}, work_of_seconds(8), context).removed.size() == 1);
}

TEST_CASE("what was added to a shape that is not valid is not asked of the kernel") {
    BRepBuilderAPI_MakePolygon outline(gp_Pnt(0, 0, 0), gp_Pnt(10, 10, 0), gp_Pnt(10, 0, 0), gp_Pnt(0, 12, 0), true);
    const TopoDS_Shape crossed =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 6)).Shape();
    RunContext context;
    const ShapeDifference difference = difference_of(box(0, 0, 0, 9, 9, 9), crossed, 1000000, context);
    CHECK_FALSE(difference.closed);
    CHECK(difference.is_hopeless);
    CHECK(difference.work == 0);
}

TEST_CASE("a concave fillet adds, a convex one removes") {
    const TopoDS_Shape step = fused(box(0, 0, 0, 20, 10, 10), box(0, 0, 10, 10, 10, 10));
    double added = 0, removed = 0;
    BRepFilletAPI_MakeFillet fillet(step);
    for (TopExp_Explorer it(step, TopAbs_EDGE); it.More(); it.Next()) {
        const BRepAdaptor_Curve curve(TopoDS::Edge(it.Current()));
        const gp_Pnt middle = curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2);
        const bool concave = middle.Distance({10, 5, 10}) < 1e-6, convex = middle.Distance({20, 5, 10}) < 1e-6;
        if (concave || convex) fillet.Add(concave ? 1 : 2, TopoDS::Edge(it.Current()));
    }
    RunContext context;
    const ShapeDifference difference = difference_of(step, fillet.Shape(), work_of_seconds(8), context);
    CHECK(difference.closed);
    for (const TopoDS_Shape& solid : difference.added) added += flux(solid, {});
    for (const TopoDS_Shape& solid : difference.removed) removed += flux(solid, {});
    CHECK(added == Approx((1 - pi / 4) * 10));
    CHECK(removed == Approx((1 - pi / 4) * 40));
}

namespace {

/// A step with a fillet in its corner and a hole beside it, before and after the fillet.
std::array<TopoDS_Shape, 2> filleted_step(double hole_x, double radius) {
    const TopoDS_Shape step =
        cut(fused(box(0, 0, 0, 30, 10, 10), box(0, 0, 10, 10, 10, 10)), cylinder({hole_x, 5, -1}, {0, 0, 1}, 2, 12));
    BRepFilletAPI_MakeFillet fillet(step);
    for (TopExp_Explorer it(step, TopAbs_EDGE); it.More(); it.Next()) {
        const BRepAdaptor_Curve curve(TopoDS::Edge(it.Current()));
        const gp_Pnt middle = curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2);
        if (middle.Distance({10, 5, 10}) < 1e-6) fillet.Add(radius, TopoDS::Edge(it.Current()));
    }
    return {step, fillet.Shape()};
}

}  // namespace

TEST_CASE("what a feature did before an edit elsewhere need not be found again") {
    RunContext context;
    const auto [before, after] = filleted_step(20, 1);
    const ShapeDifference known = difference_of(before, after, work_of_seconds(8), context);
    REQUIRE(known.closed);
    const auto again = [&](double hole_x, double radius) {
        const auto [step, fillet] = filleted_step(hole_x, radius);
        const ShapeDifference found = difference_of(step, fillet, work_of_seconds(8), context, &known);
        REQUIRE(found.closed);
        REQUIRE(found.added.size() == 1);
        CHECK(flux(found.added[0], {}) == Approx((1 - pi / 4) * 10 * radius * radius));
        return found.added[0].IsSame(known.added[0]);
    };
    CHECK(again(20, 1));
    CHECK(again(25, 1));  // the face that the fillet takes a corner from has its hole elsewhere
    CHECK_FALSE(again(20, 1.001));
}

TEST_CASE("a change between the same faces is not measured again, one of the same outline is") {
    RunContext context;
    const auto [before, after] = filleted_step(20, 1);
    ShapeDifference known = difference_of(before, after, work_of_seconds(8), context);
    known.added = {box(0, 0, 0, 1, 1, 1)};  // which is not what the fillet added
    const auto is_believed = [&](double hole_x) {
        const auto [step, fillet] = filleted_step(hole_x, 1);
        const ShapeDifference found = difference_of(step, fillet, work_of_seconds(8), context, &known);
        REQUIRE(found.added.size() == 1);
        return found.added[0].IsSame(known.added[0]);
    };
    CHECK(is_believed(20));
    CHECK_FALSE(is_believed(25));
}

namespace {

/// A plate with a hole through it, before and after a blind hole beside it.
std::array<TopoDS_Shape, 2> pocketed_plate(double hole_x, double depth) {
    const TopoDS_Shape plate = cut(box(0, 0, 0, 30, 20, 10), cylinder({hole_x, 10, -1}, {0, 0, 1}, 2, 12));
    return {plate, cut(plate, cylinder({8, 10, 10 - depth}, {0, 0, 1}, 3, 20))};
}

}  // namespace

TEST_CASE("a face of which all edges are left says where the change begins") {
    RunContext context;
    const auto [before, after] = pocketed_plate(20, 4);
    const ShapeDifference known = difference_of(before, after, work_of_seconds(8), context);
    REQUIRE(known.closed);
    const auto again = [&](double hole_x, double depth) {
        const auto [plate, pocketed] = pocketed_plate(hole_x, depth);
        const ShapeDifference found = difference_of(plate, pocketed, work_of_seconds(8), context, &known);
        REQUIRE(found.closed);
        REQUIRE(found.removed.size() == 1);
        CHECK(flux(found.removed[0], {}) == Approx(pi * 9 * depth));
        return found.removed[0].IsSame(known.removed[0]);
    };
    CHECK(again(20, 4));
    CHECK(again(24, 4));
    CHECK_FALSE(again(20, 4.001));
}

TEST_CASE("what could not be told of a change is not tried again until the change is another one") {
    RunContext context;
    const auto [before, after] = pocketed_plate(20, 4);
    ShapeDifference hopeless;
    hopeless.outline = difference_of(before, after, work_of_seconds(8), context).outline;
    CHECK(difference_of(before, after, work_of_seconds(8), context, &hopeless).closed);  // it was want of time
    hopeless.is_hopeless = true;
    CHECK_FALSE(difference_of(before, after, work_of_seconds(8), context, &hopeless).closed);
    const auto [plate, deeper] = pocketed_plate(20, 5);
    CHECK(difference_of(plate, deeper, work_of_seconds(8), context, &hopeless).closed);
    CHECK_FALSE(difference_of(before, after, 0, context).is_hopeless);
}

TEST_CASE("a shape keeps its print when others are cut with it, and no other shape has it") {
    const TopoDS_Shape tool = cylinder({5, 5, -1}, {0, 0, 1}, 2, 12);
    const std::uint64_t print = print_of(tool);
    cut(box(0, 0, 0, 10, 10, 10), tool);
    CHECK(print_of(tool) == print);
    CHECK(print_of(BRepBuilderAPI_Copy(tool).Shape()) == print);
    CHECK(print_of(cylinder({5, 5, -1}, {0, 0, 1}, 2, 12.000001)) != print);
    CHECK(print_of(cylinder({5, 5.000001, -1}, {0, 0, 1}, 2, 12)) != print);
    CHECK(print_of(tool.Reversed()) != print);
}

TEST_CASE("a difference that is not worth its time is left open, and one that is not wanted any more ends") {
    const TopoDS_Shape before = box(0, 0, 0, 20, 10, 10);
    const TopoDS_Shape after = cut(before, cylinder({15, 5, 5}, {0, 0, 1}, 2, 10));
    RunContext context;
    CHECK_FALSE(difference_of(before, after, 0, context).closed);
    context.on_progress = [](std::string_view, double) { return false; };
    CHECK_THROWS_AS(difference_of(before, after, work_of_seconds(8), context), Cancelled);
}

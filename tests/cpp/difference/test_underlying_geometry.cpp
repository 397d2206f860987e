// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/underlying_geometry.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Trsf.hxx>
#include <optional>
#include <utility>
#include <vector>

#include "catch.h"
#include "difference/feature_motion.h"
#include "difference/surface_chart.h"

using namespace featuremesh;

namespace {

std::vector<UnderlyingSurface> surfaces_of(const TopoDS_Shape& shape, SurfaceKind kind) {
    std::vector<UnderlyingSurface> surfaces;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
        if (const UnderlyingSurface surface = underlying_of(TopoDS::Face(it.Current())); surface.kind == kind)
            surfaces.push_back(surface);
    return surfaces;
}

UnderlyingSurface surface_of(const TopoDS_Shape& shape, SurfaceKind kind) {
    const auto surfaces = surfaces_of(shape, kind);
    REQUIRE_FALSE(surfaces.empty());
    return surfaces.front();
}

gp_Trsf turned_and_shifted() {
    gp_Trsf turn, shift;
    turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, -2, 2)), 0.7);
    shift.SetTranslation(gp_Vec(5, -3, 2));
    return shift * turn;
}

const gp_Ax2 askew(gp_Pnt(3, -1, 2), gp_Dir(1, 2, 2));

}  // namespace

TEST_CASE("the underlying plane is the same however the face is cut from it") {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
    const TopoDS_Shape drilled = BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeCylinder(2, 30).Shape()).Shape();
    const TopoDS_Shape longer = BRepPrimAPI_MakeBox(10, 10, 10.1).Shape();
    const auto shared = [&](const TopoDS_Shape& other) {
        int count = 0;
        for (const auto& a : surfaces_of(box, SurfaceKind::plane))
            for (const auto& b : surfaces_of(other, SurfaceKind::plane)) count += same_underlying(a, b, {});
        return count;
    };
    CHECK(shared(box) == 6);
    CHECK(shared(drilled) == 6);
    CHECK(shared(longer) == 5);
}

TEST_CASE("a moved underlying surface is that of the moved face, and only that") {
    const gp_Trsf motion = turned_and_shifted();
    const std::pair<SurfaceKind, TopoDS_Shape> cases[] = {
        {SurfaceKind::cylinder, BRepPrimAPI_MakeCylinder(askew, 2, 5).Shape()},
        {SurfaceKind::cone, BRepPrimAPI_MakeCone(askew, 3, 1, 5).Shape()},
        {SurfaceKind::sphere, BRepPrimAPI_MakeSphere(askew, 2).Shape()},
        {SurfaceKind::torus, BRepPrimAPI_MakeTorus(askew, 4, 1).Shape()},
        {SurfaceKind::plane, BRepPrimAPI_MakeBox(askew, 1, 2, 3).Shape()}};
    for (const auto& [kind, shape] : cases) {
        INFO("kind " << int(kind));
        const UnderlyingSurface here = surface_of(shape, kind);
        const UnderlyingSurface there = surface_of(BRepBuilderAPI_Transform(shape, motion, true).Shape(), kind);
        const Sameness sameness{1e-7, {3, 0, 3}, 20};
        CHECK(same_underlying(moved(here, motion), there, sameness));
        CHECK_FALSE(same_underlying(here, there, sameness));
        CHECK(sort_key(moved(here, motion), {7, 8, 9}) == Approx(sort_key(there, {7, 8, 9})));
    }
}

TEST_CASE("parameters of a point on an underlying surface give the point back") {
    const std::pair<SurfaceKind, TopoDS_Shape> cases[] = {
        {SurfaceKind::plane, BRepPrimAPI_MakeBox(askew, 1, 2, 3).Shape()},
        {SurfaceKind::cylinder, BRepPrimAPI_MakeCylinder(askew, 2, 5).Shape()},
        {SurfaceKind::cone, BRepPrimAPI_MakeCone(askew, 3, 1, 5).Shape()},
        {SurfaceKind::sphere, BRepPrimAPI_MakeSphere(askew, 2).Shape()},
        {SurfaceKind::torus, BRepPrimAPI_MakeTorus(askew, 4, 1).Shape()}};
    for (const auto& [kind, shape] : cases) {
        INFO("kind " << int(kind));
        const UnderlyingSurface surface = surface_of(shape, kind);
        const Vec3 p = point_at(surface, 0.4, 0.3);
        const auto [u, v] = parameters_of(surface, p);
        CHECK(u == Approx(0.4));
        CHECK(v == Approx(0.3));
        CHECK(distance(point_at(surface, u, v), p) < 1e-12);
    }
}

TEST_CASE("radii and axes that differ make other surfaces") {
    const auto cylinder = [](const gp_Ax2& axis, double radius) {
        return surface_of(BRepPrimAPI_MakeCylinder(axis, radius, 5).Shape(), SurfaceKind::cylinder);
    };
    const UnderlyingSurface one = cylinder(askew, 2);
    CHECK(same_underlying(one, cylinder(askew.Translated(gp_Vec(askew.Direction()) * 7), 2), {}));
    CHECK_FALSE(same_underlying(one, cylinder(askew, 2.0001), {}));
    CHECK_FALSE(same_underlying(one, cylinder(askew.Translated(gp_Vec(1e-4, 0, 0)), 2), {}));
    CHECK(same_sense(one, cylinder(gp_Ax2(askew.Location(), askew.Direction().Reversed()), 2)));
    CHECK(same_underlying(one, cylinder(gp_Ax2(askew.Location(), askew.Direction().Reversed()), 2), {}));
}

TEST_CASE("lines and circles are the same whatever stretch and direction an edge has") {
    const auto line = [](gp_Pnt a, gp_Pnt b) { return underlying_of(BRepBuilderAPI_MakeEdge(a, b).Edge()); };
    const UnderlyingCurve along = line({0, 0, 0}, {1, 1, 0}), further = line({2, 2, 0}, {5, 5, 0}),
                          against = line({5, 5, 0}, {4, 4, 0}), beside = line({0, 0, 1e-4}, {1, 1, 1e-4});
    CHECK(same_underlying(along, further, {}));
    CHECK(same_underlying(along, against, {}));
    CHECK_FALSE(same_underlying(along, beside, {}));
    CHECK(same_direction(along, further));
    CHECK_FALSE(same_direction(along, against));
    CHECK(distance(point_at(along, parameter_of(along, {3, 3, 0})), {3, 3, 0}) < 1e-12);

    const auto arc = [](double radius, double from, double to) {
        return underlying_of(BRepBuilderAPI_MakeEdge(gp_Circ(askew, radius), from, to).Edge());
    };
    CHECK(same_underlying(arc(2, 0, 1), arc(2, 2, 5), {}));
    CHECK_FALSE(same_underlying(arc(2, 0, 1), arc(2.001, 0, 1), {}));
}

TEST_CASE("parameters of points on a spline surface are found inside and along its ends") {
    TColgp_Array2OfPnt points(1, 9, 1, 7);
    for (int i = 1; i <= 9; ++i)
        for (int j = 1; j <= 7; ++j)
            points(i, j) = gp_Pnt(10.0 * i, 8.0 * j, 6 * std::sin(0.9 * i) * std::cos(0.7 * j));
    const Handle(Geom_BSplineSurface) surface = GeomAPI_PointsToBSplineSurface(points).Surface();
    const gp_Trsf motion = turned_and_shifted();
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
    SurfaceChart chart(underlying_of(TopoDS::Face(face.Moved(TopLoc_Location(motion)))));
    UvBox all;
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    surface->Bounds(u0, u1, v0, v1);
    all.add({u0, v0}), all.add({u1, v1});
    chart.start_searches_in(all);
    const Uv corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.1, 0.2}};
    std::optional<Uv> last;
    for (int side = 0; side < 4; ++side)
        for (int i = 0; i <= 20; ++i) {  // round the border, then across
            const double t = i / 20.0;
            const Uv &from = corners[side], &to = corners[side + 1];
            const Uv uv = all.at(from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]));
            const gp_Pnt p = surface->Value(uv[0], uv[1]).Transformed(motion);
            const Vec3 point{p.X(), p.Y(), p.Z()};
            last = chart.parameters(point, last);
            REQUIRE(last);
            CHECK(distance(chart.point(*last), point) < 1e-6);
            CHECK(std::abs((*last)[0] - uv[0]) < 1e-6 * (u1 - u0));
            CHECK(std::abs((*last)[1] - uv[1]) < 1e-6 * (v1 - v0));
        }
    CHECK_FALSE(chart.parameters({50, 30, 1000}, last));
}

TEST_CASE("volumes without edges, of which no points are known, are no image of one another") {
    VolumeOutline small, large;
    small.faces.resize(1), large.faces.resize(1);
    small.faces[0].kind = large.faces[0].kind = SurfaceKind::sphere;
    small.faces[0].radius = 1, large.faces[0].radius = 2;
    CHECK_FALSE(motion_between(small, large, RigidMotion{}, {1e-7, {0, 0, 0}, 10}).has_value());
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/volumes/patch_volumes.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <numbers>

#include "brep/same_faces.h"
#include "brep/shapes.h"
#include "brep/volumes/flux.h"
#include "catch.h"

using namespace featuremesh;
using namespace featuremesh::test;
constexpr double pi = std::numbers::pi;

namespace {

/// The volumes between two shapes, whose sharing of faces is lost as it is in a saved document.
std::optional<PatchVolumes> between(const TopoDS_Shape& before, const TopoDS_Shape& shape) {
    const TopoDS_Shape after = BRepBuilderAPI_Copy(shape).Shape();
    const auto vanished = unshared_faces(before, after), appeared = unshared_faces(after, before);
    const auto fluxes = [](const std::vector<TopoDS_Shape>& faces) {
        std::vector<double> list;
        for (const TopoDS_Shape& face : faces) list.push_back(flux(face, {1, 2, 3}));
        return list;
    };
    const auto found = patch_volumes({vanished, appeared, fluxes(vanished), fluxes(appeared), {1, 2, 3}});
    if (!found) return found;
    CHECK(found->change == Approx(flux(after, {}) - flux(before, {})).margin(1e-6));
    for (const auto& solids : {found->added, found->removed})
        for (const TopoDS_Shape& solid : solids) {
            CHECK(flux(solid, {}) > 0);
            CHECK(BRepCheck_Analyzer(solid).IsValid());
        }
    return found;
}

double sum(const std::vector<TopoDS_Shape>& solids) {
    double volume = 0;
    for (const TopoDS_Shape& solid : solids) volume += flux(solid, {});
    return volume;
}

std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, TopAbs_EDGE, map);
    std::vector<TopoDS_Edge> edges;
    for (int i = 1; i <= map.Extent(); ++i) edges.push_back(TopoDS::Edge(map(i)));
    return edges;
}

Vec3 middle_of(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    const gp_Pnt p = curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2);
    return {p.X(), p.Y(), p.Z()};
}

template <class Wanted>
TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius, Wanted wanted) {
    BRepFilletAPI_MakeFillet fillet(shape);
    for (const TopoDS_Edge& edge : edges_of(shape))
        if (wanted(middle_of(edge))) fillet.Add(radius, edge);
    return fillet.Shape();
}

template <class Wanted>
TopoDS_Shape chamfered(const TopoDS_Shape& shape, double distance, Wanted wanted) {
    BRepFilletAPI_MakeChamfer chamfer(shape);
    for (const TopoDS_Edge& edge : edges_of(shape))
        if (wanted(edge)) chamfer.Add(distance, edge);
    return chamfer.Shape();
}

bool is_circle(const TopoDS_Edge& edge) { return BRepAdaptor_Curve(edge).GetType() == GeomAbs_Circle; }

}  // namespace

TEST_CASE("a fillet is bounded by its face and by what its neighbours lost") {
    const TopoDS_Shape block = box(0, 0, 0, 20, 10, 10);
    const auto one = between(block, rounded(block, 2, [](const Vec3& p) { return p.x == 20 && p.z == 10; }));
    REQUIRE(one);
    CHECK(one->added.empty());
    REQUIRE(one->removed.size() == 1);
    CHECK(sum(one->removed) == Approx((1 - pi / 4) * 4 * 10));
    const auto two = between(block, rounded(block, 2, [](const Vec3& p) { return p.x != 10 && p.z == 10; }));
    REQUIRE(two);
    CHECK(two->removed.size() == 2);
    // With spheres in the corners, and no face left as it was.
    const auto all = between(block, rounded(block, 2, [](const Vec3&) { return true; }));
    REQUIRE(all);
    CHECK(all->removed.size() == 1);
    CHECK(sum(all->removed) ==
          Approx(2000 - (16 * 6 * 6 + 2 * 2 * (16 * 6 * 2 + 6 * 6) + pi * 4 * (16 + 6 + 6) + 4 * pi / 3 * 8)));
}

TEST_CASE("a concave fillet and a convex one in one feature") {
    const TopoDS_Shape step = fused(box(0, 0, 0, 20, 10, 10), box(0, 0, 10, 10, 10, 10));
    const auto found = between(
        step, rounded(step, 2, [](const Vec3& p) { return p.y == 5 && p.z == 10 && (p.x == 10 || p.x == 20); }));
    REQUIRE(found);
    REQUIRE(found->added.size() == 1);
    REQUIRE(found->removed.size() == 1);
    CHECK(sum(found->added) == Approx((1 - pi / 4) * 40));
    CHECK(sum(found->removed) == Approx((1 - pi / 4) * 40));
}

TEST_CASE("rings around a shaft and around holes") {
    const double ring = pi * 25 - pi / 3 * (25 + 20 + 16);  // 1 mm off a radius of 5
    const TopoDS_Shape shaft = cylinder({0, 0, 0}, {0, 0, 1}, 5, 10);
    const auto ends = between(shaft, chamfered(shaft, 1, is_circle));
    REQUIRE(ends);
    CHECK(ends->removed.size() == 2);
    CHECK(sum(ends->removed) == Approx(2 * ring));
    const TopoDS_Shape plate = cut(cut(box(0, 0, 0, 40, 20, 10), cylinder({10, 10, -1}, {0, 0, 1}, 5, 12)),
                                   cylinder({30, 10, -1}, {0, 0, 1}, 5, 12));
    const auto holes = between(plate, chamfered(plate, 1, is_circle));
    REQUIRE(holes);
    CHECK(holes->removed.size() == 4);
    CHECK(sum(holes->removed) == Approx(4 * (pi / 3 * (25 + 30 + 36) - pi * 25)));
}

TEST_CASE("a pocket, a boss and a hole that opens others") {
    const TopoDS_Shape block = cut(box(0, 0, 0, 20, 20, 10), cylinder({-1, 10, 5}, {1, 0, 0}, 2, 22));
    const auto change =
        between(block, fused(cut(block, cylinder({10, 10, 2}, {0, 0, 1}, 1, 10)), box(2, 2, 8, 4, 4, 6)));
    REQUIRE(change);
    CHECK(change->removed.size() == 2);
    CHECK(sum(change->added) == Approx(4 * 4 * 4));
}

TEST_CASE("a cut through the corner where a fillet and a pad end") {
    const TopoDS_Shape block =
        rounded(box(0, 0, 0, 20, 10, 10), 2, [](const Vec3& p) { return p.x == 20 && p.z == 10; });
    const auto found = between(block, cut(block, box(15, 0, 5, 5, 4, 5)));
    REQUIRE(found);
    REQUIRE(found->removed.size() == 1);
    CHECK(sum(found->removed) == Approx(5 * 4 * 5 - (1 - pi / 4) * 4 * 4));
}

TEST_CASE("what is not told by edges is left to others") {
    SECTION("a side that is turned about a line in its middle crosses the one it was") {
        const TopoDS_Shape upright = box(0, 0, 0, 10, 10, 10);
        const TopoDS_Shape slanting = BRepPrimAPI_MakeWedge(10, 10, 10, 0, 0, 9, 10).Shape();
        const TopoDS_Shape turned = BRepBuilderAPI_Transform(slanting,
                                                             [] {
                                                                 gp_Trsf shift;
                                                                 shift.SetTranslation({0.5, 0, 0});
                                                                 return shift;
                                                             }())
                                        .Shape();
        CHECK_FALSE(between(upright, turned));
    }
    SECTION("a hollow removed around a core that stays") {
        const TopoDS_Shape block = box(0, 0, 0, 10, 10, 10);
        const TopoDS_Shape shell = cut(box(2, 2, 2, 6, 6, 6), box(4, 4, 4, 2, 2, 2));
        CHECK_FALSE(between(block, cut(block, shell)));
    }
    SECTION("two parts removed that touch each other in a line within a face") {
        const TopoDS_Wire triangle = BRepBuilderAPI_MakePolygon(gp_Pnt(0, 5, 0), {10, 0, 0}, {10, 10, 0}, true);
        const TopoDS_Shape rest =
            BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(triangle).Face(), gp_Vec(0, 0, 10)).Shape();
        CHECK_FALSE(between(box(0, 0, 0, 10, 10, 10), rest));
    }
    SECTION("a rounding that reaches over the end of an edge that goes through it") {
        const TopoDS_Shape block = box(0, 0, 0, 10, 10, 10);
        const TopoDS_Shape post = fused(block, box(4, 4, 8, 2, 2, 6));
        CHECK_FALSE(between(post, fused(block, cylinder({5, 5, 8}, {0, 0, 1}, 1.2, 6))));
    }
    SECTION("a shaft made anew with its seam elsewhere") {
        const TopoDS_Shape shaft = cylinder({0, 0, 0}, {0, 0, 1}, 5, 10);
        const TopoDS_Shape shorter = BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, 0}, {0, 0, 1}, {0, 1, 0}), 5, 8).Shape();
        CHECK_FALSE(between(shaft, shorter));
    }
}

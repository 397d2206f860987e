// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/volumes/period_shifts.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "brep/occt_geometry.h"
#include "brep/same_faces.h"
#include "brep/shapes.h"
#include "brep/volumes/flux.h"
#include "brep/volumes/patch_volumes.h"
#include "brep/volumes/sheet_contacts.h"
#include "catch.h"

using namespace featuremesh;
using namespace featuremesh::test;
constexpr double turn = 2 * std::numbers::pi;

namespace {

/// The shape with the curves of some edges on its faces of a kind moved in their parameters: bit k of `which` is for
/// the k-th edge of a face.
TopoDS_Shape torn(const TopoDS_Shape& shape, GeomAbs_SurfaceType kind, unsigned which, gp_Vec2d by) {
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape).Shape();
    for (TopExp_Explorer face(copy, TopAbs_FACE); face.More(); face.Next()) {
        const TopoDS_Face& on = TopoDS::Face(face.Current());
        if (BRepAdaptor_Surface(on).GetType() != kind) continue;
        unsigned k = 0;
        for (TopExp_Explorer edge(on, TopAbs_EDGE); edge.More(); edge.Next(), ++k) {
            if (!(which >> k & 1)) continue;
            double first = 0, last = 0;
            const auto curve = BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Current()), on, first, last);
            BRep_Builder().UpdateEdge(TopoDS::Edge(edge.Current()),
                                      Handle(Geom2d_Curve)::DownCast(curve->Translated(by)), on, 1e-7);
        }
    }
    return copy;
}

TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius, const gp_Pnt& on_edge) {
    BRepFilletAPI_MakeFillet fillet(shape);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const auto curve = BRepAdaptor_Curve(TopoDS::Edge(edges(i)));
        if (curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2).Distance(on_edge) < 1e-6)
            fillet.Add(radius, TopoDS::Edge(edges(i)));
    }
    return fillet.Shape();
}

TopoDS_Shape block_with_fillet() { return rounded(box(0, 0, 0, 20, 10, 10), 2, {20, 5, 10}); }

/// Half a shaft along z, the rim of its upper end rounded by a torus.
TopoDS_Shape half_shaft() {
    return rounded(cut(cylinder({0, 0, 0}, {0, 0, 1}, 5, 10), box(-6, -6, -1, 12, 6, 12)), 2, {0, 5, 10});
}

std::vector<std::array<double, 2>> shifts_of(const std::vector<BorderStep>& border, const Parameters& period) {
    std::vector<std::array<double, 2>> list;
    for (const Parameters& shift : period_shifts(border, period)) list.push_back({shift.u, shift.v});
    return list;
}

}  // namespace

TEST_CASE("steps a period apart are brought beside one another, in any order of the border") {
    std::vector<BorderStep> border{
        {1, 2, {0, 0}, {1, 0}}, {2, 3, {7, 0}, {7, 4}}, {3, 4, {7, 4}, {6, 4}}, {4, 1, {0, 4}, {0, 0}}};
    using List = std::vector<std::array<double, 2>>;
    CHECK(shifts_of(border, {6, 0}) == List{{0, 0}, {-6, 0}, {-6, 0}, {0, 0}});
    std::swap(border[1], border[2]);
    CHECK(shifts_of(border, {6, 0}) == List{{0, 0}, {-6, 0}, {-6, 0}, {0, 0}});
    CHECK(shifts_of(border, {0, 0}) == List(4));
    border[0].end.u = 1.5;  // not whole periods
    border[3].end.u = 0.5;
    CHECK(shifts_of(border, {6, 0}) == List{{0, 0}, {0, 0}, {0, 0}, {6, 0}});
}

TEST_CASE("the two sides of a seam stay where they are") {
    const std::vector<BorderStep> shaft{
        {1, 1, {0, 0}, {6, 0}}, {1, 2, {6, 0}, {6, 4}}, {2, 2, {6, 4}, {0, 4}}, {2, 1, {0, 4}, {0, 0}}};
    for (const std::array<double, 2>& shift : shifts_of(shaft, {6, 0})) CHECK(shift == std::array<double, 2>{});
}

TEST_CASE("volumes are right where curves of a face lie a period apart") {
    const TopoDS_Shape block = block_with_fillet(), shaft = half_shaft();
    for (unsigned which = 1; which < 15; ++which)
        for (const Vec3 apex : {Vec3{1, 2, 3}, Vec3{30, -40, 50}}) {
            CHECK(flux(torn(block, GeomAbs_Cylinder, which, {turn, 0}), apex) == Approx(flux(block, {})).epsilon(1e-9));
            CHECK(flux(torn(shaft, GeomAbs_Torus, which, {-turn, 0}), apex) == Approx(flux(shaft, {})).epsilon(1e-9));
            CHECK(flux(torn(shaft, GeomAbs_Torus, which, {0, turn}), apex) == Approx(flux(shaft, {})).epsilon(1e-9));
        }
}

TEST_CASE("what a feature removed is told where curves of a face lie a period apart") {
    const TopoDS_Shape block = block_with_fillet(), after = cut(block, box(15, 0, 5, 5, 4, 5));
    for (unsigned which = 1; which < 15; ++which) {
        const TopoDS_Shape before = torn(block, GeomAbs_Cylinder, which, {-turn, 0});
        const auto vanished = unshared_faces(before, after), appeared = unshared_faces(after, before);
        const auto fluxes = [](const std::vector<TopoDS_Shape>& faces) {
            std::vector<double> list;
            for (const TopoDS_Shape& face : faces) list.push_back(flux(face, {1, 2, 3}));
            return list;
        };
        const auto found = patch_volumes({vanished, appeared, fluxes(vanished), fluxes(appeared), {1, 2, 3}});
        REQUIRE(found);
        REQUIRE(found->removed.size() == 1);
        CHECK(flux(found->removed.front(), {}) == Approx(5 * 4 * 5 - (4 - std::numbers::pi) * 4));
        CHECK(BRepCheck_Analyzer(found->removed.front()).IsValid());
    }
}

TEST_CASE("what goes through a face beyond one period of its surface is seen") {
    TColgp_Array1OfPnt bulging(1, 4);
    for (int i = 0; i < 4; ++i) bulging.SetValue(i + 1, gp_Pnt(10 + (i == 1 ? 4 : 0), 0, 7.0 * i));
    const Handle(Geom_Surface) round =
        new Geom_SurfaceOfRevolution(GeomAPI_PointsToBSpline(bulging).Curve(), gp_Ax1(gp_Pnt(), gp::DZ()));
    const TopoDS_Face wall = BRepBuilderAPI_MakeFace(round, 0.75 * turn, 1.25 * turn, 0, 1, 1e-7).Face();
    const auto is_met = [&](double angle) {
        gp_Trsf to_angle;
        to_angle.SetRotation(gp_Ax1(gp_Pnt(), gp::DZ()), angle);
        std::vector<PatchFace> faces{{wall, true, -1, 0}};
        const TopoDS_Shape beam = box(1, -1, 9, 30, 2, 2).Moved(TopLoc_Location(to_angle));
        for (TopExp_Explorer it(beam, TopAbs_FACE); it.More(); it.Next())
            faces.push_back({TopoDS::Face(it.Current()), false, -1, faces.size() - 1});
        const MergedEdges edges(faces);
        ContactSheet sheet{wall, box_of(wall), true, {}};
        for (const MergedEdges::Use& use : edges.wires_of(0).front()) sheet.border.push_back(use.piece);
        return any_contact({sheet}, faces, edges);
    };
    for (const double angle : {-1.2, -0.5, 0.0, 0.5, 1.2}) CHECK(is_met(angle));
    for (const double angle : {-2.0, 3.0, 2.0}) CHECK_FALSE(is_met(angle));
}

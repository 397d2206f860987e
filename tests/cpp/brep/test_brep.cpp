// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Ax1.hxx>
#include <gp_Pln.hxx>
#include <numbers>

#include "brep/brep.h"
#include "brep/occt_geometry.h"
#include "catch.h"
#include "core/errors.h"

using namespace featuremesh;

TEST_CASE("a box is numbered and its faces know their sides") {
    const Brep box(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
    CHECK(box.solid_count() == 1);
    CHECK(box.face_count() == 6);
    CHECK(box.edge_count() == 12);
    CHECK(box.vertex_count() == 8);
    CHECK(box.volume_of(SolidId(0)) == Approx(6));
    CHECK(box.box().diagonal() == Approx(std::sqrt(14.0)).epsilon(1e-6));
    for (std::size_t f = 0; f < box.face_count(); ++f) {
        CHECK(box.solids_beside(FaceId(f)) == std::array<SolidId, 2>{SolidId(0), SolidId()});
        CHECK(box.edges_of(FaceId(f)).size() == 4);
        CHECK(box.find(box.face(FaceId(f))) == FaceId(f));
    }
    for (std::size_t e = 0; e < box.edge_count(); ++e) CHECK(box.faces_of(EdgeId(e)).size() == 2);
    for (std::size_t v = 0; v < box.vertex_count(); ++v) CHECK(box.edges_of(VertexId(v)).size() == 3);
    CHECK(name_of(entity_of(FaceId(0))) == "Face1");
}

TEST_CASE("a cylinder has a seam and a sphere has degenerated edges") {
    const Brep cylinder(BRepPrimAPI_MakeCylinder(2, 5).Shape());
    int seams = 0;
    for (std::size_t e = 0; e < cylinder.edge_count(); ++e)
        for (const FaceId f : cylinder.faces_of(EdgeId(e))) seams += cylinder.is_seam(EdgeId(e), f);
    CHECK(seams == 1);
    const Brep sphere(BRepPrimAPI_MakeSphere(1).Shape());
    int poles = 0;
    for (std::size_t e = 0; e < sphere.edge_count(); ++e) poles += sphere.is_degenerated(EdgeId(e));
    CHECK(poles == 2);
    CHECK(sphere.volume_of(SolidId(0)) == Approx(4 * std::numbers::pi / 3));
}

TEST_CASE("the box of a swept, a turned, an offset and a cut face holds what bulges between samples of it") {
    // of 33 points by parameter none is at a crest
    TColgp_Array1OfPnt points(1, 8);
    for (int i = 1; i <= 8; ++i) points.SetValue(i, gp_Pnt(3.0 * i + 0.1 * i * i, 10 + 3 * std::cos(2.7 * i), 0));
    const TopoDS_Edge wave =
        BRepBuilderAPI_MakeEdge(Handle(Geom_Curve)(GeomAPI_PointsToBSpline(points).Curve())).Edge();
    const TopoDS_Face swept = TopoDS::Face(BRepPrimAPI_MakePrism(wave, gp_Vec(0, 0.3, 5)).Shape());
    const TopoDS_Face turned =
        TopoDS::Face(BRepPrimAPI_MakeRevol(wave, gp_Ax1(gp::Origin(), gp::DX()), std::numbers::pi * 1.23).Shape());
    const TopoDS_Face offset =
        BRepBuilderAPI_MakeFace(new Geom_OffsetSurface(BRep_Tool::Surface(swept), 0.5), 1e-7).Face();
    TColgp_Array2OfPnt poles(1, 8, 1, 2);
    for (int i = 1; i <= 8; ++i)
        for (int j = 1; j <= 2; ++j) poles.SetValue(i, j, points(i).Translated(gp_Vec(0, 0, 5 * j)));
    const TopoDS_Face cut = BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 0.1, 0.83, 0, 1, 1e-7).Face();
    for (const TopoDS_Face& face : {swept, turned, offset, cut}) {
        const BRepAdaptor_Surface surface(face);
        const Box box = box_of(face);
        Box found;
        for (int i = 0; i <= 2000; ++i)
            for (int j = 0; j <= 200; ++j)
                found.add(to_vec3(
                    surface.Value(surface.FirstUParameter() + (surface.LastUParameter() - surface.FirstUParameter()) *
                                                                  (turned.IsSame(face) ? j / 200.0 : i / 2000.0),
                                  surface.FirstVParameter() + (surface.LastVParameter() - surface.FirstVParameter()) *
                                                                  (turned.IsSame(face) ? i / 2000.0 : j / 200.0))));
        INFO("a face of the kernel's type " << surface.GetType());
        CHECK(box.contains(found.low));
        CHECK(box.contains(found.high));
        CHECK(box.diagonal() < 1.1 * found.diagonal());
    }
}

TEST_CASE("a loose vertex is where all its edges reach it, when its tolerance and its faces have such a place") {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
    const Brep tight(box);
    const BRep_Builder builder;
    double first, last;
    BRep_Tool::Range(tight.edge(EdgeId(0)), first, last);
    const VertexId loose = tight.ends_of(EdgeId(0))[0];
    const Vec3 corner = tight.point_of(loose), along = normalized(tight.point_of(tight.ends_of(EdgeId(0))[1]) - corner);
    const auto place_with_gap = [&](double gap, double tolerance) {
        builder.Range(tight.edge(EdgeId(0)), first + gap, last);
        builder.UpdateVertex(tight.vertex(loose), tolerance);
        return Brep(box);
    };
    SECTION("moved") {
        const Brep brep = place_with_gap(1.6e-7, 1e-5);
        const Vec3 moved = brep.point_of(loose) - corner;
        CHECK(dot(moved, along) > 0.6e-7);
        CHECK(length(moved) < 1e-7);
        CHECK(brep.distance_from(loose, corner) == 0);
        CHECK(brep.distance_from(loose, brep.point_of(loose)) == 0);
    }
    SECTION("left where it would leave the face across the edge") {
        CHECK(place_with_gap(4e-6, 1e-5).point_of(loose) == corner);
    }
    SECTION("left where its edges reach it") { CHECK(place_with_gap(0.9e-7, 1e-5).point_of(loose) == corner); }
}

TEST_CASE("an open shell and a missing solid are refused by name") {
    TopoDS_Shell shell;
    BRep_Builder builder;
    builder.MakeShell(shell);
    int count = 0;
    for (TopExp_Explorer it(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), TopAbs_FACE); it.More() && count < 5;
         it.Next(), ++count)
        builder.Add(shell, it.Current());
    CHECK_THROWS_WITH(Brep(BRepBuilderAPI_MakeSolid(shell).Shape()), Catch::Matchers::Contains("open at Edge"));
    CHECK_THROWS_AS(Brep(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 1, 0, 1).Shape()), InputError);
    CHECK_THROWS_AS(Brep(TopoDS_Shape()), InputError);
}

TEST_CASE("an edge without a curve is named") {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    Handle(BRep_TEdge)::DownCast(Brep(box).edge(EdgeId(4)).TShape())->ChangeCurves().Clear();
    CHECK_THROWS_WITH(Brep(box), Catch::Matchers::Contains("Edge5 has no curve"));
}

TEST_CASE("a face drawn into a solid bounds nothing and leaves its shell closed") {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
    const TopoDS_Shape drawn = BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(5, 5, 5), gp::DZ()), -2, 2, -2, 2).Shape();
    TopoDS_Shell shell;
    TopoDS_Solid solid;
    BRep_Builder builder;
    builder.MakeShell(shell);
    builder.Add(shell, drawn.Oriented(TopAbs_INTERNAL));
    builder.MakeSolid(solid);
    builder.Add(solid, TopExp_Explorer(box, TopAbs_SHELL).Current());
    builder.Add(solid, shell);
    for (const Dimension dimension : {Dimension::solids, Dimension::from_shape}) {
        const Brep brep(solid, dimension);
        CHECK(brep.volume() == Approx(1000));
        CHECK(brep.face_count() == 7);
        const FaceId face = brep.find(TopoDS::Face(drawn));
        REQUIRE(face.is_valid());
        CHECK(!brep.is_meshed(face));
        for (const EdgeId edge : brep.edges_of(face)) CHECK(!brep.is_meshed(edge));
    }
}

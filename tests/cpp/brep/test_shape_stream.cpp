// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/shape_stream.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include "brep/brep.h"
#include "brep/written_shapes.h"
#include "catch.h"
#include "core/errors.h"

using namespace featuremesh;
using featuremesh::test::write_shapes;

TEST_CASE("shapes survive the way FreeCAD writes them, with what they share") {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    const TopoDS_Shape cut = BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeCylinder(0.2, 0.5).Shape()).Shape();
    const std::vector<TopoDS_Shape> shapes{box, TopoDS_Shape(), cut};
    const auto bytes = write_shapes(shapes);
    const auto back = read_shapes(bytes);
    REQUIRE(back.size() == 3);
    CHECK(back[0].ShapeType() == TopAbs_SOLID);
    CHECK_FALSE(TopExp_Explorer(back[1], TopAbs_FACE).More());
    int shared = 0;
    for (TopExp_Explorer a(back[0], TopAbs_FACE); a.More(); a.Next())
        for (TopExp_Explorer b(back[2], TopAbs_FACE); b.More(); b.Next()) shared += a.Current().IsSame(b.Current());
    CHECK(shared >= 3);
    CHECK_THROWS_AS(read_shapes(std::vector<std::byte>(100)), StateError);
    CHECK_THROWS_AS(read_shapes({}), StateError);
}

TEST_CASE("shapes that are read say when they are in the same place, or in none of their own") {
    const TopoDS_Shape solid = BRepPrimAPI_MakeBox(1, 2, 3).Solid();
    const auto placed = [&](double x) {
        gp_Trsf motion;
        motion.SetTranslation({x, 0, 0});
        return solid.Located(TopLoc_Location(motion));  // a location of its own each time, as FreeCAD's
    };
    const std::vector<TopoDS_Shape> shapes{placed(0), placed(5), placed(5), placed(6)};
    REQUIRE_FALSE(shapes[1].IsSame(shapes[2]));
    const auto back = read_shapes(write_shapes(shapes));
    CHECK(back[0].Location().IsIdentity());
    CHECK(back[1].IsSame(back[2]));
    CHECK_FALSE(back[2].IsSame(back[3]));
    CHECK(Brep(back[3]).box().low.x == Approx(6));
}

TEST_CASE("two solids in one place have as many faces as for FreeCAD") {
    const TopoDS_Shape solid = BRepPrimAPI_MakeBox(1, 2, 3).Solid();
    const auto own_place = [](const TopoDS_Shape& shape) { return shape.Located(TopLoc_Location(gp_Trsf())); };
    const auto together = [](const std::vector<TopoDS_Shape>& shapes) {
        TopoDS_Compound all;
        BRep_Builder().MakeCompound(all);
        for (const TopoDS_Shape& shape : shapes) BRep_Builder().Add(all, shape);
        return all;
    };
    const TopoDS_Shape placed = own_place(solid);
    const auto back = read_shapes(write_shapes(std::vector<TopoDS_Shape>{
        solid, together({solid, own_place(solid)}), together({placed, together({placed, own_place(solid)}), solid}),
        together({solid, solid})}));
    CHECK(Brep(back[0]).face_count() == 6);
    CHECK(Brep(back[1]).face_count() == 12);
    CHECK(Brep(back[2]).face_count() == 18);
    CHECK(Brep(back[3]).face_count() == 6);
    CHECK(Brep(back[1]).box().high.z == Approx(3));
}

TEST_CASE("chains of placements that come to nothing are gone after reading, and what is shared stays shared") {
    const auto placement = [](double x, double angle) {  // each an object of its own
        gp_Trsf turn, shift;
        turn.SetRotation(gp_Ax1(gp_Pnt(1, 0, 0), gp_Dir(0, 0, 1)), angle);
        shift.SetTranslation(gp_Vec(x, 2, 0));
        return TopLoc_Location(shift * turn);
    };
    const TopoDS_Shape tool = BRepPrimAPI_MakeCylinder(0.5, 4).Shape().Located(placement(0.3, 0.2) * placement(1, 0.7));
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, 0), 10, 10, 2)
                                   .Shape()
                                   .Located(TopLoc_Location(gp_Trsf()) * placement(1, 0.7));
    const TopoDS_Shape part = BRepAlgoAPI_Cut(block, tool).Shape();
    const std::vector<TopoDS_Shape> shapes{part.Moved(placement(4, 1) * placement(4, 1).Inverted()),
                                           part.Moved(TopLoc_Location(gp_Trsf())), part.Moved(placement(4, 1))};
    const auto back = read_shapes(write_shapes(shapes));
    REQUIRE(back.size() == 3);
    CHECK(back[0].IsSame(back[1]));
    CHECK(back[0].IsPartner(back[2]));
    CHECK_FALSE(back[0].IsSame(back[2]));
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Brep before(shapes[i]), after(back[i]);  // an open shell would be refused
        CHECK(after.edge_count() == before.edge_count());
        REQUIRE(after.face_count() == before.face_count());
        CHECK(after.volume_of(SolidId(0)) == Approx(before.volume_of(SolidId(0))).epsilon(1e-12));
        CHECK(distance(after.box().center(), before.box().center()) < 1e-12);
        CHECK(BRepCheck_Analyzer(back[i]).IsValid());
        int smooth = 0, smooth_before = 0;
        for (std::size_t e = 0; e < after.edge_count(); ++e) {
            for (const FaceId f : after.faces_of(EdgeId(e)))
                smooth += BRep_Tool::HasContinuity(after.edge(EdgeId(e)), after.face(f), after.face(f));
            for (const FaceId f : before.faces_of(EdgeId(e)))
                smooth_before += BRep_Tool::HasContinuity(before.edge(EdgeId(e)), before.face(f), before.face(f));
        }
        CHECK(smooth == smooth_before);
        CHECK(smooth > 0);
        for (std::size_t f = 0; f < after.face_count(); ++f)
            for (TopExp_Explorer it(after.face(FaceId(f)), TopAbs_EDGE); it.More(); it.Next()) {
                double first = 0, last = 0;
                CHECK_FALSE(
                    BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), after.face(FaceId(f)), first, last).IsNull());
            }
    }
}

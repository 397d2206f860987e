// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/face_trim.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Trsf.hxx>
#include <random>
#include <vector>

#include "brep/shapes.h"
#include "catch.h"

using namespace featuremesh;
using namespace featuremesh::test;

namespace {

TopoDS_Shape plate_with_holes(int count) {
    TopoDS_Shape plate = box(0, 0, 0, 10.0 * count, 10, 2);
    for (int i = 0; i < count; ++i) plate = cut(plate, cylinder({10.0 * i + 5, 5, -1}, {0, 0, 1}, 2, 4));
    return plate;
}

/// An L whose corner is cut off, with a square window.
TopoDS_Shape prism() {
    BRepBuilderAPI_MakePolygon outline;
    for (const auto& [x, y] :
         {std::pair{0.0, 0.0}, {9.0, 0.0}, {9.0, 3.0}, {4.0, 3.0}, {3.0, 4.0}, {3.0, 8.0}, {0.0, 8.0}})
        outline.Add(gp_Pnt(x, y, 0));
    outline.Close();
    const TopoDS_Shape whole =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 5)).Shape();
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1({1, 2, 3}, {1, 1, 0}), 0.7);
    return BRepBuilderAPI_Transform(cut(whole, box(0.5, 0.5, -1, 1.5, 1.5, 9)), turn, true).Shape();
}

TopoDS_Shape rounded_box() {
    const TopoDS_Shape whole = box(0, 0, 0, 6, 5, 4);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(whole, TopAbs_EDGE, edges);
    BRepFilletAPI_MakeFillet fillet(whole);
    for (int i = 1; i <= edges.Extent(); ++i) fillet.Add(1, TopoDS::Edge(edges(i)));
    return fillet.Shape();
}

}  // namespace

TEST_CASE("a trim has the parameters that the kernel's classifier finds in it") {
    const std::vector<TopoDS_Shape> shapes{
        prism(),
        rounded_box(),
        plate_with_holes(2),
        plate_with_holes(20),
        cylinder({1, 2, 3}, {1, 2, 1}, 2, 5),
        BRepPrimAPI_MakeCone(3, 1, 4).Solid(),
        BRepPrimAPI_MakeSphere(3.0).Solid(),
        BRepPrimAPI_MakeTorus(5, 1).Solid(),
        cut(cylinder({0, 0, 0}, {0, 0, 1}, 3, 8), cylinder({-5, 0, 4}, {1, 0, 0}, 1, 10)),
        cut(cylinder({0, 0, 0}, {0, 0, 1}, 3, 8), box(0, 0, 2, 9, 9, 9)),
    };
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(-0.2, 1.2);
    std::size_t faces = 0;
    for (const TopoDS_Shape& shape : shapes)
        for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next(), ++faces) {
            const TopoDS_Face& face = TopoDS::Face(it.Current());
            const FaceTrim trim(face);
            const BRepTopAdaptor_FClass2d kernel(face, 1e-9);
            double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
            BRepTools::UVBounds(face, u1, u2, v1, v2);
            int unlike = 0;
            for (int i = 0; i < 300; ++i) {
                const double u = u1 + share(random) * (u2 - u1), v = v1 + share(random) * (v2 - v1);
                unlike += trim.has(u, v) != (kernel.Perform({u, v}) != TopAbs_OUT);
            }
            CAPTURE(faces, u1, u2, v1, v2);
            CHECK(unlike == 0);
        }
    CHECK(faces > 80);
}

TEST_CASE("the border of a trim is told from what is inside and outside") {
    const TopoDS_Shape part = cylinder({0, 0, 0}, {0, 0, 1}, 2, 5);
    for (TopExp_Explorer it(part, TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face& face = TopoDS::Face(it.Current());
        const FaceTrim trim(face);
        double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
        BRepTools::UVBounds(face, u1, u2, v1, v2);
        const double u = 0.5 * (u1 + u2), v = 0.5 * (v1 + v2);
        CHECK(trim.containment_of(u, v) == Containment::inside);
        CHECK(trim.containment_of(u, v1) == Containment::on);
        CHECK(trim.containment_of(u, v2) == Containment::on);
        CHECK(trim.containment_of(u, v2 + 1e-3) == Containment::outside);
    }
    const TopoDS_Shape block = box(0, 0, 0, 1, 2, 3);
    for (TopExp_Explorer it(block, TopAbs_FACE); it.More(); it.Next()) {
        const FaceTrim trim(TopoDS::Face(it.Current()));
        double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
        BRepTools::UVBounds(TopoDS::Face(it.Current()), u1, u2, v1, v2);
        CHECK(trim.containment_of(0.3 * u1 + 0.7 * u2, v1) == Containment::on);
        CHECK(trim.containment_of(u2, v2) == Containment::on);
        CHECK(trim.containment_of(u2 + 1e-6, v1) == Containment::outside);
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_shapes.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Circ.hxx>

#include "filled_parts.h"

namespace featuremesh::testing {

namespace {

TopoDS_Shape cut(const TopoDS_Shape& body, const TopTools_ListOfShape& tools) {
    TopTools_ListOfShape bodies;
    bodies.Append(body);
    BRepAlgoAPI_Cut operation;
    operation.SetArguments(bodies);
    operation.SetTools(tools);
    operation.Build();
    return operation.Shape();
}

TopoDS_Shape open_box() {
    return BRepAlgoAPI_Cut(box_part({0, 0, 0}, {100, 80, 60}), box_part({2, 2, 2}, {96, 76, 60})).Shape();
}

TopoDS_Shape long_wedge(double angle_deg) {
    BRepBuilderAPI_MakePolygon outline(gp_Pnt(0, 0, 0), gp_Pnt(30, 0, 0),
                                       gp_Pnt(30, 0, 30 * std::tan(angle_deg * M_PI / 180)), true);
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 100, 0)).Shape();
}

TopoDS_Shape slotted_comb() {
    TopTools_ListOfShape slots;
    for (int i = 0; i < 8; ++i) slots.Append(box_part({4.0 + 7 * i, -1, 5}, {1.5, 42, 30}));
    return cut(box_part({0, 0, 0}, {60, 40, 25}), slots);
}

TopoDS_Shape half_shell() {
    const TopoDS_Shape ball =
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(30).Shape(), BRepPrimAPI_MakeSphere(28.5).Shape()).Shape();
    return BRepAlgoAPI_Cut(ball, box_part({-40, -40, -40}, {80, 80, 40})).Shape();
}

TopoDS_Shape bent_sheet() {
    const TopoDS_Shape sheet =
        BRepAlgoAPI_Fuse(box_part({0, 0, 0}, {60, 40, 3}), box_part({0, 0, 0}, {3, 40, 50})).Shape();
    BRepFilletAPI_MakeFillet fillet(sheet);
    for (TopExp_Explorer it(sheet, TopAbs_EDGE); it.More(); it.Next()) {
        GProp_GProps properties;
        BRepGProp::LinearProperties(it.Current(), properties);
        if (properties.CentreOfMass().Distance(gp_Pnt(3, 20, 3)) < 1e-6) fillet.Add(2, TopoDS::Edge(it.Current()));
    }
    return fillet.Shape();
}

TopoDS_Shape sieve() {
    TopTools_ListOfShape holes;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j)
            holes.Append(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5 + 10 * i, 5 + 10 * j, -1), gp::DZ()), 3, 7).Shape());
    return cut(box_part({0, 0, 0}, {200, 200, 5}), holes);
}

TopoDS_Wire circle(const gp_Pnt& centre, const gp_Dir& axis, double radius) {
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(centre, axis), radius)).Edge()).Wire();
}

TopoDS_Shape helix_sweep() {
    constexpr double radius = 20, pitch = 15, turns = 2.5;
    const double per_turn = std::hypot(2 * M_PI, pitch);
    const Handle(Geom_CylindricalSurface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), radius);
    const Handle(Geom2d_Line) line = new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(2 * M_PI, pitch));
    const TopoDS_Edge spine = BRepBuilderAPI_MakeEdge(line, cylinder, 0, turns * per_turn).Edge();
    BRepLib::BuildCurve3d(spine);
    BRepOffsetAPI_MakePipeShell pipe(BRepBuilderAPI_MakeWire(spine).Wire());
    pipe.SetMode(Standard_True);
    pipe.Add(circle(gp_Pnt(radius, 0, 0), gp_Dir(0, 2 * M_PI * radius, pitch), 3));
    pipe.Build();
    pipe.MakeSolid();
    return pipe.Shape();
}

TopoDS_Shape square_to_circle() {
    BRepOffsetAPI_ThruSections loft(true);
    loft.AddWire(
        BRepBuilderAPI_MakePolygon(gp_Pnt(-20, -20, 0), gp_Pnt(20, -20, 0), gp_Pnt(20, 20, 0), gp_Pnt(-20, 20, 0), true)
            .Wire());
    loft.AddWire(circle(gp_Pnt(0, 0, 50), gp::DZ(), 12));
    return loft.Shape();
}

}  // namespace

TopoDS_Shape scaled(const TopoDS_Shape& shape, double factor) {
    gp_Trsf scale;
    scale.SetScale(gp_Pnt(0, 0, 0), factor);
    return BRepBuilderAPI_Transform(shape, scale, true).Shape();
}

std::vector<HardShape> hard_shapes() {
    return {
        {"open box with thin walls", open_box()},
        {"tube", tube_part(20, 60)},
        {"wedge of 15 degrees", long_wedge(15)},
        {"wedge of 5 degrees", long_wedge(5)},
        {"block with eight slots", slotted_comb()},
        {"half a spherical shell", half_shell()},
        {"cone with its apex", BRepPrimAPI_MakeCone(20, 0, 40).Shape()},
        {"torus fused with a box",
         BRepAlgoAPI_Fuse(BRepPrimAPI_MakeTorus(40, 10).Shape(), box_part({0, -10, -5}, {60, 45, 30})).Shape()},
        {"bent sheet", bent_sheet()},
        {"plate with 400 holes", sieve()},
        {"two boxes that share part of a face", two_solids()},
        {"box with a void", hollow_part()},
        {"rod", box_part({0, 0, 0}, {1, 1, 200})},
        {"helix", helix_sweep()},
        {"loft between a square and a circle", square_to_circle()},
        {"drilled part a thousand times smaller", scaled(drilled_part(), 1e-3), 1e-3},
        {"drilled part a thousand times larger", scaled(drilled_part(), 1e3), 1e3},
        {"drilled part far from the origin", turned(drilled_part(), 0, {1e5, -1e5, 1e5})},
    };
}

}  // namespace featuremesh::testing

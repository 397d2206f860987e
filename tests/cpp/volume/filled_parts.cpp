// SPDX-License-Identifier: GPL-3.0-or-later
#include "filled_parts.h"

#include <BOPAlgo_Builder.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "core/messages.h"

namespace featuremesh::testing {

namespace {

TopoDS_Shape cylinder(double x, double y, double z, double radius, double height) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp::DZ()), radius, height).Shape();
}

TopoDS_Shape glued(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    BOPAlgo_Builder builder;
    builder.AddArgument(a);
    builder.AddArgument(b);
    builder.Perform();
    return builder.Shape();
}

}  // namespace

TopoDS_Shape box_part(const Vec3& low, const Vec3& size) {
    return BRepPrimAPI_MakeBox(gp_Pnt(low.x, low.y, low.z), gp_Pnt(low.x + size.x, low.y + size.y, low.z + size.z))
        .Shape();
}

TopoDS_Shape drilled_part() {
    const TopoDS_Shape body =
        BRepAlgoAPI_Fuse(box_part({0, 0, 0}, {30, 20, 8}), box_part({0, 0, 0}, {8, 20, 20})).Shape();
    return BRepAlgoAPI_Cut(body, cylinder(20, 10, -1, 4, 10)).Shape();
}

TopoDS_Shape two_solids() { return glued(box_part({0, 0, 0}, {20, 15, 10}), box_part({10, 5, 10}, {20, 15, 10})); }

TopoDS_Shape hollow_part() {
    return BRepAlgoAPI_Cut(box_part({0, 0, 0}, {20, 16, 12}), box_part({6, 5, 4}, {7, 6, 4})).Shape();
}

TopoDS_Shape wedge_part(double angle_deg) {
    const double height = 30 * std::tan(angle_deg * M_PI / 180);
    BRepBuilderAPI_MakePolygon outline(gp_Pnt(0, 0, 0), gp_Pnt(30, 0, 0), gp_Pnt(30, 0, height), true);
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 40, 0)).Shape();
}

TopoDS_Shape tube_part(double radius, double length) {
    return BRepAlgoAPI_Cut(cylinder(0, 0, 0, radius, length), cylinder(0, 0, 0, radius - 1, length)).Shape();
}

TopoDS_Shape touching_cylinders() { return glued(cylinder(0, 0, 0, 5, 12), cylinder(10, 0, 0, 5, 12)); }

TopoDS_Shape cylinders_at_a_point() {
    const gp_Ax2 across(gp_Pnt(10, -8, 6), gp::DY());
    return glued(cylinder(0, 0, 0, 5, 12), BRepPrimAPI_MakeCylinder(across, 5, 16).Shape());
}

TopoDS_Shape unglued_boxes() {
    TopoDS_Compound both;
    const BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, box_part({0, 0, 0}, {10, 10, 10}));
    builder.Add(both, box_part({10, 3, 2}, {10, 10, 10}));
    return both;
}

TopoDS_Shape slotted_block() {
    return BRepAlgoAPI_Cut(box_part({0, 0, 0}, {60, 10, 10}), box_part({3, -1, 2}, {0.3, 12, 9})).Shape();
}

TopoDS_Shape comb_part(int slits, double width) {
    TopoDS_Shape comb = box_part({0, 0, 0}, {30, 20, 3});
    for (int i = 0; i < slits; ++i)
        comb = BRepAlgoAPI_Cut(comb, box_part({10 + 2 * width * i, 2, -1}, {width, 10.0 + i % 3, 5})).Shape();
    return comb;
}

TopoDS_Shape cut_corner(double width) {
    BRepBuilderAPI_MakePolygon outline;
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {30.0, 0.0}, {30.0, 20 - width}, {30 - width, 20.0}, {0.0, 20.0}})
        outline.Add(gp_Pnt(x, y, 0));
    outline.Close();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 10)).Shape();
}

TopoDS_Shape wall_with_steps(double step) {
    BRepBuilderAPI_MakePolygon outline;
    const double top = 0.8, end = 30;
    for (const auto& [x, y] : {std::pair{0.0, 0.0},
                               {15.0, 0.0},
                               {15 + step, step},
                               {end, step},
                               {end, top + step},
                               {15 + step, top + step},
                               {15.0, top},
                               {0.0, top}})
        outline.Add(gp_Pnt(x, y, 0));
    outline.Close();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 0.4)).Shape();
}

TopoDS_Shape engraved_block(int corners, double side, double depth) {
    const double radius = side * corners / (2 * M_PI);
    BRepBuilderAPI_MakePolygon outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners, r = i % 2 == 0 ? radius : radius + 0.5 * side;
        outline.Add(gp_Pnt(15 + r * std::cos(angle), 10 + r * std::sin(angle), 10 - depth));
    }
    outline.Close();
    const TopoDS_Shape pocket =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 1)).Shape();
    return BRepAlgoAPI_Cut(box_part({0, 0, 0}, {30, 20, 10}), pocket).Shape();
}

TopoDS_Shape turned(const TopoDS_Shape& shape, double angle, const Vec3& shift) {
    gp_Trsf turn, move;
    turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(0.3, 0.5, 0.8)), angle);
    move.SetTranslation(gp_Vec(shift.x, shift.y, shift.z));
    return BRepBuilderAPI_Transform(shape, move * turn, true).Shape();
}

Part prepare(const TopoDS_Shape& shape, const SizingOptions& options) {
    RunContext context;
    Brep brep(shape);
    SizingField sizing = make_sizing(brep, options, {}, context);
    Mesh surface = fill_surface(brep, sizing, Mesh{}, context).mesh;
    return {brep, sizing, surface};
}

Part prepare(const TopoDS_Shape& shape, double size) {
    SizingOptions options;
    options.size = size;
    return prepare(shape, options);
}

VolumeResult fill(const Part& part, int threads) {
    RunContext context;
    context.threads = threads;
    return fill_solids(part.brep, part.sizing, part.surface, {}, VolumeOptions{}, context);
}

double volume_of(const CavityFill& fill, int region) {
    double sum = 0;
    for (std::size_t t = 0; t < fill.regions.size(); ++t) {
        const auto& c = fill.triangulation.tets[t];
        if (fill.regions[t] == region)
            sum += signed_volume(fill.points[c[0]], fill.points[c[1]], fill.points[c[2]], fill.points[c[3]]);
    }
    return sum;
}

Expectation expectation_of(const Brep& brep) {
    Expectation expected;
    for (std::size_t i = 0; i < brep.solid_count(); ++i) expected.solid_volumes.push_back(brep.volume_of(SolidId(i)));
    expected.solids_beside_face = brep.solids_beside_faces();
    return expected;
}

std::string findings(const Brep& brep, const Mesh& mesh) {
    return several(broken_invariants(mesh, expectation_of(brep))).in_english();
}

bool are_same_bytes(const Mesh& a, const Mesh& b) {
    return a.points == b.points && a.entities == b.entities && a.parameters == b.parameters &&
           a.node_numbers == b.node_numbers && a.segments == b.segments && a.triangles == b.triangles &&
           a.triangle_numbers == b.triangle_numbers && a.tets == b.tets && a.tet_solids == b.tet_solids &&
           a.tet_numbers == b.tet_numbers;
}

}  // namespace featuremesh::testing

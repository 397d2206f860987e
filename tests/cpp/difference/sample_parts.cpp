// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/sample_parts.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopTools_ListOfShape.hxx>
#include <gp_GTrsf.hxx>

#include "brep/occt_geometry.h"

namespace featuremesh::test {

TopoDS_Shape box(const Vec3& corner, const Vec3& size) {
    return BRepPrimAPI_MakeBox(to_pnt(corner), size.x, size.y, size.z).Shape();
}

TopoDS_Shape cylinder(const Vec3& base, const Vec3& axis, double radius, double height) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(to_pnt(base), gp_Dir(to_vec(axis))), radius, height).Shape();
}

TopoDS_Shape cone(const Vec3& base, const Vec3& axis, double radius, double top_radius, double height) {
    return BRepPrimAPI_MakeCone(gp_Ax2(to_pnt(base), gp_Dir(to_vec(axis))), radius, top_radius, height).Shape();
}

TopoDS_Shape sphere(const Vec3& centre, double radius) {
    return BRepPrimAPI_MakeSphere(to_pnt(centre), radius).Shape();
}

TopoDS_Shape torus(const Vec3& centre, const Vec3& axis, double radius, double tube) {
    return BRepPrimAPI_MakeTorus(gp_Ax2(to_pnt(centre), gp_Dir(to_vec(axis))), radius, tube).Shape();
}

TopoDS_Shape blob(const Vec3& base, double size, double height) {
    Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 6);
    for (int i = 0; i < 6; ++i) {
        const double angle = i * M_PI / 3, radius = size * (i % 2 == 0 ? 1 : 0.6);
        points->SetValue(i + 1, to_pnt(base + Vec3{radius * std::cos(angle), radius * std::sin(angle), 0}));
    }
    GeomAPI_Interpolate spline(points, true, 1e-7);
    spline.Perform();
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(spline.Curve()).Edge()).Wire();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire, true).Face(), gp_Vec(0, 0, height)).Shape();
}

TopoDS_Shape vase(const Vec3& base, const Vec3& axis, double radius, double height) {
    const gp_Ax2 frame(to_pnt(base), gp_Dir(to_vec(axis)));
    const auto at = [&](double r, double h) {
        return frame.Location().Translated(r * gp_Vec(frame.XDirection()) + h * gp_Vec(frame.Direction()));
    };
    TColgp_Array1OfPnt wall(1, 4);
    const double bulges[] = {1, 1.4, 0.7, 1};
    for (int i = 0; i < 4; ++i) wall.SetValue(i + 1, at(radius * bulges[i], height * i / 3));
    const Handle(Geom_BSplineCurve) spline = GeomAPI_PointsToBSpline(wall).Curve();
    BRepBuilderAPI_MakeWire outline(BRepBuilderAPI_MakeEdge(Handle(Geom_Curve)(spline)).Edge());
    outline.Add(BRepBuilderAPI_MakeEdge(at(radius, height), at(0, height)).Edge());
    outline.Add(BRepBuilderAPI_MakeEdge(at(0, height), at(0, 0)).Edge());
    outline.Add(BRepBuilderAPI_MakeEdge(at(0, 0), at(radius, 0)).Edge());
    return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), frame.Axis()).Shape();
}

TopoDS_Shape ellipsoid(const Vec3& centre, const Vec3& half_axes) {
    gp_GTrsf stretch;
    stretch.SetValue(1, 1, half_axes.x), stretch.SetValue(2, 2, half_axes.y), stretch.SetValue(3, 3, half_axes.z);
    stretch.SetTranslationPart(gp_XYZ(centre.x, centre.y, centre.z));
    return BRepBuilderAPI_GTransform(sphere({0, 0, 0}, 1), stretch, true).Shape();
}

TopoDS_Shape moved(const TopoDS_Shape& shape, const RigidMotion& motion) {
    return BRepBuilderAPI_Transform(shape, to_trsf(motion), true).Shape();
}

RigidMotion shift(const Vec3& by) {
    RigidMotion m;
    m.translation = by;
    return m;
}

RigidMotion turn(const Vec3& centre, const Vec3& axis, double angle) {
    gp_Trsf trsf;
    trsf.SetRotation(gp_Ax1(to_pnt(centre), gp_Dir(to_vec(axis))), angle);
    return to_motion(trsf);
}

TopoDS_Shape evaluate(const std::vector<Primitive>& features) {
    TopoDS_Shape shape;
    for (std::size_t i = 0; i < features.size(); ++i) {
        const Primitive& f = features[i];
        if (shape.IsNull()) {
            shape = f.instances[0];
            continue;
        }
        TopTools_ListOfShape arguments, tools;
        arguments.Append(shape);
        for (const TopoDS_Shape& s : f.instances) tools.Append(s);
        for (; i + 1 < features.size() && features[i + 1].effect == f.effect; ++i)
            for (const TopoDS_Shape& s : features[i + 1].instances) tools.Append(s);
        BRepAlgoAPI_Fuse fuse;
        BRepAlgoAPI_Cut cut;
        BRepAlgoAPI_BooleanOperation& operation =
            f.effect == Effect::adds ? static_cast<BRepAlgoAPI_BooleanOperation&>(fuse) : cut;
        operation.SetArguments(arguments);
        operation.SetTools(tools);
        operation.SetNonDestructive(true);
        operation.Build();
        shape = operation.Shape();
    }
    return shape;
}

namespace {
FeatureTree tree_of(const std::vector<Primitive>& features) {
    FeatureTree tree;
    tree.object = features.back().name;
    for (const Primitive& p : features) {
        Feature f;
        f.name = f.label = p.name;
        f.type = "Test::Primitive";
        f.role = p.effect == Effect::adds ? Role::additive : Role::subtractive;
        f.parameters = p.parameters;
        for (const TopoDS_Shape& s : p.instances)
            f.volumes.push_back({s, p.effect, int(f.volumes.size()), {}, p.effect});
        f.combination = Combination::chain;
        if (!tree.features.empty()) f.depends_on = f.operands = {FeatureId(tree.features.size() - 1)};
        tree.features.push_back(std::move(f));
    }
    tree.final_shape = evaluate(features);
    return tree;
}
}  // namespace

PartState part(const std::vector<Primitive>& features) {
    FeatureTree tree = tree_of(features);
    Brep brep(tree.final_shape);
    return {std::move(tree), std::move(brep), CellModel{}};
}

PartState part_with_cells(const std::vector<Primitive>& features) {
    PartState state = part(features);
    RunContext context;
    state.cells = build_cells(state.tree, state.brep, context);
    return state;
}

std::vector<Primitive> bracket(const Vec3& hole) {
    std::vector<Primitive> f;
    f.push_back({"Plate", Effect::adds, {box({0, 0, 0}, {120, 80, 15})}, {{"Length", 15}}});
    f.push_back({"Boss", Effect::adds, {cylinder({85, 40, 15}, {0, 0, 1}, 18, 20)}, {}});
    f.push_back({"Bore", Effect::removes, {cylinder({85, 40, 0}, {0, 0, 1}, 10, 35)}, {{"Diameter", 20}}});
    f.push_back({"Rib", Effect::adds, {box({20, 37, 15}, {50, 6, 12})}, {}});
    const Vec3 holes[] = {hole, {12, 68, 0}, {108, 12, 0}, {108, 68, 0}, {55, 12, 0}, {55, 68, 0}};
    int number = 0;
    for (const Vec3& h : holes)
        f.push_back({"Hole" + std::to_string(number++), Effect::removes, {cylinder(h, {0, 0, 1}, 4, 15)}, {}});
    return f;
}

std::vector<Primitive> many_features(int count) {
    std::vector<Primitive> f;
    const int columns = 15;
    const int rows = (count + columns - 1) / columns;
    f.push_back({"Plate", Effect::adds, {box({0, 0, 0}, {columns * 10.0, rows * 10.0, 5})}, {}});
    std::vector<Primitive> holes;
    for (int i = 0; i + 1 < count; ++i) {
        const Vec3 at{10.0 * (i % columns) + 5, 10.0 * (i / columns) + 5, 0};
        if (i % 3 == 0)
            f.push_back({"Boss" + std::to_string(i), Effect::adds, {box(at + Vec3{-2, -2, 5}, {4, 4, 6})}, {}});
        else
            holes.push_back({"Hole" + std::to_string(i), Effect::removes, {cylinder(at, {0, 0, 1}, 2.5, 5)}, {}});
    }
    f.insert(f.end(), holes.begin(), holes.end());
    return f;
}

}  // namespace featuremesh::test

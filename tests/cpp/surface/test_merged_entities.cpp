// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/merged_entities.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <numbers>
#include <set>

#include "catch.h"
#include "core/messages.h"
#include "surface_checks.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

TopoDS_Shape prism(const std::vector<std::array<double, 2>>& outline, double height) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const auto& [x, y] : outline) polygon.Add(gp_Pnt(x, y, 0));
    polygon.Close();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Face(), gp_Vec(0, 0, height)).Shape();
}

/// A block with a corner cut off so little that nobody sees it.
TopoDS_Shape block_with_sliver() { return prism({{0, 0}, {30, 0}, {30, 20 - 1e-5}, {30 - 1e-5, 20}, {0, 20}}, 10); }

/// Two columns that touch along an edge, as one solid with two edges in that place.
TopoDS_Shape touching_columns() {
    return prism({{0, 0}, {10, 0}, {10, 10}, {20, 10}, {20, 20}, {10, 20}, {10, 10}, {0, 10}}, 15);
}

/// One solid of all their faces, as careless fusing leaves it: where they touch both have a face.
TopoDS_Shape unfused(const std::vector<TopoDS_Shape>& parts) {
    const BRep_Builder builder;
    TopoDS_Shell shell;
    TopoDS_Solid solid;
    builder.MakeShell(shell);
    builder.MakeSolid(solid);
    for (const TopoDS_Shape& part : parts)
        for (TopExp_Explorer it(part, TopAbs_FACE); it.More(); it.Next()) builder.Add(shell, it.Current());
    builder.Add(solid, shell);
    return solid;
}

/// A step as low as nobody sees, with a slot that ends at it: the slot's corners split only the lower long edge of the
/// sliver between the levels.
TopoDS_Shape block_with_step_and_slot() {
    const TopoDS_Shape block = prism({{-10, 0}, {20, 0}, {20, 10 + 1e-5}, {0, 10 + 1e-5}, {0, 10}, {-10, 10}}, 30);
    const TopoDS_Shape slot = BRepPrimAPI_MakeBox(gp_Pnt(-5, 4, 10), gp_Pnt(0, 10, 18)).Shape();
    return BRepAlgoAPI_Cut(block, slot).Shape();
}

Mesh mesh_ignoring(const Brep& brep, const MergedEntities& merged, double size) {
    RunContext context;
    SizingOptions options;
    options.size = size;
    const SizingField sizing = make_sizing(brep, options, {}, context);
    SurfaceOptions ignoring;
    ignoring.known = &merged;
    return fill_surface(brep, sizing, Mesh(), context, ignoring).mesh;
}

/// A block with a bore whose wall is a face nearly all round and a sliver as wide as `gap`.
TopoDS_Shape block_with_nearly_closed_bore(double radius, double gap) {
    const double angle = gap / radius;
    const gp_Circ circle(gp_Ax2(gp_Pnt(15, 10, 0), gp::DZ()), radius);
    const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(circle, angle, 2 * M_PI).Edge();
    const TopoDS_Edge chord = BRepBuilderAPI_MakeEdge(TopExp::LastVertex(arc), TopExp::FirstVertex(arc)).Edge();
    const TopoDS_Face base = BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(arc, chord).Wire(), true).Face();
    const TopoDS_Shape pin = BRepPrimAPI_MakePrism(base, gp_Vec(0, 0, 10)).Shape();
    return BRepAlgoAPI_Cut(prism({{0, 0}, {30, 0}, {30, 20}, {0, 20}}, 10), pin).Shape();
}

/// A block with one edge twice: as a line and as a curve 0.01 above it in the face y = 0, with a face between them.
TopoDS_Shape block_with_strip(const gp_Dir& normal_of_strip) {
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(30, 20, 10).Shape();
    TopoDS_Edge line;
    TopoDS_Face front;
    for (TopExp_Explorer face(block, TopAbs_FACE); face.More(); face.Next()) {
        const BRepAdaptor_Surface surface(TopoDS::Face(face.Current()));
        if (std::abs(surface.Plane().Axis().Direction().Y()) < 0.5 || surface.Plane().Location().Y() > 1) continue;
        front = TopoDS::Face(face.Current());
        for (TopExp_Explorer edge(front, TopAbs_EDGE); edge.More(); edge.Next()) {
            const BRepAdaptor_Curve curve(TopoDS::Edge(edge.Current()));
            const gp_Pnt middle = curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
            if (middle.Distance({15, 0, 10}) < 1e-9) line = TopoDS::Edge(edge.Current());
        }
    }
    TColgp_Array1OfPnt poles(1, 3);
    const gp_Pnt ends[]{BRep_Tool::Pnt(TopExp::FirstVertex(line)), BRep_Tool::Pnt(TopExp::LastVertex(line))};
    poles(1) = ends[0], poles(2) = gp_Pnt(15, 0, 10.02), poles(3) = ends[1];
    TopoDS_Edge curve =
        BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles), TopExp::FirstVertex(line), TopExp::LastVertex(line));
    const BRep_Builder builder;
    builder.UpdateEdge(curve, 0.012);
    BRepBuilderAPI_MakeWire rim;
    for (TopExp_Explorer edge(front, TopAbs_EDGE); edge.More(); edge.Next())
        rim.Add(edge.Current().IsSame(line) ? curve : TopoDS::Edge(edge.Current()));
    BRepBuilderAPI_MakeWire border(line, TopoDS::Edge(curve.Reversed()));
    TopoDS_Shell shell;
    TopoDS_Solid solid;
    builder.MakeShell(shell);
    builder.MakeSolid(solid);
    for (TopExp_Explorer face(block, TopAbs_FACE); face.More(); face.Next())
        if (!face.Current().IsSame(front)) builder.Add(shell, face.Current());
    builder.Add(shell, BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, -1, 0)), rim.Wire()).Face());
    builder.Add(shell, BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 10), normal_of_strip), border.Wire()).Face());
    builder.Add(solid, shell);
    return solid;
}

}  // namespace

TEST_CASE("a sliver of a face and the edges across it get no elements of their own") {
    const Brep brep(block_with_sliver());
    const MergedEntities merged(brep);
    CHECK(std::count(merged.is_flat.begin(), merged.is_flat.end(), 1) == 1);
    CHECK(std::count(merged.is_point.begin(), merged.is_point.end(), 1) == 2);
    CHECK(merged.warnings().size() == 3);
    const Mesh mesh = mesh_surface(brep, 3).mesh;
    CHECK(smallest_angle(mesh) > 25);
    CHECK(euler_characteristic(mesh) == 2);
    CHECK(area(mesh) == Approx(2 * (30 * 20 + 30 * 10 + 20 * 10)).epsilon(1e-5));
}

TEST_CASE(
    "a bore thinner than the length below which details are ignored is closed, a ball behind a thin bore is not") {
    const TopoDS_Shape block = prism({{0, 0}, {30, 0}, {30, 20}, {0, 20}}, 10);
    const gp_Ax2 from_below(gp_Pnt(11, 7, 0), gp::DZ());
    const TopoDS_Shape bore = BRepPrimAPI_MakeCylinder(from_below, 0.002, 4).Shape();
    const Brep drilled(BRepAlgoAPI_Cut(block, bore).Shape());
    const MergedEntities with(drilled), without(drilled, 0.003);
    CHECK(std::count(with.is_flat.begin(), with.is_flat.end(), 1) == 0);
    CHECK(std::count(without.is_flat.begin(), without.is_flat.end(), 1) == 2);
    CHECK(std::count(without.is_point.begin(), without.is_point.end(), 1) == 3);

    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(11, 7, 5), 2).Shape();
    const TopoDS_Shape with_ball = BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(block, bore).Shape(), ball).Shape();
    const MergedEntities open(Brep(with_ball), 0.003);
    CHECK(std::count(open.is_flat.begin(), open.is_flat.end(), 1) == 0);
}

TEST_CASE(
    "details below a length get no elements of their own, and those "
    "above it do") {
    const auto block_cut_by = [](double detail) {
        return prism({{0, 0}, {30, 0}, {30, 20 - detail}, {30 - detail, 20}, {0, 20}}, 10);
    };
    const Brep brep(block_cut_by(0.005));
    const MergedEntities with(brep), without(brep, 0.01);
    CHECK(std::count(with.is_flat.begin(), with.is_flat.end(), 1) == 0);
    CHECK(std::count(without.is_flat.begin(), without.is_flat.end(), 1) == 1);
    CHECK(std::count(without.is_point.begin(), without.is_point.end(), 1) == 2);
    CHECK_FALSE(with.is_same_as(without));
    REQUIRE(without.warnings().size() == 3);
    CHECK(without.warnings()[0].in_english().starts_with("These vertices are nearer to another one than 0.01 mm"));

    const Mesh mesh = mesh_ignoring(brep, without, 3);
    CHECK(smallest_angle(mesh) > 25);
    CHECK(euler_characteristic(mesh) == 2);
    CHECK(area(mesh) == Approx(2 * (30 * 20 + 30 * 10 + 20 * 10)).epsilon(1e-3));

    const Brep coarse(block_cut_by(0.05));
    CHECK(MergedEntities(coarse, 0.01).is_same_as(MergedEntities(coarse)));
}

TEST_CASE("a bore whose wall closes but for a sliver has the wall, and is left out only where that is") {
    const Brep brep(block_with_nearly_closed_bore(4, 0.002));
    REQUIRE(brep.face_count() == 8);
    const MergedEntities merged(brep, 0.004);
    CHECK(std::count(merged.is_flat.begin(), merged.is_flat.end(), 1) == 1);
    const Mesh mesh = mesh_ignoring(brep, merged, 3);
    CHECK(smallest_angle(mesh) > 20);
    CHECK(euler_characteristic(mesh) == 0);
    CHECK(area(mesh) == Approx(2 * (30 * 20 + 30 * 10 + 20 * 10 - 16 * M_PI) + 80 * M_PI).epsilon(0.02));
}

TEST_CASE("an edge that closes all but a ring runs along no other, if it is less than two lengths long") {
    const double gap = 0.0021, radius = 5;
    const double angle = gap / radius;
    const gp_Circ circle(gp::XOY(), radius);
    BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(circle, angle / 2, 2 * std::numbers::pi - angle / 2).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(circle, -angle / 2, angle / 2).Edge());
    const Brep brep(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, 0, 8)).Shape());
    for (const double ignored : {0.6 * gap, 0.98 * gap}) {
        const MergedEntities merged(brep, ignored);
        CHECK(merged.warnings().empty());
        CHECK(euler_characteristic(mesh_ignoring(brep, merged, 2)) == 2);
    }
    const MergedEntities merged(brep, 1.1 * gap);
    CHECK(std::count(merged.is_flat.begin(), merged.is_flat.end(), 1) == 1);
    CHECK(smallest_angle(mesh_ignoring(brep, merged, 2)) > 25);
}

TEST_CASE("faces of one solid that lie on one another have no triangles, and the mesh is joined there") {
    const TopoDS_Shape block = prism({{0, 0}, {30, 0}, {30, 20}, {0, 20}}, 10);
    const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 10, 10), gp::DX()), 4, 30).Shape();
    const TopoDS_Shape half = BRepAlgoAPI_Common(block, rod).Shape(), rest = BRepAlgoAPI_Cut(block, rod).Shape();
    const TopoDS_Shape other = prism({{30, 0}, {45, 0}, {45, 20}, {30, 20}}, 10);
    const auto check = [](const TopoDS_Shape& shape, double length) {
        const Brep brep(shape);
        const MergedEntities merged(brep);
        CHECK(std::count(merged.is_flat.begin(), merged.is_flat.end(), 1) == 2);
        const auto warnings = merged.warnings();
        CHECK(std::any_of(warnings.begin(), warnings.end(),
                          [](const auto& line) { return line.code() == Code::faces_joined; }));
        const Mesh mesh = mesh_surface(brep, 3).mesh;
        CHECK(smallest_angle(mesh) > 25);
        CHECK(euler_characteristic(mesh) == 2);
        CHECK(area(mesh) == Approx(2 * (length * 20 + length * 10 + 20 * 10)).epsilon(2e-3));
    };
    check(unfused({block, other}), 45);
    check(unfused({rest, half}), 30);
}

TEST_CASE("faces with one border are not joined where they are apart, however little of them is") {
    const TopoDS_Shape lens = BRepAlgoAPI_Common(BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), 10).Shape(),
                                                 BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 19), 10).Shape())
                                  .Shape();
    CHECK(MergedEntities(Brep(lens), 0.1).warnings().empty());
}

TEST_CASE("edges with a face of no width between them are in one place as far as their tolerance says") {
    const auto flat_faces = [](const gp_Dir& normal) {
        const Brep brep(block_with_strip(normal));
        const MergedEntities merged(brep);
        return std::count(merged.is_flat.begin(), merged.is_flat.end(), 1);
    };
    CHECK(flat_faces(gp::DZ()) == 1);
    CHECK(flat_faces(gp::DY()) == 0);
    CHECK(surface_findings(Brep(block_with_strip(gp::DZ())), mesh_surface(Brep(block_with_strip(gp::DZ())), 4).mesh)
              .empty());
}

TEST_CASE("edges of one solid in the same place are one chain") {
    const Brep brep(touching_columns());
    const MergedEntities merged(brep);
    int shared = 0;
    for (std::size_t e = 0; e < brep.edge_count(); ++e) shared += merged.edge_of[e] != EdgeId(e);
    CHECK(shared == 1);
    CHECK(std::count(merged.is_flat.begin(), merged.is_flat.end(), 1) == 0);
    const Mesh mesh = mesh_surface(brep, 2).mesh;
    std::vector<Vec3> points = mesh.points;
    const auto less = [](const Vec3& a, const Vec3& b) {
        return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
    };
    std::sort(points.begin(), points.end(), less);
    CHECK(std::adjacent_find(points.begin(), points.end()) == points.end());
    CHECK(area(mesh) == Approx(4 * 100 + 80 * 15));
}

TEST_CASE("an edge goes through the vertices that lie on it, and slivers beside it have no triangles") {
    const Brep brep(block_with_step_and_slot());
    const MergedEntities merged(brep);
    std::size_t passed = 0;
    int parts = 0;
    for (const auto& vertices : merged.vertices_on) passed += vertices.size();
    for (std::size_t e = 0; e < brep.edge_count(); ++e) parts += merged.edge_of[e] != EdgeId(e);
    CHECK(passed == 2);
    CHECK(parts == 3);
    CHECK(std::count(merged.is_flat.begin(), merged.is_flat.end(), 1) == 1);
    const Mesh mesh = mesh_surface(brep, 3).mesh;
    CHECK(smallest_angle(mesh) > 25);
    CHECK(euler_characteristic(mesh) == 2);
}

TEST_CASE("where the curve of an edge ends is none of its inside, though its vertex lies elsewhere") {
    const TopoDS_Shape columns = touching_columns();
    const Brep tight(columns);
    const auto corner = [&](std::size_t v) { return tight.point_of(VertexId(v)) == Vec3{10, 10, 0}; };
    std::size_t loose = 0;
    while (!corner(loose)) ++loose;
    BRep_Builder().UpdateVertex(tight.vertex(VertexId(loose)), gp_Pnt(10.3, 9.7, 0), 0.5);
    const MergedEntities merged{Brep(columns)};
    for (const auto& on : merged.vertices_on) CHECK(on.empty());
}

TEST_CASE("a border that goes there and back again is none: a slit is closed, a spike has no triangles") {
    const TopoDS_Shape slit = prism({{0, 0}, {30, 0}, {30, 20}, {15, 20}, {15, 8}, {15, 20}, {0, 20}}, 10);
    const Mesh closed = mesh_surface(Brep(slit), 3).mesh;
    CHECK(smallest_angle(closed) > 25);
    CHECK(euler_characteristic(closed) == 2);
    CHECK(area(closed) == Approx(2 * (30 * 20 + 30 * 10 + 20 * 10)));

    // the sides of a low pad that closes half of a bore, where they are no higher than nobody sees
    const TopoDS_Shape block = prism({{0, 0}, {30, 0}, {30, 20}, {0, 20}}, 10);
    const gp_Ax2 from_below(gp_Pnt(15, 10, 0), gp::DZ());
    const TopoDS_Shape bored = BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(from_below, 4, 10).Shape()).Shape();
    const TopoDS_Shape pad = BRepPrimAPI_MakeBox(gp_Pnt(15, 3, 7), gp_Pnt(24, 17, 10 + 1e-5)).Shape();
    const Brep brep(BRepAlgoAPI_Fuse(bored, pad).Shape());
    const MergedEntities merged(brep);
    CHECK(std::count(merged.is_flat.begin(), merged.is_flat.end(), 1) > 0);
    const Mesh mesh = mesh_surface(brep, 3).mesh;
    CHECK(smallest_angle(mesh) > 15);
    CHECK(euler_characteristic(mesh) == 0);
}

TEST_CASE("edges that run along one another for a part of each have the same nodes there") {
    const double off = 0.002;
    const TopoDS_Shape low = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(40, 30, 10)).Shape();
    const TopoDS_Shape high = BRepPrimAPI_MakeBox(gp_Pnt(off, off, 9), gp_Pnt(40 + off, 30 + off, 14)).Shape();
    const Brep brep(BRepAlgoAPI_Fuse(low, high).Shape());
    const MergedEntities with(brep), without(brep, 0.01);
    const auto borrowers = [](const MergedEntities& merged) {
        return std::count_if(merged.lender_of.begin(), merged.lender_of.end(),
                             [](const auto& l) { return !l.empty(); });
    };
    CHECK(borrowers(with) == 0);
    CHECK(borrowers(without) > 0);
    for (const double size : {2.0, 3.0, 6.0}) {
        const Mesh mesh = mesh_ignoring(brep, without, size);
        CHECK(smallest_angle(mesh) > 15);
        CHECK(euler_characteristic(mesh) == 2);
        CHECK(area(mesh) == Approx(2 * (40 * 30 + 40 * 14 + 30 * 14)).epsilon(1e-3));
    }
}

TEST_CASE("a vertex at which all edges are too short has no node of its own, and its faces none either") {
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(30, 20, 10)).Shape();
    const TopoDS_Shape bump = BRepPrimAPI_MakeBox(gp_Pnt(15, 19, 10 - 0.0018), gp_Pnt(15.0021, 20.0013, 10)).Shape();
    const Brep brep(BRepAlgoAPI_Fuse(block, bump).Shape());
    const MergedEntities merged(brep, 0.0029);
    std::set<VertexId> at_bump;
    int count = 0;
    for (std::size_t v = 0; v < brep.vertex_count(); ++v)
        if (const Vec3 p = brep.point_of(VertexId(v)); std::abs(p.x - 15) < 1 && p.y > 19.5)
            ++count, at_bump.insert(merged.vertex_of[v]);
    CHECK(count == 8);
    CHECK(at_bump.size() == 1);
    const Mesh mesh = mesh_ignoring(brep, merged, 3);
    CHECK(smallest_angle(mesh) > 25);
    CHECK(euler_characteristic(mesh) == 2);
}

TEST_CASE("of vertices in a row, each near the next, all stand for themselves or are merged with one that does") {
    std::vector<std::array<double, 2>> outline{{0, 0}, {30, 0}, {30, 20}};
    for (int i = 0; i < 9; ++i) outline.push_back({20 - 0.07 * i, 20 + 0.005 * (i % 2)});
    outline.push_back({0, 20});
    const Brep brep(prism(outline, 10));
    const MergedEntities merged(brep, 0.1);
    std::size_t moved = 0;
    for (std::size_t v = 0; v < brep.vertex_count(); ++v) {
        const VertexId with = merged.vertex_of[v];
        CHECK(merged.vertex_of[with.index()] == with);
        CHECK(distance(brep.point_of(VertexId(v)), brep.point_of(with)) <= 0.1);
        moved += with != VertexId(v);
    }
    CHECK(moved >= 6);
}

TEST_CASE("nothing is merged in a plain shape, with seams and closed edges") {
    for (const NamedShape& s : named_shapes()) {
        INFO(s.name);
        CHECK(MergedEntities(Brep(s.shape)).warnings().empty());
    }
}

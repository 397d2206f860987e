// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_chains.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include "catch.h"
#include "surface_checks.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// A trough whose bulging sides come as near to one another as twice the gap at (0, 4, z).
TopoDS_Wire outline_of_trough(double z, double gap) {
    BRepBuilderAPI_MakeWire wire;
    const auto line = [&](double x, double y, double u, double v) {
        wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(x, y, z), gp_Pnt(u, v, z)).Edge());
    };
    const auto arc = [&](const gp_Pnt& from, const gp_Pnt& through, const gp_Pnt& to) {
        wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(from, through, to).Value()).Edge());
    };
    line(-10, -10, 10, -10), line(10, -10, 10, 8), line(10, 8, 3, 8);
    arc({3, 8, z}, {gap, 4, z}, {3, 0, z});
    line(3, 0, 3, -5), line(3, -5, -3, -5), line(-3, -5, -3, 0);
    arc({-3, 0, z}, {-gap, 4, z}, {-3, 8, z});
    line(-3, 8, -10, 8), line(-10, 8, -10, -10);
    return wire.Wire();
}

/// Two edges of it touch at one point, between their vertices.
TopoDS_Shape touching_trough() {
    BRepOffsetAPI_ThruSections loft(true, true);
    loft.AddWire(outline_of_trough(0, 1.5));
    loft.AddWire(outline_of_trough(3, 0));
    loft.AddWire(outline_of_trough(6, 1.5));
    return loft.Shape();
}

/// A prism over a rectangle one of whose sides is two edges, the first of which ends before the vertex between them.
TopoDS_Shape prism_with_gap(double gap, double length = 10) {
    BRepBuilderAPI_MakePolygon outline;
    for (const gp_Pnt& p :
         {gp_Pnt(0, 0, 0), gp_Pnt(length, 0, 0), gp_Pnt(20, 0, 0), gp_Pnt(20, 15, 0), gp_Pnt(0, 15, 0)})
        outline.Add(p);
    outline.Close();
    const TopoDS_Shape prism =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 10)).Shape();
    const Brep brep(prism);
    const BRep_Builder builder;
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        const auto ends = brep.ends_of(EdgeId(e));
        if (!(brep.point_of(ends[0]) == Vec3{0, 0, 0}) || !(brep.point_of(ends[1]) == Vec3{length, 0, 0})) continue;
        double first, last;
        BRep_Tool::Range(brep.edge(EdgeId(e)), first, last);
        builder.Range(brep.edge(EdgeId(e)), first, last - gap);
        builder.UpdateVertex(brep.vertex(ends[1]), 2 * gap);
    }
    return prism;
}

/// Two shafts on one axis, 10 long each, whose radii differ by the step and whose seams by the angle.
TopoDS_Shape stepped_shaft(double radius, double step, double angle_deg) {
    const TopoDS_Shape thick = BRepPrimAPI_MakeCylinder(radius, 10).Shape();
    gp_Ax2 axes(gp_Pnt(0, 0, 10), gp_Dir(0, 0, 1));
    axes.Rotate(axes.Axis(), angle_deg * M_PI / 180);
    return BRepAlgoAPI_Fuse(thick, BRepPrimAPI_MakeCylinder(axes, radius - step, 10).Shape()).Shape();
}

/// Of the two edges at this height.
std::array<std::vector<Vec3>, 2> nodes_at_step(const Brep& brep, const Mesh& mesh, double z) {
    std::array<std::vector<Vec3>, 2> nodes;
    std::size_t circle = 0;
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        const auto ends = brep.ends_of(EdgeId(e));
        if (ends[0] != ends[1] || std::abs(brep.point_of(ends[0]).z - z) > 1e-9) continue;
        for (std::size_t s = 0; s < mesh.segments.size(); ++s)
            if (mesh.segment_edges[s] == EdgeId(e)) nodes[circle].push_back(mesh.point(mesh.segments[s][0]));
        ++circle;
    }
    return nodes;
}

}  // namespace

TEST_CASE("an edge that ends before its vertex has a node of its own, so that a piece of it is between its ends") {
    const auto nodes_on_edges = [](double gap) {
        const Brep brep(prism_with_gap(gap));
        const Mesh mesh = mesh_surface(brep, 12).mesh;
        CHECK(surface_findings(brep, mesh).empty());
        CHECK(euler_characteristic(mesh) == 2);
        std::vector<Vec3> found;
        for (std::size_t n = 0; n < mesh.node_count(); ++n)
            if (mesh.entities[n].dim == 1 && mesh.points[n].y == 0 && mesh.points[n].z == 0)
                found.push_back(mesh.points[n]);
        return found;
    };
    CHECK(nodes_on_edges(5e-8).empty());
    const std::vector<Vec3> with_gap = nodes_on_edges(4e-6);
    REQUIRE(with_gap.size() == 1);
    CHECK(with_gap[0].x == Approx(5));
}

TEST_CASE("a tiny edge stays in one piece, whatever would halve a longer one") {
    const auto is_tiny_edge_whole = [](const TopoDS_Shape& shape, double size, const Box& around) {
        const Brep brep(shape);
        const Mesh mesh = mesh_surface(brep, size).mesh;
        CHECK(surface_findings(brep, mesh).empty());
        CHECK(euler_characteristic(mesh) == 2);
        for (std::size_t n = 0; n < mesh.node_count(); ++n)
            if (mesh.entities[n].dim == 1 && around.contains(mesh.points[n])) return false;
        return true;
    };

    SECTION("which ends before its vertex") {
        const auto is_whole = [&](double length) {
            Box around;
            around.add(Vec3{0, 0, 0}), around.add(Vec3{length, 0, 0});
            return is_tiny_edge_whole(prism_with_gap(4e-6, length), 12, around);
        };
        CHECK_FALSE(is_whole(5));
        CHECK(is_whole(0.02));
    }
    SECTION("beside another that is a far longer way between the same vertices") {
        const gp_Pnt left(0, 0, 0), right(10, 0, 0);
        const auto prism_between = [&](double below, double above) {
            BRepBuilderAPI_MakeWire outline;
            for (const double height : {-below, above}) {
                const gp_Pnt middle(5, height, 0);
                outline.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(left, middle, right).Value()).Edge());
            }
            return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 60)).Shape();
        };
        Box around;
        around.add(Vec3{0, -1, 0}), around.add(Vec3{10, 0, 0});
        CHECK(is_tiny_edge_whole(prism_between(0.3, 200), 30, around));
        CHECK_FALSE(is_tiny_edge_whole(prism_between(0.3, 1), 30, around));
    }
}

TEST_CASE("an edge that ends at the close of a curve has a node of its own") {
    TColgp_Array1OfPnt corners(1, 5);
    corners(1) = corners(5) = gp_Pnt(0, 0, 0);
    corners(2) = gp_Pnt(30, 0, 0), corners(3) = gp_Pnt(30, 30, 0), corners(4) = gp_Pnt(0, 30, 0);
    const Handle(Geom_BezierCurve) drop = new Geom_BezierCurve(corners);
    REQUIRE(drop->IsClosed());
    BRepBuilderAPI_MakeWire wire;
    const double parted = 0.1;
    wire.Add(BRepBuilderAPI_MakeEdge(drop, 0, parted).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(drop, parted, 1).Edge());
    const Brep brep(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, 0, 10)).Shape());
    const Mesh mesh = mesh_surface(brep, 12).mesh;
    CHECK(surface_findings(brep, mesh).empty());
    const auto is_on_short_piece = [&](std::size_t n) {
        return mesh.entities[n].dim == 1 && mesh.points[n].z == 0 && mesh.parameters[n][0] < parted;
    };
    int found = 0;
    for (std::size_t n = 0; n < mesh.node_count(); ++n) found += is_on_short_piece(n);
    CHECK(found == 1);
}

TEST_CASE("where two edges of a solid touch between their vertices neither has a node") {
    const Brep brep(touching_trough());
    for (const double size : {1.78, 0.89, 0.446}) {
        INFO(size);
        const Mesh mesh = mesh_surface(brep, size).mesh;
        CHECK(surface_findings(brep, mesh).empty());
        const auto is_at_contact = [](const Vec3& p) { return distance(p, {0, 4, 3}) < 1e-3; };
        CHECK(std::none_of(mesh.points.begin(), mesh.points.end(), is_at_contact));
        CHECK(euler_characteristic(mesh) == 2);
    }
}

TEST_CASE("edges with a step of a hundredth of an element between them get nodes opposite one another") {
    const TopoDS_Shape shape = stepped_shaft(20, 0.005, 40);
    const Brep brep(shape);
    const std::size_t pieces = 42;  // 3 mm each on a circle of 20
    for (const NarrowFaces narrow : {NarrowFaces::opposite_nodes, NarrowFaces::shorter, NarrowFaces::own_chains}) {
        RunContext context;
        SizingOptions sizing;
        sizing.size = 3;
        SurfaceOptions options;
        options.narrow = narrow;
        const SurfaceResult result = fill_surface(brep, make_sizing(brep, sizing, {}, context), {}, context, options);
        CHECK(surface_findings(brep, result.mesh).empty());
        CHECK(result.report.has_opposite_nodes == (narrow != NarrowFaces::own_chains));
        const std::array<std::vector<Vec3>, 2> circles = nodes_at_step(brep, result.mesh, 10);
        if (narrow == NarrowFaces::own_chains) {
            CHECK(circles[0].size() > 3 * pieces);
            CHECK(result.report.warnings.size() == 1);
            continue;
        }
        CHECK(circles[0].size() == circles[1].size());
        CHECK(circles[0].size() >= pieces);
        CHECK(circles[0].size() <= (narrow == NarrowFaces::shorter ? 2 : 1) * (pieces + 3));
        for (const Vec3& p : circles[0])
            CHECK(std::any_of(circles[1].begin(), circles[1].end(),
                              [&](const Vec3& q) { return distance(p, q) < 0.006; }));
        CHECK(result.report.warnings.empty());
    }
}

TEST_CASE("half the length along narrow faces is offered where it gives another surface, and nowhere else") {
    const std::vector<TopoDS_Shape> shapes{stepped_shaft(20, 0.005, 40), BRepPrimAPI_MakeBox(30, 30, 0.01).Shape(),
                                           BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(30, 30, 10).Shape(),
                                                           BRepPrimAPI_MakeBox(gp_Pnt(5, 5, 0.01), 20, 20, 10).Shape())
                                               .Shape(),
                                           BRepPrimAPI_MakeBox(30, 20, 10).Shape()};
    std::size_t with_opposite_nodes = 0, halved = 0;
    for (const TopoDS_Shape& shape : shapes) {
        const Brep brep(shape);
        const auto filled = [&](NarrowFaces narrow) {
            RunContext context;
            SizingOptions sizing;
            sizing.size = 3;
            SurfaceOptions options;
            options.narrow = narrow;
            return fill_surface(brep, make_sizing(brep, sizing, {}, context), {}, context, options);
        };
        const SurfaceResult plain = filled(NarrowFaces::opposite_nodes), shorter = filled(NarrowFaces::shorter);
        CHECK(plain.report.may_be_halved == (plain.mesh.points != shorter.mesh.points));
        CHECK_FALSE(shorter.report.may_be_halved);
        with_opposite_nodes += plain.report.has_opposite_nodes, halved += plain.report.may_be_halved;
    }
    CHECK(halved > 0);
    CHECK(with_opposite_nodes > halved);
}

TEST_CASE("a kept chain beside a new one gets it opposite its nodes") {
    const Brep brep(stepped_shaft(20, 0.005, 40));
    RunContext context;
    SizingOptions sizing;
    sizing.size = 3;
    const SizingField field = make_sizing(brep, sizing, {}, context);
    const Mesh whole = fill_surface(brep, field, {}, context).mesh;
    for (const double radius : {20.0, 19.995}) {
        Mesh kept;
        kept.next_node_number = whole.next_node_number;
        for (std::size_t n = 0; n < whole.node_count(); ++n) {
            const Vec3 p = whole.points[n];
            if (whole.entities[n].dim == 1 && std::abs(p.z - 10) < 1e-9 &&
                std::abs(std::hypot(p.x, p.y) - radius) < 1e-6)
                kept.add_node(p, whole.entities[n], whole.parameters[n]);
        }
        REQUIRE(kept.node_count() > 40);
        const SurfaceResult result = fill_surface(brep, field, kept, context);
        CHECK(surface_findings(brep, result.mesh).empty());
        const std::array<std::vector<Vec3>, 2> circles = nodes_at_step(brep, result.mesh, 10);
        CHECK(circles[0].size() == circles[1].size());
    }
}

TEST_CASE("beside a tip where two edges cross within their tolerance neither has a node") {
    TColgp_Array1OfPnt poles(1, 3);
    poles(1) = gp_Pnt(0, 0, 0), poles(2) = gp_Pnt(1, -0.02, 0), poles(3) = gp_Pnt(2, 0.26, 0);  // crosses at x = 0.267
    BRepBuilderAPI_MakeWire border;
    border.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(2, 0, 0)));
    border.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(2, 0, 0), gp_Pnt(2, 0.26, 0)));
    border.Add(BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles)));
    const TopoDS_Shape wedge =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(border.Wire()).Face(), gp_Vec(0, 0, 0.05)).Shape();
    for (TopExp_Explorer edge(wedge, TopAbs_EDGE); edge.More(); edge.Next())
        BRep_Builder().UpdateEdge(TopoDS::Edge(edge.Current()), 0.003);
    const Brep brep(wedge);
    EdgesBeside beside;
    const auto is_at_tip = [&](EdgeId e) {
        const auto ends = brep.ends_of(e);
        return distance(brep.point_of(ends[0]), {0, 0, 0}) < 1e-9 || distance(brep.point_of(ends[1]), {0, 0, 0}) < 1e-9;
    };
    for (std::size_t e = 0; e < brep.edge_count(); ++e)
        for (std::size_t other = 0; other < e; ++other)
            if (is_at_tip(EdgeId(e)) && is_at_tip(EdgeId(other))) beside.add(EdgeId(e), EdgeId(other));
    RunContext context;
    SizingOptions options;
    options.size = 0.1;
    Mesh mesh;
    const SizingField sizing = make_sizing(brep, options, {}, context);
    const WantedLength wanted(sizing);
    const EdgeChains chains(brep, MergedEntities(brep), wanted, beside, mesh, context);
    std::size_t count = 0;
    for (const Vec3& p : mesh.points) {
        if (p.z != 0 || p.x == 0 || p.x > 1.99) continue;
        ++count;
        CHECK(p.x > 0.37);
    }
    CHECK(count > 30);
}

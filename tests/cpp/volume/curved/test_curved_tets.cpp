// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>

#include "catch.h"
#include "mesh/quality.h"
#include "mesh/second_order.h"
#include "mesh/validation.h"
#include "surface/fill_surface.h"
#include "surface/projection.h"
#include "volume/curved/mid_side_nodes.h"
#include "volume/fill_solids.h"

using namespace featuremesh;

namespace {

TopoDS_Shape filleted_box(double radius) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next()) fillet.Add(radius, TopoDS::Edge(it.Current()));
    return fillet.Shape();
}

TopoDS_Shape crossing_cylinders() {
    const gp_Ax2 up(gp_Pnt(0, 0, -20), gp::DZ()), across(gp_Pnt(-20, 0, 0), gp::DX());
    return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(up, 6, 40).Shape(),
                            BRepPrimAPI_MakeCylinder(across, 6, 40).Shape())
        .Shape();
}

/// A pipe with a branch of the same radius, both with a wall as thin as this.
TopoDS_Shape branching_pipe(double wall) {
    const auto both = [](double radius, double beyond) {
        const gp_Ax2 along(gp_Pnt(-15 - beyond, 0, 0), gp::DX());
        return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(along, radius, 30 + 2 * beyond).Shape(),
                                BRepPrimAPI_MakeCylinder(radius, 15 + beyond).Shape())
            .Shape();
    };
    return BRepAlgoAPI_Cut(both(4.5, 0), both(4.5 - wall, 5)).Shape();
}

/// An L whose parts are not merged: the fillet's arc and the edge between the parts' end faces meet tangentially.
TopoDS_Shape sheet_with_cusps() {
    const TopoDS_Shape sheet =
        BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(30, 20, 3).Shape(), BRepPrimAPI_MakeBox(3, 20, 25).Shape()).Shape();
    BRepFilletAPI_MakeFillet fillet(sheet);
    for (TopExp_Explorer it(sheet, TopAbs_EDGE); it.More(); it.Next()) {
        const BRepAdaptor_Curve edge(TopoDS::Edge(it.Current()));
        const gp_Pnt middle = edge.Value(0.5 * (edge.FirstParameter() + edge.LastParameter()));
        if (middle.Distance(gp_Pnt(3, 10, 3)) < 1e-6) fillet.Add(2, TopoDS::Edge(it.Current()));
    }
    return fillet.Shape();
}

/// A step as low as nobody sees, with a slot that ends at it: the upper edge of the step goes through the corners of
/// the slot.
TopoDS_Shape block_with_step_and_slot() {
    BRepBuilderAPI_MakePolygon outline;
    for (const auto& [x, y] :
         {std::pair{-10.0, 0.0}, {20.0, 0.0}, {20.0, 10 + 1e-5}, {0.0, 10 + 1e-5}, {0.0, 10.0}, {-10.0, 10.0}})
        outline.Add(gp_Pnt(x, y, 0));
    outline.Close();
    const TopoDS_Shape block =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 30)).Shape();
    return BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeBox(gp_Pnt(-5, 4, 10), gp_Pnt(0, 10, 18)).Shape()).Shape();
}

/// A block whose outline has a curve that turns back within less than an element.
TopoDS_Shape block_with_hairpin() {
    TColgp_Array1OfPnt poles(1, 4);
    poles(1) = gp_Pnt(0, 0, 0), poles(2) = gp_Pnt(18, 4, 0), poles(3) = gp_Pnt(18, -4, 0), poles(4) = gp_Pnt(4, 6, 0);
    BRepBuilderAPI_MakeWire outline(BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles)).Edge());
    const std::vector<gp_Pnt> corners{{4, 6, 0}, {4, 20, 0}, {30, 20, 0}, {30, -10, 0}, {0, -10, 0}, {0, 0, 0}};
    for (std::size_t i = 1; i < corners.size(); ++i)
        outline.Add(BRepBuilderAPI_MakeEdge(corners[i - 1], corners[i]).Edge());
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 20)).Shape();
}

/// The wall between bore and side is as thick as said.
TopoDS_Shape box_with_bore(double wall) {
    const gp_Ax2 up(gp_Pnt(20, 5 + wall, -5), gp::DZ());
    return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40, 30, 20).Shape(), BRepPrimAPI_MakeCylinder(up, 5, 40).Shape())
        .Shape();
}

/// A ring as wide as nobody sees: its two circles are joined by tets as thin as it is.
TopoDS_Shape shaft_with_step(double height) {
    return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(10, 20).Shape(), BRepPrimAPI_MakeCylinder(10 + height, 8).Shape())
        .Shape();
}

/// A block with a bore whose rim has a chamfer as narrow as this.
TopoDS_Shape block_with_chamfered_bore(double width) {
    const gp_Ax2 up(gp_Pnt(20, 15, -5), gp::DZ());
    const TopoDS_Shape block =
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40, 30, 20).Shape(), BRepPrimAPI_MakeCylinder(up, 6, 40).Shape()).Shape();
    BRepFilletAPI_MakeChamfer chamfer(block);
    for (TopExp_Explorer it(block, TopAbs_EDGE); it.More(); it.Next()) {
        const BRepAdaptor_Curve curve(TopoDS::Edge(it.Current()));
        if (curve.GetType() == GeomAbs_Circle && curve.Circle().Location().Z() > 19)
            chamfer.Add(width, TopoDS::Edge(it.Current()));
    }
    return chamfer.Shape();
}

/// Degrees, of the tets without a side as short as this; large angles count as what they lack to 180.
double worst_angle_without(const Mesh& mesh, double side) {
    double worst = 90;
    for (const auto& tet : mesh.tets) {
        const std::array<Vec3, 4> p{mesh.point(tet[0]), mesh.point(tet[1]), mesh.point(tet[2]), mesh.point(tet[3])};
        if (std::any_of(tet_sides.begin(), tet_sides.end(),
                        [&](const auto& s) { return distance(p[s[0]], p[s[1]]) < side; }))
            continue;
        const DihedralRange range = dihedral_range(p[0], p[1], p[2], p[3]);
        worst = std::min({worst, range.smallest_deg, 180 - range.largest_deg});
    }
    return worst;
}

Mesh straight_mesh(const Brep& brep, double size, RunContext& context) {
    SizingOptions options;
    options.size = size;
    options.elements_per_circle = 0;
    const SizingField sizing = make_sizing(brep, options, {}, context);
    Mesh surface = fill_surface(brep, sizing, Mesh{}, context).mesh;
    return fill_solids(brep, sizing, std::move(surface), {}, {.is_for_curved_tets = true}, context).mesh;
}

Mesh curved_mesh(const Brep& brep, double size) {
    RunContext context;
    return curve_to_second_order(brep, straight_mesh(brep, size, context), nullptr, context);
}

double distance_from_entities(const Brep& brep, const Mesh& mesh) {
    const Projector projector(brep);
    double largest = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (NodeId n : mesh.triangle_mids[t])
            largest = std::max(largest, projector.nearest(mesh.triangle_faces[t], mesh.point(n)).distance);
    for (std::size_t s = 0; s < mesh.segments.size(); ++s)
        largest =
            std::max(largest, projector.nearest(mesh.segment_edges[s], mesh.point(mesh.segment_mids[s])).distance);
    return largest;
}

}  // namespace

TEST_CASE("coarse 10-node meshes of strongly curved parts are unfolded and on their faces") {
    struct Case {
        std::string name;
        TopoDS_Shape shape;
        double size;
    };
    const std::vector<Case> cases{
        {"cylinder, four around", BRepPrimAPI_MakeCylinder(10, 30).Shape(), 14},
        {"torus", BRepPrimAPI_MakeTorus(20, 6).Shape(), 8},
        {"fillet of 2 at size 10", filleted_box(2), 10},
        {"tube with a thin wall",
         BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(20, 20).Shape(), BRepPrimAPI_MakeCylinder(19, 20).Shape()).Shape(),
         6},
        {"crossing cylinders", crossing_cylinders(), 10},
        {"branching pipe, wall 0.2", branching_pipe(0.2), 2.4},
        {"arc that leaves a line at no angle", sheet_with_cusps(), 5},
        {"hairpin", block_with_hairpin(), 10}};
    for (const Case& c : cases) {
        INFO(c.name);
        const Brep brep(c.shape);
        const Mesh mesh = curved_mesh(brep, c.size);
        Expectation expected;
        expected.solids_beside_face = brep.solids_beside_faces();
        CHECK(broken_invariants(mesh, expected).empty());
        CHECK(measure_quality(mesh).min_scaled_jacobian > 0.199);
        if (c.name == "cylinder, four around") CHECK(measure_quality(mesh).min_dihedral > 25);
        CHECK(distance_from_entities(brep, mesh) < 1e-8);
    }
}

TEST_CASE("where the tets are valid, but miss the aim, shorter edges are asked for at the place") {
    RunContext context;
    const auto of_wall = [&](double thickness, double size) {
        const Brep brep(box_with_bore(thickness));
        return try_second_order(brep, straight_mesh(brep, size, context), nullptr, context);
    };
    SecondOrder result;  // which wall gives such tets hangs on where the nodes come to lie
    for (const double thickness : {0.05, 0.04, 0.035, 0.03, 0.025}) {
        result = of_wall(thickness, 3.5);
        if (result.is_valid() && !result.shorter.empty()) break;
    }
    REQUIRE(result.is_valid());
    const double smallest = measure_quality(result.mesh).min_scaled_jacobian;
    CHECK(smallest < 0.199);
    CHECK(result.smallest == Approx(smallest).margin(1e-3));
    CHECK(!result.shorter.empty());
    REQUIRE(result.place.size() == 1);
    CHECK(result.place[0].dim == 2);
    const SecondOrder good = of_wall(0.12, 3);
    CHECK(good.is_valid());
    CHECK(good.shorter.empty());
}

TEST_CASE("where elements stay folded, a valid mesh has straight sides there, which alone are off the part") {
    const Brep brep(box_with_bore(0.0005));
    RunContext context;
    const SecondOrder result = try_second_order(brep, straight_mesh(brep, 3, context), nullptr, context);
    REQUIRE_FALSE(result.is_valid());
    const StraightSides& straight = result.straight;
    CHECK(broken_invariants(straight.mesh).empty());
    CHECK(measure_quality(straight.mesh).min_scaled_jacobian > 0.049);
    CHECK(straight.sides > 0);
    CHECK(distance_from_entities(brep, straight.mesh) < straight.distance + 1e-8);
    const Projector projector(brep);
    std::size_t off = 0, mids = 0;
    for (std::size_t n = 0; n < straight.mesh.node_count(); ++n) {
        if (straight.mesh.entities[n].dim != 2) continue;
        const FaceId face(straight.mesh.entities[n].index);
        const bool is_mid = n >= straight.mesh.corner_count;
        const bool is_off = projector.nearest(face, straight.mesh.points[n]).distance > 1e-7;
        CHECK((is_mid || !is_off));
        mids += is_mid, off += is_off;
    }
    CHECK(off > 0);
    CHECK(off <= straight.sides);
    CHECK(off < mids / 2);
}

TEST_CASE("tets far thinner than their sides are bent follow them") {
    for (const double step : {1e-3, 1e-4}) {
        INFO(step);
        const Brep brep(shaft_with_step(step));
        const Mesh mesh = curved_mesh(brep, 4);
        CHECK(broken_invariants(mesh).empty());
        CHECK(measure_quality(mesh).min_scaled_jacobian > 0.199);
        CHECK(distance_from_entities(brep, mesh) < 1e-8);
    }
}

TEST_CASE("nodes beside needles do not move to where other tets are flat") {
    const double narrow = 0.004, size = GENERATE(3.0, 5.0, 8.0);
    INFO(size);
    const Brep brep(block_with_chamfered_bore(narrow));
    const Mesh mesh = curved_mesh(brep, size);
    CHECK(measure_quality(mesh).min_dihedral < 1);
    CHECK(worst_angle_without(mesh, 2 * narrow) > 15);
    CHECK(measure_quality(mesh).min_scaled_jacobian > 0.199);
}

TEST_CASE("mid-side nodes of an edge that goes through other vertices lie between its nodes") {
    const Mesh mesh = curved_mesh(Brep(block_with_step_and_slot()), 3);
    double furthest = 0;
    for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
        const auto& [a, b] = mesh.segments[s];
        const Vec3 middle = 0.5 * (mesh.point(a) + mesh.point(b));
        furthest = std::max(furthest, distance(middle, mesh.point(mesh.segment_mids[s])));
    }
    CHECK(furthest < 1e-4);
    CHECK(broken_invariants(mesh).empty());
}

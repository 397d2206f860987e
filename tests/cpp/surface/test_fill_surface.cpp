// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "catch.h"
#include "core/errors.h"
#include "surface/chart.h"
#include "surface/chart_domain.h"
#include "surface/patch_improvement.h"
#include "surface/projection.h"
#include "surface/triangle_patch.h"
#include "surface/turned_triangles.h"
#include "surface_checks.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// A block 30 x 20 under a wavy face whose parameters run a hundred times faster at one end than at the other.
TopoDS_Shape wild_spline_block() {
    TColgp_Array2OfPnt poles(1, 6, 1, 5);
    for (int i = 1; i <= 6; ++i)
        for (int j = 1; j <= 5; ++j)
            poles(i, j) = gp_Pnt(30 * std::pow((i - 1) / 5.0, 2.5), 20 * std::pow((j - 1) / 4.0, 0.5),
                                 10 + std::sin(1.7 * i + j));
    TColStd_Array1OfReal u(1, 4), v(1, 3);
    TColStd_Array1OfInteger u_times(1, 4), v_times(1, 3);
    u(1) = 0, u(2) = 0.01, u(3) = 0.7, u(4) = 1, v(1) = 0, v(2) = 0.9, v(3) = 1;
    u_times(1) = u_times(4) = v_times(1) = v_times(3) = 4, u_times(2) = u_times(3) = v_times(2) = 1;
    const Handle(Geom_BSplineSurface) surface = new Geom_BSplineSurface(poles, u, v, u_times, v_times, 3, 3);
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(surface, 1e-7).Face(), gp_Vec(0, 0, -10)).Shape();
}

/// A block 10 x 10 x 5 with a hill of this height in the middle of its top, mm.
TopoDS_Shape hill(double height) {
    TColgp_Array2OfPnt poles(1, 3, 1, 3);
    for (int i = 1; i <= 3; ++i)
        for (int j = 1; j <= 3; ++j) poles(i, j) = gp_Pnt(5 * (i - 1), 5 * (j - 1), i == 2 && j == 2 ? 4 * height : 0);
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Face(), gp_Vec(0, 0, -5))
        .Shape();
}

/// Between two edges of the part that meet at a vertex, degrees.
double smallest_corner_angle(const Brep& brep) {
    const Projector projector(brep);
    double smallest = 180;
    for (std::size_t v = 0; v < brep.vertex_count(); ++v) {
        std::vector<Vec3> into;
        for (const EdgeId e : brep.edges_of(VertexId(v))) {
            double first, last;
            BRep_Tool::Range(brep.edge(e), first, last);
            const bool is_start = brep.ends_of(e)[0] == VertexId(v);
            into.push_back(projector.tangent(e, is_start ? first : last) * (is_start ? 1.0 : -1.0));
        }
        for (std::size_t i = 0; i < into.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                smallest = std::min(smallest, std::acos(std::clamp(dot(into[i], into[j]), -1.0, 1.0)) * 180 / M_PI);
    }
    return smallest;
}

/// A plate 30 x 20 x 6, less what touches its top from within at (14, 11, 6).
std::vector<std::pair<std::string, TopoDS_Shape>> plates_touched_from_within() {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(30, 20, 6).Shape();
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(14, 11, 0), gp::DZ()), 4, 0, 6).Shape();
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(14, 11, 4), 2).Shape();
    return {{"a cone", BRepAlgoAPI_Cut(plate, cone).Shape()}, {"a ball", BRepAlgoAPI_Cut(plate, ball).Shape()}};
}

}  // namespace

TEST_CASE("a face with a wild parametrisation is meshed evenly") {
    const Brep brep(wild_spline_block());
    const Mesh mesh = mesh_surface(brep, 1.5).mesh;
    CHECK(surface_findings(brep, mesh) == std::vector<std::string>{});
    CHECK(euler_characteristic(mesh) == 2);
    // The edges enclose 21 degrees at one corner, and no more than the triangle there may be as sharp.
    std::vector<TriangleId> sharp;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (smallest_angle(mesh, TriangleId(t)) < 30) sharp.emplace_back(t);
    REQUIRE(sharp.size() == 1);
    CHECK(smallest_angle(mesh, sharp.front()) > smallest_corner_angle(brep));
    const auto& corners = mesh.triangles[sharp.front().index()];
    CHECK(std::count_if(corners.begin(), corners.end(), [&](NodeId n) { return mesh.entities[n.index()].dim == 0; }) ==
          1);
    CHECK(std::count_if(corners.begin(), corners.end(), [&](NodeId n) { return mesh.entities[n.index()].dim == 1; }) ==
          2);
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(brep.shape(), properties);
    CHECK(area(mesh) == Approx(properties.Mass()).epsilon(0.02));
}

TEST_CASE("what lies beside the solids is told of and gets no mesh") {
    TopoDS_Compound both;
    const BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeBox(10, 10, 10).Shape());
    CHECK(mesh_surface(Brep(both), 4).report.warnings.empty());
    builder.Add(both, BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 20), gp_Pnt(10, 0, 20)).Edge());
    builder.Add(both, BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 30), gp_Dir(0, 0, 1)), 0, 5, 0, 5).Face());
    const SurfaceResult result = mesh_surface(Brep(both), 4);
    REQUIRE(result.report.warnings.size() == 1);
    CHECK(result.report.warnings[0].in_english() == "Not meshed, because no solid has them: Face7, Edge13.");
    for (const Vec3& p : result.mesh.points) REQUIRE(p.z <= 10);
}

TEST_CASE("every kind of face is covered by a closed, well-shaped surface mesh") {
    for (const NamedShape& s : named_shapes()) {
        INFO(s.name);
        const Brep brep(s.shape);
        const SurfaceResult result = mesh_surface(brep, s.size);
        const auto broken = surface_findings(brep, result.mesh);
        INFO((broken.empty() ? std::string() : broken.front()));
        CHECK(broken.empty());
        CHECK(euler_characteristic(result.mesh) == s.euler);
        CHECK(smallest_angle(result.mesh) > 25);
        CHECK(result.report.min_angle_deg == Approx(smallest_angle(result.mesh)));
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(s.shape, properties);
        CHECK(area(result.mesh) == Approx(properties.Mass()).epsilon(0.04));
        CHECK(result.report.new_nodes == result.mesh.node_count());
        CHECK(result.report.new_triangles == result.mesh.triangles.size());
    }
}

TEST_CASE("a vertex inside a face has a node, in the triangles of all the faces that meet there") {
    for (const auto& [name, shape] : plates_touched_from_within()) {
        INFO(name);
        const Brep brep(shape);
        const Mesh mesh = mesh_surface(brep, 2).mesh;
        CHECK(surface_findings(brep, mesh) == std::vector<std::string>{});
        std::set<FaceId> faces;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (const NodeId n : mesh.triangles[t])
                if (distance(mesh.point(n), {14, 11, 6}) < 1e-9) faces.insert(mesh.triangle_faces[t]);
        CHECK(faces.size() == 2);
    }
}

TEST_CASE("one thread and several give the same bytes") {
    for (const NamedShape& s : named_shapes()) {
        INFO(s.name);
        const Brep brep(s.shape);
        const Mesh one = mesh_surface(brep, s.size).mesh, two = mesh_surface(brep, s.size, {}, 2).mesh;
        CHECK(one.points == two.points);
        CHECK(one.triangles == two.triangles);
        CHECK(one.segments == two.segments);
        CHECK(one.parameters == two.parameters);
    }
}

TEST_CASE("edge chains are even and symmetric") {
    const Brep brep(BRepPrimAPI_MakeBox(10, 20, 30).Shape());
    const Mesh mesh = mesh_surface(brep, 3).mesh;
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        double shortest = 1e300, longest = 0;
        for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
            if (mesh.segment_edges[s] != EdgeId(e)) continue;
            const double l = distance(mesh.point(mesh.segments[s][0]), mesh.point(mesh.segments[s][1]));
            shortest = std::min(shortest, l), longest = std::max(longest, l);
        }
        CHECK(longest - shortest < 1e-9);
        CHECK(longest > 2.5);
        CHECK(longest < 3.5);
    }
}

TEST_CASE("a coarse mesh is still a closed surface") {
    for (const NamedShape& s : named_shapes()) {
        INFO(s.name);
        const Brep brep(s.shape);
        const Mesh mesh = mesh_surface(brep, 0.1 * brep.box().diagonal()).mesh;
        CHECK(euler_characteristic(mesh) == s.euler);
        const auto broken = surface_findings(brep, mesh);
        INFO((broken.empty() ? std::string() : broken.front()));
        CHECK(broken.empty());
    }
}

TEST_CASE("no triangle reaches around the tip of a slender cone") {
    const double half_angle_deg = GENERATE(6.0, 11.4, 20.0), size = GENERATE(0.8, 1.0, 1.3, 2.0);
    INFO("half angle " << half_angle_deg << ", size " << size);
    const double radius = 10 * std::tan(half_angle_deg * std::numbers::pi / 180);
    const Brep brep(BRepPrimAPI_MakeCone(radius, 0, 10).Shape());
    const SurfaceResult result = mesh_surface(brep, size);
    CHECK(surface_findings(brep, result.mesh) == std::vector<std::string>{});
    RunContext context;
    CHECK(turned_triangles(brep, result.mesh, {}, context).empty());
}

TEST_CASE("rings around the tip of a cone keep off its base, however few pieces that has") {
    const double half_angle_deg = GENERATE(2.0, 3.0), turn_deg = GENERATE(120.0, 200.0, 300.0, 360.0);
    const double size = GENERATE(0.5, 1.1, 5.0);
    INFO("half angle " << half_angle_deg << ", turn " << turn_deg << ", size " << size);
    const double radius = 20 * std::tan(half_angle_deg * std::numbers::pi / 180);
    const Brep brep(turn_deg < 360 ? BRepPrimAPI_MakeCone(radius, 0, 20, turn_deg * std::numbers::pi / 180).Shape()
                                   : BRepPrimAPI_MakeCone(radius, 0, 20).Shape());
    const SurfaceResult result = mesh_surface(brep, size);
    CHECK(result.mesh.triangles.size() > 20);
    RunContext context;
    CHECK(turned_triangles(brep, result.mesh, {}, context).empty());
}

TEST_CASE("where a border passes close by a cone's apex no ring of tiny triangles lies around it") {
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(10, 10, 0), gp::DZ(), gp::DX()), 4, 0, 6).Shape();
    const double beyond = GENERATE(0.002, 0.1);
    const Brep brep(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10 + beyond, 20, 8).Shape(), cone).Shape());
    const Mesh mesh = mesh_surface(brep, 1).mesh;
    CHECK(surface_findings(brep, mesh).empty());
    const auto near = std::count_if(mesh.points.begin(), mesh.points.end(), [](const Vec3& p) {
        return distance(p, {10, 10, 6}) < 0.3;
    });
    CHECK(near == 2);
}

TEST_CASE("round the poles of a free-form face no side is split again and again") {
    for (const Vec3& half_axes : {Vec3{4.856, 1.91, 8.481}, Vec3{9.75, 3.524, 5.45}}) {
        const Brep brep(ellipsoid(half_axes));
        RunContext context;
        SizingOptions options;
        options.size = 1.5;
        const Mesh mesh = fill_surface(brep, make_sizing(brep, options, {}, context), {}, context).mesh;
        CHECK(surface_findings(brep, mesh).empty());
        CHECK(smallest_angle(mesh) > 20);
    }
}

TEST_CASE("a seed on the border of what is to be filled is left out, not let through it") {
    FaceBoundary square;
    square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 4; ++i) square.nodes.emplace_back(i), square.segments.push_back({i, (i + 1) % 4, EdgeId(0)});
    RunContext context;
    ChartDomain domain(square);
    REQUIRE(domain.is_valid());
    domain.insert(std::vector<Vec2>{{0.5, 0}, {1, 1}, {0.25, 0.5}}, Heartbeat(context));
    const TrianglePatch patch = domain.patch();
    CHECK(patch.triangles.size() == 4);
    for (const auto& corners : patch.triangles) CHECK(std::count(corners.begin(), corners.end(), 6) == 1);
}

TEST_CASE("the long sides of a face far larger than its border encloses are not split without end") {
    const Brep brep(hill(60));
    const auto top = [&] {
        for (std::size_t f = 0; f < brep.face_count(); ++f)
            if (BRepAdaptor_Surface(brep.face(FaceId(f))).GetType() == GeomAbs_BezierSurface) return FaceId(f);
        throw std::logic_error("no top");
    };
    const Chart chart(brep, top());
    const PatchGeometry geometry(chart);
    RunContext context;
    const Heartbeat heart(context);
    for (const double wanted : {4.0, 0.1}) {
        TrianglePatch patch;
        for (const auto& [u, v] : {std::array{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
            patch.points.push_back(chart.to_plane({u, v}));
        for (const Vec2& p : patch.points) patch.places.push_back(chart.point(p));
        patch.triangles = {{0, 1, 2}, {0, 2, 3}};
        patch.neighbours = {{-1, 1, -1}, {-1, -1, 0}};
        patch.triangle_of = {0, 0, 0, 1};
        patch.is_fixed = {1, 1, 1, 1};
        patch.nodes = {0, 1, 2, 3};
        patch.wanted.assign(4, wanted);
        CHECK(split_long_sides(patch, geometry, heart) == (wanted > 1));
        CHECK(patch.triangles.size() > 20);
    }
}

TEST_CASE("triangles that do not hang together are told of, not walked round for ever") {
    TrianglePatch patch;
    patch.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    patch.triangles = {{0, 1, 2}, {0, 2, 3}};
    patch.neighbours = {{-1, 1, -1}, {-1, -1, 0}};
    patch.triangle_of = {0, 0, 0, 1};
    std::vector<int> around;
    patch.star(0, around);
    CHECK(around == std::vector<int>{0, 1});
    patch.neighbours = {{-1, 1, 1}, {-1, 1, 1}};
    CHECK_THROWS_AS(patch.star(0, around), BrokenPatch);
}

TEST_CASE("a face between an arc and what lies within its height gets more pieces than its size asks for") {
    const gp_Pnt a(0, 0, 0), b(2, 0, 0), within(1, 0.1, 0), on_arc(1, 0.2, 0);
    BRepBuilderAPI_MakeWire border;
    border.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(b, on_arc, a).Value()));
    border.Add(BRepBuilderAPI_MakeEdge(a, within));
    border.Add(BRepBuilderAPI_MakeEdge(within, b));
    const Brep brep(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(border.Wire()).Face(), gp_Vec(0, 0, 6)).Shape());
    const SurfaceResult result = mesh_surface(brep, 4);
    CHECK(surface_findings(brep, result.mesh).empty());
    CHECK_FALSE(result.report.warnings.empty());
}

TEST_CASE("an edge that loops within its own tolerance is stepped over") {
    // A drill's tip that a wall passes by at 0.006: the kernel's curve there has a loop of 0.1, and a tolerance of
    // 0.18.
    const gp_Pnt foot(9.796, 15.508, 1.522);
    const gp_Ax2 axes(foot, gp::DZ(), gp_Dir(std::cos(4.595), std::sin(4.595), 0));
    const double height = 3.78, radius = height * std::tan(59 * std::numbers::pi / 180);
    const TopoDS_Shape tip = BRepPrimAPI_MakeCone(axes, radius, 0, height).Shape(),
                       shank =
                           BRepPrimAPI_MakeCylinder(gp_Ax2({foot.X(), foot.Y(), -1}, gp::DZ()), radius, foot.Z() + 1),
                       wall = BRepPrimAPI_MakeCylinder(gp_Ax2({foot.X() + 7.994, foot.Y(), -20}, gp::DZ()), 8, 40);
    const TopoDS_Shape drilled =
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20, 20, 12).Shape(), BRepAlgoAPI_Fuse(shank, tip).Shape()).Shape();
    const Brep brep(BRepAlgoAPI_Cut(drilled, wall).Shape());
    RunContext context;
    SizingOptions options;
    options.size = 1;
    const Mesh mesh = fill_surface(brep, make_sizing(brep, options, {}, context), {}, context).mesh;
    CHECK(mesh.triangles.size() > 1000);
    CHECK(turned_triangles(brep, mesh, {}, context).empty());
}

TEST_CASE("a strip far thinner than the size gets no nodes but those of its edges") {
    for (const double width : {0.01, 1e-4}) {
        const Brep brep(BRepPrimAPI_MakeBox(width, 6, 10).Shape());
        const Mesh mesh = mesh_surface(brep, 1).mesh;
        CHECK(surface_findings(brep, mesh).empty());
        for (std::size_t n = 0; n < mesh.node_count(); ++n) {
            if (mesh.entities[n].dim < 2) continue;
            CHECK((mesh.points[n].x == 0 || mesh.points[n].x == width));
        }
    }
}

TEST_CASE("filling stops when it is cancelled") {
    const Brep brep(BRepPrimAPI_MakeBox(10, 20, 30).Shape());
    RunContext context;
    SizingOptions options;
    options.size = 0.5;
    const SizingField sizing = make_sizing(brep, options, {}, context);
    context.on_progress = [](std::string_view, double) { return false; };
    CHECK_THROWS_AS(fill_surface(brep, sizing, {}, context), Cancelled);
}

TEST_CASE("triangles that lie the wrong way round are found, on every kind of face and whatever their corners lie on") {
    for (const NamedShape& s : named_shapes()) {
        INFO(s.name);
        const Brep brep(s.shape);
        Mesh mesh = mesh_surface(brep, s.size).mesh;
        RunContext context;
        context.threads = 2;
        CHECK(turned_triangles(brep, mesh, {}, context).empty());
        std::vector<TriangleId> swapped;
        std::vector<char> is_wanted(mesh.node_count(), 0);
        for (std::size_t t = 3; t < mesh.triangles.size(); t += 7) {
            std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
            swapped.push_back(TriangleId(t));
        }
        CHECK(turned_triangles(brep, mesh, {}, context) == swapped);
        for (const NodeId n : mesh.triangles[3]) is_wanted[n.index()] = 1;
        CHECK(turned_triangles(brep, mesh, is_wanted, context) == std::vector{TriangleId(3)});
    }
}

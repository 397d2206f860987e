// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_checks.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Circ.hxx>
#include <map>
#include <set>

#include "surface/projection.h"

namespace featuremesh::testing {

namespace {

TopoDS_Shape turned(const TopoDS_Shape& shape) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 2, 3)), 0.651);
    return BRepBuilderAPI_Transform(shape, turn, true).Shape();
}

TopoDS_Shape rounded_box() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 30, 30).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next()) fillet.Add(5, TopoDS::Edge(it.Current()));
    return fillet.Shape();
}

TopoDS_Shape plate_with_holes() {
    TopoDS_Shape plate = BRepPrimAPI_MakeBox(60, 40, 5).Shape();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 2; ++j)
            plate = BRepAlgoAPI_Cut(plate, BRepPrimAPI_MakeCylinder(
                                               gp_Ax2(gp_Pnt(10 + 20 * i, 10 + 20 * j, 0), gp_Dir(0, 0, 1)), 4, 5)
                                               .Shape())
                        .Shape();
    return plate;
}

TopoDS_Shape square_to_circle() {
    BRepOffsetAPI_ThruSections loft(true);
    loft.AddWire(
        BRepBuilderAPI_MakePolygon(gp_Pnt(-10, -10, 0), gp_Pnt(10, -10, 0), gp_Pnt(10, 10, 0), gp_Pnt(-10, 10, 0), true)
            .Wire());
    const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, 30), gp_Dir(0, 0, 1)), 8);
    loft.AddWire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire());
    return loft.Shape();
}

std::array<NodeId, 2> ordered(NodeId a, NodeId b) { return a < b ? std::array{a, b} : std::array{b, a}; }

}  // namespace

std::vector<NamedShape> named_shapes() {
    const TopoDS_Shape torus_on_box =
        BRepAlgoAPI_Fuse(BRepPrimAPI_MakeTorus(30, 8).Shape(), BRepPrimAPI_MakeBox(40, 30, 10).Shape()).Shape();
    const TopoDS_Shape hollow = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(30, 30, 30).Shape(),
                                                BRepPrimAPI_MakeBox(gp_Pnt(10, 10, 10), 10, 10, 10).Shape())
                                    .Shape();
    std::vector<NamedShape> list{
        {"box", BRepPrimAPI_MakeBox(10, 20, 30).Shape(), 2.5, 2},
        {"cylinder", BRepPrimAPI_MakeCylinder(10, 30).Shape(), 2.5, 2},
        {"part of a cylinder", BRepPrimAPI_MakeCylinder(10, 30, 2).Shape(), 2, 2},
        {"cone", BRepPrimAPI_MakeCone(15, 5, 30).Shape(), 3, 2},
        {"cone with apex", BRepPrimAPI_MakeCone(15, 0, 30).Shape(), 3, 2},
        {"hanging cone with apex", BRepPrimAPI_MakeCone(0, 15, 30).Shape(), 3, 2},
        {"sphere", BRepPrimAPI_MakeSphere(20).Shape(), 4, 2},
        {"part of a sphere", BRepPrimAPI_MakeSphere(20, -0.5, 1, 4).Shape(), 3, 2},
        {"torus", BRepPrimAPI_MakeTorus(20, 6).Shape(), 3, 0},
        {"torus on a box", torus_on_box, 3, 0},
        {"rounded box", rounded_box(), 2, 2},
        {"plate with holes", plate_with_holes(), 2, -10},
        {"loft", square_to_circle(), 2, 2},
        {"box with a void", hollow, 3, 4},
    };
    for (NamedShape& s : list) s.shape = turned(s.shape);
    return list;
}

TopoDS_Shape ellipsoid(const Vec3& half_axes) {
    gp_GTrsf stretch;
    for (int k = 0; k < 3; ++k) stretch.SetValue(k + 1, k + 1, half_axes[k]);
    return BRepBuilderAPI_GTransform(BRepPrimAPI_MakeSphere(1).Shape(), stretch, true).Shape();
}

SurfaceResult mesh_surface(const Brep& brep, double size, Mesh kept, int threads) {
    RunContext context;
    context.threads = threads;
    SizingOptions options;
    options.size = size;
    options.elements_per_circle = 0;
    options.pieces_round_rod = 0;
    return fill_surface(brep, make_sizing(brep, options, {}, context), std::move(kept), context);
}

SurfaceResult mesh_surface(const Brep& brep, double size, NarrowFaces narrow) {
    RunContext context;
    SizingOptions sizing;
    sizing.size = size;
    SurfaceOptions options;
    options.narrow = narrow;
    return fill_surface(brep, make_sizing(brep, sizing, {}, context), {}, context, options);
}

std::vector<std::string> surface_findings(const Brep& brep, const Mesh& mesh) {
    std::vector<std::string> found;
    const Projector projector(brep);
    std::vector<int> vertex_nodes(brep.vertex_count(), 0);
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
        const Entity e = mesh.entities[n];
        const auto id = static_cast<std::size_t>(e.index);
        if (e.dim == 0) ++vertex_nodes[id];
        const Vec3 there = e.dim == 0   ? brep.point_of(VertexId(id))
                           : e.dim == 1 ? projector.on_edge(EdgeId(id), mesh.parameters[n][0])
                                        : projector.on_face(FaceId(id), mesh.parameters[n]);
        if (distance(there, mesh.points[n]) > 1e-8)
            found.push_back("node " + std::to_string(n) + " is not on " + name_of(e));
        if (e.dim == 2 && !projector.is_inside_trim(FaceId(id), mesh.parameters[n]))
            found.push_back("node " + std::to_string(n) + " is outside " + name_of(e));
    }
    for (const int count : vertex_nodes)
        if (count != 1) found.push_back("a vertex has " + std::to_string(count) + " nodes");

    std::map<std::array<NodeId, 2>, int> uses;
    std::set<std::array<NodeId, 3>> seen;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        auto c = mesh.triangles[t];
        const Vec3 a = mesh.point(c[0]), b = mesh.point(c[1]), d = mesh.point(c[2]);
        const FaceId face = mesh.triangle_faces[t];
        const OnFace foot = projector.nearest(face, (a + b + d) / 3);
        if (dot(cross(b - a, d - a), projector.normal(face, foot.uv)) <= 0)
            found.push_back("a triangle of " + name_of(entity_of(face)) + " is the wrong way round");
        for (int i = 0; i < 3; ++i) ++uses[ordered(c[i], c[(i + 1) % 3])];
        std::sort(c.begin(), c.end());
        if (!seen.insert(c).second) found.push_back("a triangle is there twice");
    }
    std::map<std::array<NodeId, 2>, EdgeId> segments;
    for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
        const auto [a, b] = mesh.segments[s];
        if (!segments.emplace(ordered(a, b), mesh.segment_edges[s]).second) found.push_back("a segment is there twice");
        if (!uses.count(ordered(a, b)))
            found.push_back("a segment of " + name_of(entity_of(mesh.segment_edges[s])) + " is on no triangle");
    }
    for (const auto& [side, count] : uses)
        if (count != 2) found.push_back("a side is shared by " + std::to_string(count) + " triangles");
    return found;
}

int euler_characteristic(const Mesh& mesh) {
    std::set<std::array<NodeId, 2>> sides;
    std::set<NodeId> nodes;
    for (const auto& t : mesh.triangles)
        for (int i = 0; i < 3; ++i) nodes.insert(t[i]), sides.insert(ordered(t[i], t[(i + 1) % 3]));
    return static_cast<int>(nodes.size()) - static_cast<int>(sides.size()) + static_cast<int>(mesh.triangles.size());
}

double smallest_angle(const Mesh& mesh, TriangleId triangle) {
    const auto& t = mesh.triangles[triangle.index()];
    double smallest = M_PI;
    for (int i = 0; i < 3; ++i) {
        const Vec3 u = mesh.point(t[(i + 1) % 3]) - mesh.point(t[i]), v = mesh.point(t[(i + 2) % 3]) - mesh.point(t[i]);
        smallest = std::min(smallest, std::atan2(length(cross(u, v)), dot(u, v)));
    }
    return smallest * 180 / M_PI;
}

double smallest_angle(const Mesh& mesh) {
    double smallest = 180;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        smallest = std::min(smallest, smallest_angle(mesh, TriangleId(t)));
    return smallest;
}

double area(const Mesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles)
        sum += 0.5 * length(cross(mesh.point(t[1]) - mesh.point(t[0]), mesh.point(t[2]) - mesh.point(t[0])));
    return sum;
}

}  // namespace featuremesh::testing

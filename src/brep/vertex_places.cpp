// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/vertex_places.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <set>

#include "brep/occt_geometry.h"

namespace featuremesh {

namespace {

/// The points before or behind an edge's end: `inward` is the unit direction into the edge, zero where it has none.
struct EdgeEnd {
    Vec3 point, inward;

    double beyond(const Vec3& p) const { return dot(point - p, inward); }
};

EdgeEnd end_of(const TopoDS_Edge& edge, bool is_start) {
    const BRepAdaptor_Curve curve(edge);
    gp_Pnt p;
    gp_Vec d;
    curve.D1(is_start ? curve.FirstParameter() : curve.LastParameter(), p, d);
    const double speed = d.Magnitude();
    return {to_vec3(p), speed > 0 ? to_vec3(d) * ((is_start ? 1 : -1) / speed) : Vec3{}};
}

double farthest_beyond(const std::vector<EdgeEnd>& ends, const Vec3& p) {
    double farthest = 0;
    for (const EdgeEnd& end : ends) farthest = std::max(farthest, end.beyond(p));
    return farthest;
}

/// No further beyond the ends than this is still at them.
const double slack = 0.8 * Precision::Confusion();

/// Towards a place behind all the ends.
Vec3 moved_inside(const std::vector<EdgeEnd>& ends, Vec3 p) {
    constexpr int rounds = 60;
    for (int round = 0; round < rounds; ++round) {
        Vec3 sum{};
        int count = 0;
        for (const EdgeEnd& end : ends) {
            const double beyond = end.beyond(p) - slack;
            if (beyond <= 0) continue;
            sum = sum + end.inward * beyond;
            ++count;
        }
        if (count == 0) return p;
        p = p + sum / count;
    }
    return p;
}

double distance_from(const TopoDS_Face& face, const Vec3& p) {
    return BRepExtrema_DistShapeShape(BRepBuilderAPI_MakeVertex(to_pnt(p)).Vertex(), face).Value();
}

}  // namespace

bool is_loose(const TopoDS_Vertex& vertex) { return BRep_Tool::Tolerance(vertex) > 1.01 * Precision::Confusion(); }

double distance_beyond_end(const TopoDS_Edge& edge, bool is_start, const Vec3& p) {
    return end_of(edge, is_start).beyond(p);
}

std::vector<Vec3> vertex_places(const std::vector<TopoDS_Vertex>& vertices, const std::vector<TopoDS_Edge>& edges,
                                const std::vector<std::array<VertexId, 2>>& ends, const std::vector<TopoDS_Face>& faces,
                                const std::vector<std::vector<FaceId>>& faces_of) {
    std::vector<Vec3> places;
    for (const TopoDS_Vertex& vertex : vertices) places.push_back(to_vec3(BRep_Tool::Pnt(vertex)));
    std::vector<std::vector<EdgeEnd>> ends_at(vertices.size());
    std::vector<std::set<FaceId>> faces_at(vertices.size());
    for (std::size_t e = 0; e < edges.size(); ++e)
        for (const std::size_t end : {0, 1}) {
            const VertexId vertex = ends[e][end];
            if (!vertex.is_valid() || !is_loose(vertices[vertex.index()]) || BRep_Tool::Degenerated(edges[e])) continue;
            ends_at[vertex.index()].push_back(end_of(edges[e], end == 0));
            faces_at[vertex.index()].insert(faces_of[e].begin(), faces_of[e].end());
        }
    for (std::size_t v = 0; v < places.size(); ++v) {
        if (farthest_beyond(ends_at[v], places[v]) <= Precision::Confusion()) continue;
        const Vec3 place = moved_inside(ends_at[v], places[v]);
        if (farthest_beyond(ends_at[v], place) > 1.01 * slack ||
            distance(place, places[v]) > BRep_Tool::Tolerance(vertices[v]))
            continue;
        const auto is_on = [&](FaceId f) {
            const double d = distance_from(faces[f.index()], place);
            return d <= Precision::Confusion() || d <= distance_from(faces[f.index()], places[v]);
        };
        if (std::all_of(faces_at[v].begin(), faces_at[v].end(), is_on)) places[v] = place;
    }
    return places;
}

}  // namespace featuremesh

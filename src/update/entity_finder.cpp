// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/entity_finder.h"

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "brep/occt_geometry.h"
#include "core/sort_once.h"

namespace featuremesh {

std::vector<EdgeId> edges_at(const Brep& brep, Entity entity) {
    if (entity.dim == 1) return {EdgeId(entity.index)};
    if (entity.dim != 0) return {};
    const auto at_vertex = brep.edges_of(VertexId(entity.index));
    std::vector<EdgeId> edges(at_vertex.begin(), at_vertex.end());
    sort_once(edges);
    return edges;
}

std::vector<FaceId> faces_at(const Brep& brep, Entity entity) {
    std::vector<FaceId> faces = brep.faces_at(entity);
    if (entity.dim < 2) std::erase_if(faces, [&](FaceId face) { return !brep.is_meshed(face); });
    return faces;
}

EntityFinder::EntityFinder(const Brep& brep, double tolerance)
    : brep_(brep),
      tolerance_(tolerance),
      projector_(brep),
      edge_boxes_(brep.edge_count()),
      face_boxes_(brep.face_count()) {
    for (std::size_t f = 0; f < brep.face_count(); ++f)
        if (brep.is_meshed(FaceId(f))) face_boxes_[f] = brep.box_of(FaceId(f)).grown(tolerance);
    for (std::size_t e = 0; e < brep.edge_count(); ++e)
        if (!brep.is_degenerated(EdgeId(e)) && !faces_at(brep, entity_of(EdgeId(e))).empty())
            edge_boxes_[e] = box_of(brep.edge(EdgeId(e))).grown(tolerance);
}

PointPlace EntityFinder::find(const Vec3& p) const {
    PointPlace place;
    if (find_vertex(p, place) || find_edge(p, place) || find_face(p, place)) return place;
    return {};
}

bool EntityFinder::find_vertex(const Vec3& p, PointPlace& place) const {
    double nearest = tolerance_;
    for (std::size_t v = 0; v < brep_.vertex_count(); ++v) {
        const double d = brep_.distance_from(VertexId(v), p);
        if (d > nearest || faces_at(brep_, entity_of(VertexId(v))).empty()) continue;
        nearest = d;
        place = {entity_of(VertexId(v)), {0, 0}};
    }
    return place.entity.dim == 0;
}

bool EntityFinder::find_edge(const Vec3& p, PointPlace& place) const {
    double nearest = tolerance_;
    for (std::size_t e = 0; e < edge_boxes_.size(); ++e) {
        if (!edge_boxes_[e].contains(p)) continue;
        const OnEdge foot = projector_.nearest(EdgeId(e), p);
        if (foot.distance > nearest) continue;
        nearest = foot.distance;
        place = {entity_of(EdgeId(e)), {foot.t, 0}};
    }
    return place.entity.dim == 1;
}

bool EntityFinder::find_face(const Vec3& p, PointPlace& place) const {
    double nearest = tolerance_;
    for (std::size_t f = 0; f < face_boxes_.size(); ++f) {
        if (!face_boxes_[f].contains(p)) continue;
        const OnFace foot = projector_.nearest(FaceId(f), p);
        if (foot.distance > nearest || !projector_.is_inside_trim(FaceId(f), foot.uv)) continue;
        nearest = foot.distance;
        place = {entity_of(FaceId(f)), foot.uv};
    }
    return place.entity.dim == 2;
}

}  // namespace featuremesh

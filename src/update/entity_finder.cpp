// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/entity_finder.h"

#include <BRep_Tool.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <utility>

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

namespace {

Box box_of_point(const Brep& brep, VertexId vertex) {
    Box box;
    box.add(brep.point_of(vertex));
    box.add(to_vec3(BRep_Tool::Pnt(brep.vertex(vertex))));
    return box;
}

/// Grown by the tolerance; empty where no face is meshed.
template <class Id, class BoxOf>
BoxTree boxes_of(const Brep& brep, std::size_t count, double tolerance, BoxOf box_of) {
    std::vector<Box> boxes(count);
    for (std::size_t i = 0; i < count; ++i)
        if (const std::vector<FaceId> faces = brep.faces_at(entity_of(Id(i)));
            std::any_of(faces.begin(), faces.end(), [&](FaceId face) { return brep.is_meshed(face); }))
            if (const Box box = box_of(Id(i)); !box.is_empty()) boxes[i] = box.grown(tolerance);
    return BoxTree(boxes);
}

}  // namespace

EntityFinder::EntityFinder(const Brep& brep, double tolerance)
    : EntityFinder(
          brep, tolerance, Projector(brep),
          std::make_shared<BoxTrees>(BoxTrees{
              boxes_of<VertexId>(brep, brep.vertex_count(), tolerance,
                                 [&](VertexId v) { return box_of_point(brep, v); }),
              boxes_of<EdgeId>(brep, brep.edge_count(), tolerance, [&](EdgeId e) { return brep.box_of(e); }),
              boxes_of<FaceId>(brep, brep.face_count(), tolerance, [&](FaceId f) { return brep.box_of(f); })})) {}

EntityFinder::EntityFinder(const Brep& brep, double tolerance, Projector projector,
                           std::shared_ptr<const BoxTrees> boxes)
    : brep_(brep), tolerance_(tolerance), projector_(std::move(projector)), boxes_(std::move(boxes)) {}

PointPlace EntityFinder::find(const Vec3& p) const {
    PointPlace place;
    for (int dim = 0; dim < 3 && place.entity.dim == 3; ++dim) {
        double nearest = tolerance_;
        (*boxes_)[std::size_t(dim)].visit_around(p, [&](std::int32_t index) {
            const double before = nearest;
            const auto found = place_on({dim, index}, p, nearest);
            if (found && (nearest < before || place.entity.dim == 3 || index > place.entity.index)) place = *found;
        });
    }
    return place;
}

std::optional<PointPlace> EntityFinder::place_on(Entity entity, const Vec3& p, double& nearest) const {
    PointPlace place{entity, {0, 0}};
    double distance = 0;
    if (entity.dim == 0) {
        distance = brep_.distance_from(VertexId(entity.index), p);
    } else if (entity.dim == 1) {
        const OnEdge foot = projector_.nearest(EdgeId(entity.index), p);
        distance = foot.distance, place.parameters[0] = foot.t;
    } else {
        const OnFace foot = projector_.nearest(FaceId(entity.index), p);
        distance = foot.distance, place.parameters = foot.uv;
        if (distance <= nearest && !projector_.is_inside_trim(FaceId(entity.index), foot.uv)) return {};
    }
    if (distance > nearest) return {};
    nearest = distance;
    return place;
}

}  // namespace featuremesh

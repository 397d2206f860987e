// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/kept_entities.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "brep/common_body.h"
#include "core/sort_once.h"
#include "difference/feature_difference.h"
#include "surface/face_parameters.h"
#include "update/entity_finder.h"

namespace featuremesh {

namespace {

Vec3 point_on(const Projector& projector, Entity on, const std::array<double, 2>& parameters) {
    return on.dim == 1 ? projector.on_edge(EdgeId(on.index), parameters[0])
                       : projector.on_face(FaceId(on.index), parameters);
}

}  // namespace

KeptEntities::KeptEntities(const CarriedNodes& nodes)
    : nodes_(nodes),
      in_(nodes.input),
      projector_(in_.new_brep),
      merged_(std::make_shared<const MergedEntities>(in_.new_brep, in_.ignored_below)),
      entities_(in_.old_mesh.entities),
      parameters_(in_.old_mesh.parameters),
      is_untouched_(in_.old_brep.face_count(), 0),
      edge_ranges_(in_.new_brep.edge_count()) {
    for (const FaceChange& change : in_.difference.faces)
        if (change.verdict == BoundaryVerdict::kept) is_untouched_[change.old_face.index()] = 1;
}

// The verdict "unchanged" is not believed: every boundary node is measured against the new shape.
bool KeptEntities::place(std::size_t n) {
    const Entity old_entity = in_.old_mesh.entities[n];
    if (old_entity.dim == 3) return true;  // its solid follows from its tets
    return place_at(n, nodes_.at(n));
}

bool KeptEntities::place_at(std::size_t n, const Vec3& p) {
    const Entity old_entity = in_.old_mesh.entities[n];
    Place place{nodes_.motions[n], old_entity, parameters_[n]};
    if (!find_place(place, std::size_t(old_entity.index), p)) return false;
    entities_[n] = place.entity;
    parameters_[n] = place.parameter;
    return true;
}

bool KeptEntities::place_straight(std::size_t n) {
    const Entity old_entity = in_.old_mesh.entities[n];
    if (old_entity.dim != 1 && old_entity.dim != 2) return false;
    if (!old_projector_) old_projector_.emplace(in_.old_brep);
    const Vec3 was = point_on(*old_projector_, old_entity, in_.old_mesh.parameters[n]);
    return place_at(n, nodes_.regions()[nodes_.motion_of(NodeId(n))].motion.apply(was));
}

KeptStraightSides KeptEntities::straight_sides_of(const Mesh& kept) const {
    KeptStraightSides found;
    for (std::size_t n = kept.corner_count; n < kept.points.size(); ++n) {
        const Entity on = kept.entities[n];
        if (on.dim != 1 && on.dim != 2) continue;
        const double off = distance(point_on(projector_, on, kept.parameters[n]), kept.points[n]);
        if (off <= tolerance()) continue;
        ++found.sides;
        found.distance = std::max(found.distance, off);
        found.places.push_back(on);
    }
    sort_once(found.places);
    return found;
}

bool KeptEntities::find_place(Place& place, std::size_t old_index, const Vec3& p) {
    const CarriedRegion& region = nodes_.regions()[std::size_t(place.motion)];
    switch (place.entity.dim) {
        case 0:
            return old_index < region.new_vertex_of.size() &&
                   place_on_vertex(place, region.new_vertex_of[old_index], p);
        case 1:
            return old_index < region.new_edges_of.size() && place_on_edges(place, region.new_edges_of[old_index], p);
        case 2:
            return old_index < region.new_faces_of.size() && place_on_faces(place, old_index, p);
        default:
            return false;
    }
}

bool KeptEntities::place_on_vertex(Place& place, VertexId vertex, const Vec3& p) const {
    if (!vertex.is_valid()) return false;
    place.entity = entity_of(vertex);
    return in_.new_brep.distance_from(vertex, p) <= tolerance();
}

// An edge may have been split, or be one with others: the piece that the node lies within has it.
bool KeptEntities::place_on_edges(Place& place, const std::vector<EdgeId>& pieces, const Vec3& p) {
    return std::any_of(pieces.begin(), pieces.end(), [&](EdgeId edge) { return place_on_edge(place, edge, p); });
}

bool KeptEntities::place_on_edge(Place& place, EdgeId piece, const Vec3& p) {
    const EdgeId edge = merged_->edge_of[piece.index()];  // the one that has the chain
    place.entity = entity_of(edge);
    EdgeRange& range = edge_ranges_[edge.index()];
    if (!(range.first < range.last)) range = range_of(in_.new_brep, edge);
    const auto is_within = [&](double t) { return t > range.first && t < range.last; };
    if (is_within(place.parameter[0]) && distance(projector_.on_edge(edge, place.parameter[0]), p) <= tolerance())
        return true;
    const OnEdge foot = projector_.nearest(edge, p);
    if (!is_within(foot.t) || foot.distance > tolerance()) return false;
    if (const EdgeId owner = merged_->owner_at(edge, foot.t); owner != edge) return place_on_edge(place, owner, p);
    place.parameter[0] = foot.t;
    return true;
}

// Where a face's boundary is the old one a point that was inside still is: everywhere, or far from all that changed.
bool KeptEntities::is_untouched(const Place& place, std::size_t old_face, const Vec3& p) const {
    return (place.motion == 0 && is_untouched_[old_face]) || is_far_from_changes(place, p);
}

bool KeptEntities::is_far_from_changes(const Place& place, const Vec3& p) const {
    const ChangedBoundary& changed = nodes_.regions()[std::size_t(place.motion)].changed;
    if (changed.is_empty()) return false;
    return !changed.box().grown(2 * in_.margin * in_.new_sizing.largest()).contains(p) ||
           !changed.is_within(2 * in_.margin * in_.new_sizing.at(p), p);
}

bool KeptEntities::place_on_faces(Place& place, std::size_t old_face, const Vec3& p) {
    const auto& pieces = nodes_.regions()[std::size_t(place.motion)].new_faces_of[old_face];
    if (pieces.size() == 1) return place_on_face(place, pieces[0], p, is_untouched(place, old_face, p));
    std::vector<FaceId> near;
    for (const FaceId face : pieces)
        if (may_hold(face, p)) near.push_back(face);
    const bool is_clear = near.size() == 1 && is_far_from_changes(place, p);
    return std::any_of(near.begin(), near.end(), [&](FaceId face) { return place_on_face(place, face, p, is_clear); });
}

bool KeptEntities::may_hold(FaceId face, const Vec3& p) const {
    return in_.new_brep.box_of(face).grown(tolerance()).contains(p);
}

bool KeptEntities::place_on_face(Place& place, FaceId face, const Vec3& p, bool is_untouched) const {
    place.entity = entity_of(face);
    std::array<double, 2> uv = place.parameter;
    if (distance(projector_.on_face(face, uv), p) > tolerance()) {
        const OnFace foot = projector_.nearest(face, p);
        uv = foot.uv;
        if (foot.distance > tolerance()) return false;
    }
    if (!is_untouched && !projector_.is_inside_trim(face, uv)) return false;
    place.parameter = uv;
    return true;
}

std::optional<SolidId> KeptEntities::solid_beside(std::size_t node, const Vec3& p) const {
    constexpr double least_cosine = 0.3;
    if (entities_[node].dim != 2 || nodes_.motions[node] < 0) return {};
    const FaceId face(entities_[node].index);
    const Vec3 way = p - nodes_.at(node);
    const double height = dot(projector_.normal(face, parameters_[node]), way);
    if (std::abs(height) < least_cosine * length(way)) return {};
    const auto [behind, before] = in_.new_brep.solids_beside(face);
    if (!behind.is_valid() && !before.is_valid()) return {};
    return height < 0 ? behind : before;
}

FaceId KeptEntities::face_of(std::size_t triangle) const {
    const auto& nodes = in_.old_mesh.triangles[triangle];
    const CarriedRegion& region = nodes_.regions()[nodes_.motion_of(nodes[0])];
    const auto& pieces = region.new_faces_of[in_.old_mesh.triangle_faces[triangle].index()];
    if (pieces.size() < 2) {
        // where two solids have parted, one of them took the nodes that they had in common
        const auto is_of_other = [&](NodeId n) {
            const Entity on = entities_[n.index()];
            return on.dim < 2 && !share_body(in_.new_brep, on, entity_of(pieces[0]));
        };
        const bool is_lost =
            pieces.empty() || (in_.new_brep.body_count() > 1 && std::any_of(nodes.begin(), nodes.end(), is_of_other));
        return is_lost ? FaceId() : pieces[0];
    }
    for (const NodeId n : nodes)
        if (entities_[n.index()].dim == 2) return FaceId(entities_[n.index()].index);
    const auto is_at = [&](NodeId n, FaceId face) {
        const std::vector<FaceId> faces = faces_at(in_.new_brep, entities_[n.index()]);
        return std::binary_search(faces.begin(), faces.end(), face);
    };
    std::vector<FaceId> candidates;
    for (const FaceId face : pieces)
        if (std::all_of(nodes.begin(), nodes.end(), [&](NodeId n) { return is_at(n, face); }))
            candidates.push_back(face);
    if (candidates.size() < 2)
        return candidates.empty() ? FaceId() : candidates[0];  // its middle may lie beyond the chord of an arc
    const Vec3 middle = (nodes_.at(nodes[0]) + nodes_.at(nodes[1]) + nodes_.at(nodes[2])) / 3.0;
    for (const FaceId face : candidates)
        if (projector_.is_inside_trim(face, projector_.nearest(face, middle).uv)) return face;
    return FaceId();
}

bool KeptEntities::has_node_inside(std::size_t triangle, FaceId face) const {
    const auto& nodes = in_.old_mesh.triangles[triangle];
    return std::any_of(nodes.begin(), nodes.end(), [&](NodeId n) { return entities_[n.index()] == entity_of(face); });
}

double KeptEntities::cosine_to(FaceId face, std::size_t triangle) const {
    const auto& nodes = in_.old_mesh.triangles[triangle];
    const Vec3 a = nodes_.at(nodes[0]), b = nodes_.at(nodes[1]), c = nodes_.at(nodes[2]);
    const auto inner =
        std::find_if(nodes.begin(), nodes.end(), [&](NodeId n) { return entities_[n.index()] == entity_of(face); });
    std::optional<std::array<double, 2>> at_border;
    if (inner == nodes.end() && projector_.needs_search(face))
        for (const NodeId n : nodes)
            if (const Entity on = entities_[n.index()]; !at_border && on.dim == 1)
                at_border = parameters_on(in_.new_brep, face, EdgeId(on.index), parameters_[n.index()][0]);
    const std::array<double, 2> uv =
        inner != nodes.end() ? parameters_[inner->index()] : projector_.nearest(face, (a + b + c) / 3.0, at_border).uv;
    const Vec3 normal = cross(b - a, c - a);
    const double size = length(normal);
    return size > 0 ? dot(projector_.normal(face, uv), normal) / size : 0;
}

// Of several (two arcs between two vertices) it is the nearest.
EdgeId KeptEntities::edge_of(std::size_t segment) const {
    const auto& nodes = in_.old_mesh.segments[segment];
    std::vector<EdgeId> candidates;
    const std::size_t r = nodes_.motion_of(nodes[0]);
    for (const EdgeId piece : nodes_.regions()[r].new_edges_of[in_.old_mesh.segment_edges[segment].index()])
        if (const EdgeId edge = merged_->edge_of[piece.index()]; is_at(edge, nodes[0]) && is_at(edge, nodes[1]))
            candidates.push_back(edge);
    if (candidates.size() < 2) return candidates.empty() ? EdgeId() : candidates[0];
    const Vec3 middle = (nodes_.at(nodes[0]) + nodes_.at(nodes[1])) / 2.0;
    EdgeId best;
    double least = std::numeric_limits<double>::infinity();
    for (const EdgeId edge : candidates) {
        const double d = projector_.nearest(edge, middle).distance;
        if (d < least) least = d, best = edge;
    }
    return best;
}

bool KeptEntities::is_at(EdgeId edge, NodeId node) const {
    const Entity entity = entities_[node.index()];
    if (entity.dim == 1) return entity == entity_of(edge);
    const auto ends = in_.new_brep.ends_of(edge);
    const VertexId vertex = merged_->vertex_of[std::size_t(entity.index)];
    return merged_->vertex_of[ends[0].index()] == vertex || merged_->vertex_of[ends[1].index()] == vertex;
}

bool KeptEntities::runs_backwards(std::size_t segment, EdgeId edge) const {
    const auto& nodes = in_.old_mesh.segments[segment];
    const Vec3 a = nodes_.at(nodes[0]), b = nodes_.at(nodes[1]);
    const double t = projector_.nearest(edge, (a + b) * 0.5).t;
    const double step = 1e-4 * (std::abs(t) + 1);
    return dot(projector_.on_edge(edge, t + step) - projector_.on_edge(edge, t - step), b - a) < 0;
}

bool share_body(const Brep& brep, Entity a, Entity b) {
    for (const FaceId of_a : brep.faces_at(a))
        for (const FaceId of_b : brep.faces_at(b))
            if (have_common_body(brep, of_a, of_b)) return true;
    return false;
}

}  // namespace featuremesh

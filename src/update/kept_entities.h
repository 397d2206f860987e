// SPDX-License-Identifier: GPL-3.0-or-later
// On which entities of the new shape old nodes, triangles and segments lie.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"
#include "mesh/mesh.h"
#include "surface/merged_entities.h"
#include "surface/projection.h"
#include "update/carried_nodes.h"
#include "update/keep.h"
#include "update/shape_coverage.h"

namespace featuremesh {

/// Nodes are placed first; triangles and segments are asked for when all of theirs are.
class KeptEntities {
  public:
    /// `nodes` may lose some between the calls; what it refers to must outlive this.
    explicit KeptEntities(const CarriedNodes& nodes);

    /// The verdict "unchanged" is not believed: a node of the old boundary is measured against the new shape. False
    /// when it does not lie on the entity that its own became.
    bool place(std::size_t node);
    /// The same of the mid-side node of a straight side, which is off the shape: where it would be on it is measured.
    bool place_straight(std::size_t node);
    /// Of a mesh on the new shape.
    KeptStraightSides straight_sides_of(const Mesh& kept) const;
    /// By old node, on the new shape where it has been placed; inner nodes have their old solid.
    std::span<const Entity> entities() const { return entities_; }
    std::span<const std::array<double, 2>> parameters() const { return parameters_; }

    /// The new solid, or none, on that side of the face where p is, as seen from a node inside the face. Nothing where
    /// the node is not inside a face of solids or p is hardly off it.
    std::optional<SolidId> solid_beside(std::size_t node, const Vec3& p) const;
    /// The piece of its face that an old triangle is on; none.
    FaceId face_of(std::size_t triangle) const;
    /// The triangle has a node inside the face.
    bool has_node_inside(std::size_t triangle, FaceId face) const;
    /// Between the triangle's normal and that of the new face.
    double cosine_to(FaceId face, std::size_t triangle) const;
    /// The piece of its edge that an old segment is on, as both its nodes are; none.
    EdgeId edge_of(std::size_t segment) const;
    /// The new edge may be parametrised the other way round.
    bool runs_backwards(std::size_t segment, EdgeId edge) const;

    const std::shared_ptr<const MergedEntities>& merged() const { return merged_; }

  private:
    /// Where an old node would be in the new state.
    struct Place {
        std::int32_t motion;
        Entity entity;
        std::array<double, 2> parameter;
    };

    bool place_at(std::size_t node, const Vec3& p);
    /// `old_index`: of the old vertex, edge or face, whose dimension `place` has.
    bool find_place(Place& place, std::size_t old_index, const Vec3& p);
    bool place_on_vertex(Place& place, VertexId vertex, const Vec3& p) const;
    bool place_on_edges(Place& place, const std::vector<EdgeId>& pieces, const Vec3& p);
    bool place_on_edge(Place& place, EdgeId piece, const Vec3& p);
    bool place_on_faces(Place& place, std::size_t old_face, const Vec3& p);
    bool place_on_face(Place& place, FaceId face, const Vec3& p, bool is_untouched) const;
    bool is_untouched(const Place& place, std::size_t old_face, const Vec3& p) const;
    bool is_far_from_changes(const Place& place, const Vec3& p) const;
    bool may_hold(FaceId face, const Vec3& p) const;
    bool is_at(EdgeId edge, NodeId node) const;
    double tolerance() const { return 5 * in_.new_brep.tolerances().on_entity(); }

    const CarriedNodes nodes_;
    const KeepInput& in_;
    Projector projector_;
    std::optional<Projector> old_projector_;  // where there are straight sides
    std::shared_ptr<const MergedEntities> merged_;
    std::vector<Entity> entities_;  // by old node, likewise:
    std::vector<std::array<double, 2>> parameters_;
    std::vector<char> is_untouched_;      // by old face: kept in place with all its edges
    std::vector<EdgeRange> edge_ranges_;  // by new edge, empty until asked for
};

/// Whether the two, of at most dimension 2, are of one solid or sheet.
bool share_body(const Brep& brep, Entity a, Entity b);

}  // namespace featuremesh

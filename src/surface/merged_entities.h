// SPDX-License-Identifier: GPL-3.0-or-later
// CAD vertices, edges and faces that are too near one another for any mesh to tell them apart.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "core/message.h"
#include "surface/projection.h"

namespace featuremesh {

/// Vertices of one solid in the same place within Tolerances::negligible(), or as far as details are ignored, share a
/// node, and an edge goes through the nodes of the vertices that lie on it. Then an edge may be a point, an edge may
/// have its chain in common with another or a part of it (a solid that touches itself along an edge; the long edges of
/// a sliver), and a face whose edges are so in pairs has no triangles. Nor has one that closes round such a place (a
/// bore or a pin that thin), nor have two of one solid that lie on one another (blocks that were not fused where they
/// touch) or have only a slit as narrow between them; and their edges have no chain where no other face has them.
struct MergedEntities {
    /// `ignore_below`: mm, details smaller than this are ignored; nodes are off the shape there by no more than it.
    explicit MergedEntities(const Brep& brep, double ignore_below = 0);

    std::vector<VertexId> vertex_of;  ///< by vertex: the one that has the node, mostly itself
    std::vector<EdgeId> edge_of;      ///< by edge: the one that has the chain, or a longer one, mostly itself
    /// By edge that has a chain, and by stretch of it between vertices: another edge that has the nodes there, as the
    /// two run along one another for that stretch alone; mostly none. Empty where an edge has none such.
    std::vector<std::vector<EdgeId>> lender_of;
    /// By edge: vertices of other edges on it, as vertex_of gives them, by growing edge parameter.
    std::vector<std::vector<std::pair<double, VertexId>>> vertices_on;
    std::vector<char> is_point;  ///< by edge: it has no chain
    std::vector<char> is_flat;   ///< by face: it has no triangles

    /// The vertices along an edge that is not closed, its ends first and last, as vertex_of gives them.
    std::vector<VertexId> sequence_of(const Brep& brep, EdgeId edge) const;
    /// The edge that has the nodes at this parameter of one that has a chain: a lender, or itself.
    EdgeId owner_at(EdgeId edge, double t) const;
    bool is_same_as(const MergedEntities& other) const;
    /// What the user should know of it.
    std::vector<Message> warnings() const;

  private:
    /// By the edge that has the chain and the number of a stretch of it between vertices: how often a border has it.
    using Stretches = std::map<std::pair<EdgeId, std::ptrdiff_t>, int>;
    void join_edges(const Brep& brep, const Projector& projector);
    /// Where between its ends two of the vertices along the edge are.
    std::array<double, 2> shares_between(const Brep& brep, EdgeId edge, const std::array<VertexId, 2>& ends) const;
    /// How far from one another the edges may run in one place: where all that is between them is a face without any
    /// width, as far as the kernel says that they may be off.
    double reach_between(const Brep& brep, EdgeId edge, EdgeId other) const;
    /// Where it runs along one of `others`, which have all of these between them, for the stretch from `first` on.
    void borrow_stretch(const Brep& brep, const Projector& projector, EdgeId edge, std::size_t first,
                        const std::vector<EdgeId>& others);
    void close_holes(const Brep& brep, const Projector& projector);
    Stretches border_of(const Brep& brep, FaceId face) const;
    /// Of an edge that has a chain, between two of its vertices.
    void add_stretches(const Brep& brep, EdgeId edge, const std::array<VertexId, 2>& ends, Stretches& uses) const;
    void find_flat_faces(const Brep& brep);
    void join_faces(const Brep& brep, const Projector& projector);
    /// Whether the face's border has the edge, no longer than twice what is ignored, there and back again.
    bool is_short_spike(const Brep& brep, FaceId face, EdgeId edge) const;
    void leave_out_bare_edges(const Brep& brep);
    /// A vertex at which no edge has a chain and a short one ends gives its node to the other end.
    void merge_bare_vertices(const Brep& brep);

    std::vector<char> is_joined_;  ///< by face: it has no triangles since another lies on it
    double tolerance_;             ///< mm
    bool is_wide_;                 ///< wider than what is negligible
};

}  // namespace featuremesh

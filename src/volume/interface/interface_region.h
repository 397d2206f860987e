// SPDX-License-Identifier: GPL-3.0-or-later
// Bad tets at an interface can often be mended only together with kept tets beyond it.
#pragma once

#include <span>
#include <vector>

#include "core/ids.h"
#include "mesh/mesh.h"
#include "volume/cavity.h"
#include "volume/improvement/local_mesh.h"
#include "volume/improvement/objective.h"
#include "volume/tets/tet_complex.h"

namespace featuremesh {

/// The tets that fill a cavity, for local operations, and kept tets that were taken in from around it. Their nodes stay
/// fixed, so what changes is connectivity; what does not change is given back.
class InterfaceRegion {
  public:
    InterfaceRegion() = default;
    InterfaceRegion(const Cavity& cavity, TetComplex filled);

    TetComplex complex;

    /// Kept tets were around the cavity.
    bool has_interface() const;
    /// Some of the vertex's tets are kept, or were.
    bool is_at_interface(int vertex) const {
        return vertex < static_cast<int>(is_at_interface_.size()) &&
               is_at_interface_[static_cast<std::size_t>(vertex)] != 0;
    }
    /// Tets that touch the interface and miss the target.
    std::vector<int> bad_tets_at_interface(const Objective& objective) const;
    /// Tets whose corners have so few edges between them and the interface, one at least; ascending.
    std::vector<int> tets_near_interface(int edges) const;
    /// The tets, those that share a vertex with them, and so on, `rings` times; ascending.
    std::vector<int> with_rings(std::vector<int> tets, int rings) const;
    /// The mesh's nodes of these tets, as far as they have any.
    std::vector<NodeId> nodes_of(std::span<const int> tets) const;

    /// Adds kept tets of the mesh, none of which was taken in before. Gives their numbers in the complex.
    std::vector<int> take_in(const Mesh& mesh, std::span<const TetId> tets);
    std::size_t taken_count() const { return taken_.size(); }
    /// Of those taken in: how many are not as they were.
    std::size_t changed_count(const Mesh& mesh) const;
    /// Kept nodes inside the solid that have all their tets in the complex may be moved from now on.
    void free_inner_nodes(const Mesh& mesh);
    /// The kept nodes that have been moved, with their vertices.
    std::vector<std::pair<NodeId, int>> moved_nodes(const Mesh& mesh) const;
    /// Kept tets that are still as they were leave the complex, whose neighbours are of no use from then on. Gives
    /// them.
    std::vector<TetId> give_back(const Mesh& mesh);

    /// The mesh's node of a vertex; none for one that is new.
    NodeId node_of(int vertex) const {
        return vertex < static_cast<int>(nodes_.size()) ? nodes_[static_cast<std::size_t>(vertex)] : NodeId();
    }

  private:
    struct Taken {
        TetId tet;
        int place;
        std::array<int, 4> corners;
    };
    int add_vertex(NodeId node, const Mesh& mesh);
    bool is_moved(int vertex, const Mesh& mesh) const;
    bool is_changed(const Taken& taken, const Mesh& mesh) const;
    void link_open_facets();

    std::vector<NodeId> nodes_;                  // by vertex
    std::vector<std::uint8_t> is_at_interface_;  // by vertex
    std::vector<Taken> taken_;
};

/// The region's nodes that are on one face, or between two, with one solid beside them, and away from kept tets; of the
/// first `kept_nodes` of the mesh only where these may move.
std::vector<SurfaceVertex> movable_vertices(const Brep& brep, const Mesh& mesh, const InterfaceRegion& region,
                                            std::size_t kept_nodes, bool moves_kept_nodes);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// The CAD edges as chains of nodes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "surface/chain_neighbours.h"
#include "surface/merged_entities.h"
#include "surface/opposite_nodes.h"
#include "surface/projection.h"
#include "surface/wanted_length.h"

namespace featuremesh {

/// 64 well mixed bits of a pair of nodes, in either order. Sums of such keys cancel by chance as rarely as memory errs.
inline std::uint64_t node_pair_key(NodeId a, NodeId b) {
    const auto [low, high] = std::minmax(a.value, b.value);
    std::uint64_t x =
        (static_cast<std::uint64_t>(high) << 32 | static_cast<std::uint32_t>(low)) + 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

/// The nodes of one CAD edge by growing edge parameter, vertices included. Empty for an edge that no solid's face uses
/// and for a pole, and for an edge that is a point. Edges that are one chain, or a part of one, have the same nodes.
struct EdgeChain {
    std::vector<NodeId> nodes;
    std::vector<double> t;
    std::vector<char> is_kept;  ///< per piece: whether the mesh, or another edge, has this segment already

    std::size_t piece_count() const { return is_kept.size(); }
};

/// A node per CAD vertex and a chain per CAD edge, each the same for all faces that use it.
class EdgeChains {
  public:
    /// Keeps the mesh's nodes and segments on edges and fills the gaps by the sizing field along the arc length, no
    /// finer than twice the edge's tolerance: equal shares, at least one piece, a curve at least one per quarter turn,
    /// two edges between the same two vertices never the same chain. Where edges of one solid touch between their
    /// vertices, nodes keep off the place. Edges `beside` one another get nodes opposite one another as far as they run
    /// so. New nodes are appended to `mesh`.
    EdgeChains(const Brep& brep, const MergedEntities& merged, const WantedLength& sizing, const EdgesBeside& beside,
               Mesh& mesh, RunContext& context);

    const EdgeChain& operator[](EdgeId edge) const { return chains_[edge.index()]; }
    NodeId node_of(VertexId vertex) const { return vertex_nodes_[vertex.index()]; }

    /// A piece of an edge that shares its chain, as a piece of the edge that has the chain.
    struct Piece {
        EdgeId edge;
        std::size_t index;
        auto operator<=>(const Piece&) const = default;
    };
    Piece owner_of(const Piece& piece) const;
    bool is_point(EdgeId edge) const { return merged_.is_point[edge.index()] != 0; }
    /// The edges with pieces of a chain, of which this one has it.
    std::vector<EdgeId> sharers_of(EdgeId edge) const;

    /// Halves a piece, unless it is kept or too short to be halved; says whether it did. Edges that share the chain
    /// follow with update_sharers.
    bool halve(const Brep& brep, EdgeId edge, std::size_t piece, Mesh& mesh);
    void update_sharers(const Brep& brep, EdgeId edge, const Mesh& mesh);
    /// Appends the segments that the mesh does not have yet.
    void add_segments(Mesh& mesh) const;

  private:
    /// The parameters of new nodes between two of an edge that runs beside others; `stops`: what stays on those.
    std::vector<double> parameters_beside(const Brep& brep, const WantedLength& sizing, EdgeId edge,
                                          const std::array<double, 2>& between, const std::vector<EdgeId>& others,
                                          std::span<const Vec3> stops, const Mesh& mesh) const;
    /// Divides runs of new nodes into more pieces where one of them lies on another edge.
    void keep_off_contacts(const Brep& brep, const WantedLength& sizing, std::size_t first_new_node, Mesh& mesh,
                           const RunContext& context);
    /// The same for the nodes from the first to before the second of `run`; where it ends now.
    std::size_t keep_off_contacts(const Brep& brep, const WantedLength& sizing, const ChainNeighbours& neighbours,
                                  EdgeId edge, const std::array<std::size_t, 2>& run, Mesh& mesh);
    /// The owner's nodes between the ends, with their places on this edge.
    void follow_owner(const Brep& brep, EdgeId edge, const Mesh& mesh);
    /// The lenders' nodes where others have them.
    void borrow_stretches(const Brep& brep, EdgeId edge, const Mesh& mesh);
    /// The nodes that the chain of one edge has from one to another, with their places on this edge.
    EdgeChain stretch_of(EdgeId owner, const std::array<NodeId, 2>& ends, EdgeId edge,
                         const std::array<double, 2>& range, const Mesh& mesh) const;

    const MergedEntities& merged_;
    Projector projector_;
    std::vector<EdgeChain> chains_;
    std::vector<NodeId> vertex_nodes_;
};

}  // namespace featuremesh

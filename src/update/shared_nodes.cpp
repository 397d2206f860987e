// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/shared_nodes.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "core/sort_once.h"
#include "surface/projection.h"

namespace featuremesh {

namespace {

class MergedNodes {
  public:
    MergedNodes(const Mesh& mesh, const Brep& brep, const MergedEntities& merged, double ignored_below)
        : mesh_(mesh),
          brep_(brep),
          merged_(merged),
          projector_(brep),
          reach_(2 * std::max(ignored_below, brep.tolerances().negligible())) {}

    std::vector<SharedNode> found() {
        const std::vector<Entity> entities = merged_entities();
        if (entities.empty()) return {};
        at_vertex_.resize(brep_.vertex_count());
        on_edge_.resize(brep_.edge_count());
        for (std::size_t n = 0; n < mesh_.node_count(); ++n) {
            const Entity e = mesh_.entities[n];
            if (e.dim == 0) at_vertex_[std::size_t(e.index)] = NodeId(n);
            if (e.dim == 1) on_edge_[std::size_t(e.index)].emplace_back(n);
        }
        std::vector<SharedNode> shared;
        for (const Entity entity : entities) {
            std::vector<NodeId> nodes;
            add_nodes(entity, nodes);
            sort_once(nodes);
            for (const NodeId n : nodes) shared.push_back({entity, n});
        }
        return shared;
    }

  private:
    bool borrows(EdgeId edge) const {
        const auto& lenders = merged_.lender_of[edge.index()];
        return merged_.is_point[edge.index()] || merged_.edge_of[edge.index()] != edge ||
               std::any_of(lenders.begin(), lenders.end(), [](EdgeId e) { return e.is_valid(); });
    }

    std::vector<Entity> merged_entities() const {
        std::vector<Entity> entities;
        for (std::size_t v = 0; v < brep_.vertex_count(); ++v)
            if (merged_.vertex_of[v] != VertexId(v)) entities.push_back(entity_of(VertexId(v)));
        for (std::size_t e = 0; e < brep_.edge_count(); ++e)
            if (!brep_.is_degenerated(EdgeId(e)) && borrows(EdgeId(e))) entities.push_back(entity_of(EdgeId(e)));
        for (std::size_t f = 0; f < brep_.face_count(); ++f)
            if (merged_.is_flat[f]) entities.push_back(entity_of(FaceId(f)));
        return entities;
    }

    void add_nodes(Entity entity, std::vector<NodeId>& nodes) const {
        if (entity.dim == 0) add_node_of(VertexId(std::size_t(entity.index)), nodes);
        if (entity.dim == 1) add_nodes_of(EdgeId(std::size_t(entity.index)), nodes);
        if (entity.dim == 2)
            for (const EdgeId e : brep_.edges_of(FaceId(std::size_t(entity.index)))) add_nodes_of(e, nodes);
    }

    void add_node_of(VertexId vertex, std::vector<NodeId>& nodes) const {
        if (!vertex.is_valid()) return;
        const NodeId n = at_vertex_[merged_.vertex_of[vertex.index()].index()];
        if (n.is_valid()) nodes.push_back(n);
    }

    void add_nodes_of(EdgeId edge, std::vector<NodeId>& nodes) const {
        for (const VertexId end : brep_.ends_of(edge)) add_node_of(end, nodes);
        for (const auto& [t, vertex] : merged_.vertices_on[edge.index()]) add_node_of(vertex, nodes);
        if (!merged_.is_point[edge.index()]) add_chain_along(edge, merged_.edge_of[edge.index()], nodes);
    }

    /// The nodes of the edge `owner`, and of those that lend it some, that lie along `edge`.
    void add_chain_along(EdgeId edge, EdgeId owner, std::vector<NodeId>& nodes) const {
        for (const NodeId n : on_edge_[owner.index()]) add_if_along(edge, n, nodes);
        std::vector<NodeId> between;
        for (const auto& [t, vertex] : merged_.vertices_on[owner.index()]) add_node_of(vertex, between);
        for (const NodeId n : between) add_if_along(edge, n, nodes);
        for (const EdgeId lender : merged_.lender_of[owner.index()])
            if (lender.is_valid()) add_chain_along(edge, lender, nodes);
    }

    void add_if_along(EdgeId edge, NodeId n, std::vector<NodeId>& nodes) const {
        if (projector_.nearest(edge, mesh_.point(n)).distance <= reach_) nodes.push_back(n);
    }

    const Mesh& mesh_;
    const Brep& brep_;
    const MergedEntities& merged_;
    const Projector projector_;
    const double reach_;                        ///< mm
    std::vector<NodeId> at_vertex_;             ///< by vertex
    std::vector<std::vector<NodeId>> on_edge_;  ///< by edge, without its ends
};

}  // namespace

std::vector<SharedNode> shared_nodes(const Mesh& mesh, const Brep& brep, const MergedEntities& merged,
                                     double ignored_below) {
    return MergedNodes(mesh, brep, merged, ignored_below).found();
}

}  // namespace featuremesh

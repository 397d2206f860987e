// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/short_edges.h"

#include <set>

#include "core/messages.h"
#include "core/numbers_in_words.h"

namespace featuremesh {

std::vector<Message> short_edges_among(const Brep& brep, const Mesh& mesh, std::span<const NodeId> nodes,
                                       std::span<const std::array<int, 4>> tets) {
    std::set<std::pair<double, EdgeId>> edges;
    for (const auto& tet : tets) {
        std::set<VertexId> corners;
        for (const int corner : tet)
            if (static_cast<std::size_t>(corner) < nodes.size())
                if (const Entity e = mesh.entities[nodes[static_cast<std::size_t>(corner)].index()]; e.dim == 0)
                    corners.emplace(e.index);
        for (const VertexId v : corners)
            for (const EdgeId e : brep.edges_of(v)) {
                const auto [first, last] = brep.ends_of(e);
                if (first == last || !corners.count(first) || !corners.count(last)) continue;
                const double length = distance(brep.point_of(first), brep.point_of(last));
                if (length < brep.tolerances().least_length()) edges.emplace(length, e);
            }
    }
    constexpr std::size_t most = 3;
    std::vector<Message> shortest;
    for (const auto& [length, edge] : edges) {
        if (shortest.size() == most) break;
        shortest.push_back(say<Code::edge_of_length>(edge, Length{rounded(length, 2)}));
    }
    return shortest;
}

}  // namespace featuremesh

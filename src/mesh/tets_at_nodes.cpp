// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tets_at_nodes.h"

namespace featuremesh {

std::vector<TetId> tets_at_nodes(const Mesh& mesh, std::span<const char> is_marked) {
    std::vector<TetId> tets;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        const auto& [a, b, c, d] = mesh.tets[t];
        if (is_marked[a.index()] | is_marked[b.index()] | is_marked[c.index()] | is_marked[d.index()])
            tets.emplace_back(t);
    }
    return tets;
}

}  // namespace featuremesh

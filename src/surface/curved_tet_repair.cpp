// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/curved_tet_repair.h"

#include <algorithm>

#include "mesh/second_order.h"

namespace featuremesh {
namespace {

constexpr std::size_t grain = 1 << 13;

/// Cheap where all coefficients are large enough; the subdivision decides the rest.
bool is_at_most(const Mesh& mesh, TetId tet, double limit) {
    if (!has_curved_side(mesh, tet)) return false;
    const auto nodes = tet_nodes(mesh, tet);
    const double straight = 6 * signed_volume(nodes[0], nodes[1], nodes[2], nodes[3]);
    const auto coefficients = jacobian_coefficients(nodes);
    if (*std::min_element(coefficients.begin(), coefficients.end()) > limit * straight) return false;
    return min_scaled_jacobian(nodes) <= limit;
}

}  // namespace

std::vector<TetId> tets_at_most(const Mesh& mesh, double limit, RunContext& context) {
    std::vector<std::vector<TetId>> parts((mesh.tets.size() + grain - 1) / grain);
    parallel_for(context, mesh.tets.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t)
            if (is_at_most(mesh, TetId(t), limit)) parts[begin / grain].push_back(TetId(t));
    });
    std::vector<TetId> found;
    for (const auto& part : parts) found.insert(found.end(), part.begin(), part.end());
    return found;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/short_sides.h"

#include <algorithm>
#include <limits>

namespace featuremesh {

ShortSides::ShortSides(const Mesh& mesh) : mesh_(mesh), segment_at_(mesh.corner_count) {
    for (std::size_t s = 0; s < mesh.segments.size(); ++s)
        segment_at_.value(mesh.segments[s][0], mesh.segments[s][1]) = static_cast<std::int32_t>(s);
}

std::optional<std::array<NodeId, 2>> ShortSides::forced_side(TetId tet) const {
    const auto& nodes = mesh_.tets[tet.index()];
    double least = std::numeric_limits<double>::max(), most = 0;
    std::array<NodeId, 2> shortest;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < i; ++j) {
            const double squared = squared_length(mesh_.point(nodes[i]) - mesh_.point(nodes[j]));
            most = std::max(most, squared);
            if (squared < least) least = squared, shortest = {nodes[j], nodes[i]};
        }
    if (least >= share * share * most || !is_forced(shortest[0], shortest[1])) return {};
    return shortest;
}

bool ShortSides::is_forced(NodeId a, NodeId b) const {
    const Entity at_a = mesh_.entities[a.index()], at_b = mesh_.entities[b.index()];
    if (at_a.dim > 1 || at_b.dim > 1) return false;
    if (segment_at(a, b) >= 0) return at_a.dim == 0 && at_b.dim == 0;
    return at_a != at_b;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/made_for.h"

#include <algorithm>

namespace featuremesh {

std::optional<double> MadeFor::of(NodeId node) const {
    const auto at = std::lower_bound(nodes.begin(), nodes.end(), node);
    if (at == nodes.end() || *at != node) return {};
    return sizes[std::size_t(at - nodes.begin())];
}

MadeFor without(MadeFor made_for, std::vector<NodeId> nodes) {
    if (nodes.empty()) return made_for;
    std::sort(nodes.begin(), nodes.end());
    MadeFor left;
    for (std::size_t i = 0; i < made_for.nodes.size(); ++i) {
        if (std::binary_search(nodes.begin(), nodes.end(), made_for.nodes[i])) continue;
        left.nodes.push_back(made_for.nodes[i]);
        left.sizes.push_back(made_for.sizes[i]);
    }
    return left;
}

}  // namespace featuremesh

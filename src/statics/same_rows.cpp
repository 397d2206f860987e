// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/same_rows.h"

#include <algorithm>

#include "core/ids.h"
#include "statics/earlier_nodes.h"

namespace featuremesh {

namespace {

/// By node the one of that number at the same place, held alike; -1 where there is none.
std::vector<std::int32_t> same_nodes(const StaticsModel& model, const StaticsModel& earlier) {
    std::vector<std::int32_t> origin = earlier_nodes(model.mesh.node_numbers, earlier.mesh.node_numbers);
    leave_alike_held(origin, model.is_held, earlier.is_held);
    for (std::size_t node = 0; node < origin.size(); ++node)
        if (origin[node] >= 0 && model.mesh.points[node] != earlier.mesh.points[std::size_t(origin[node])])
            origin[node] = -1;
    return origin;
}

}  // namespace

SameRows same_rows(const StaticsModel& model, const TetsOfNodes& around, const StaticsModel& earlier,
                   const TetsOfNodes& around_earlier, RunContext& context) {
    SameRows same{std::vector<std::int32_t>(model.mesh.node_count(), -1),
                  std::vector<std::int32_t>(earlier.mesh.node_count(), -1)};
    if (model.mesh.order != earlier.mesh.order || model.materials != earlier.materials) return same;
    const std::vector<std::int32_t> origin = same_nodes(model, earlier);
    for (std::size_t node = 0; node < origin.size(); ++node)
        if (origin[node] >= 0) same.node_now[std::size_t(origin[node])] = std::int32_t(node);
    const auto are_same = [&](const auto& nodes, const auto& before) {
        return std::equal(nodes.begin(), nodes.end(), before.begin(),
                          [&](NodeId now, NodeId then) { return origin[now.index()] == then.value; });
    };
    const auto is_same = [&](std::size_t tet, std::size_t before) {
        return model.tet_materials[tet] == earlier.tet_materials[before] &&
               are_same(model.mesh.tets[tet], earlier.mesh.tets[before]) &&
               (model.mesh.order == 1 || are_same(model.mesh.tet_mids[tet], earlier.mesh.tet_mids[before]));
    };
    const auto has_same_row = [&](std::size_t node) {
        const auto before = std::size_t(origin[node]);
        const auto first = around.tets.begin() + around.starts[node];
        const auto last = around.tets.begin() + around.starts[node + 1];
        return std::equal(
            first, last, around_earlier.tets.begin() + around_earlier.starts[before],
            around_earlier.tets.begin() + around_earlier.starts[before + 1],
            [&](std::int32_t now, std::int32_t then) { return is_same(std::size_t(now), std::size_t(then)); });
    };
    parallel_for(context, origin.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node)
            if (origin[node] >= 0 && has_same_row(node)) same.row[node] = origin[node];
    });
    return same;
}

}  // namespace featuremesh

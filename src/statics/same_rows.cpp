// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/same_rows.h"

#include <algorithm>
#include <numeric>

#include "core/ids.h"

namespace featuremesh {

AssembledModel::AssembledModel(const StaticsModel& model, const TetsOfNodes& around)
    : materials_(model.materials),
      tet_materials_(model.tet_materials),
      is_held_(model.is_held),
      around_(around),
      by_number_(model.mesh.node_count()) {
    mesh_.order = model.mesh.order;
    mesh_.points = model.mesh.points, mesh_.node_numbers = model.mesh.node_numbers;
    mesh_.tets = model.mesh.tets, mesh_.tet_mids = model.mesh.tet_mids;
    std::iota(by_number_.begin(), by_number_.end(), 0);
    const auto number = [&](std::int32_t node) { return mesh_.node_numbers[std::size_t(node)]; };
    const auto is_before = [&](std::int32_t a, std::int32_t b) { return number(a) < number(b); };
    if (!std::is_sorted(by_number_.begin(), by_number_.end(), is_before))
        std::sort(by_number_.begin(), by_number_.end(), is_before);
}

/// By node the one of that number at the same place, held alike; -1 where there is none.
std::vector<std::int32_t> AssembledModel::same_nodes(const StaticsModel& model) const {
    const Mesh& mesh = model.mesh;
    std::vector<std::int32_t> origin(mesh.node_count(), -1);
    const auto is_below = [&](std::int32_t node, Number number) {
        return mesh_.node_numbers[std::size_t(node)] < number;
    };
    for (std::size_t node = 0; node < origin.size(); ++node) {
        const Number number = mesh.node_numbers[node];
        const auto at = std::lower_bound(by_number_.begin(), by_number_.end(), number, is_below);
        if (at == by_number_.end()) continue;
        const auto found = std::size_t(*at);
        const bool is_held_alike = std::equal(model.is_held.begin() + std::ptrdiff_t(3 * node),
                                              model.is_held.begin() + std::ptrdiff_t(3 * node + 3),
                                              is_held_.begin() + std::ptrdiff_t(3 * found));
        if (mesh_.node_numbers[found] == number && mesh_.points[found] == mesh.points[node] && is_held_alike)
            origin[node] = *at;
    }
    return origin;
}

bool AssembledModel::is_same(const StaticsModel& model, std::size_t tet, std::size_t earlier,
                             const std::vector<std::int32_t>& origin) const {
    const auto is_same_node = [&](NodeId node, NodeId before) { return origin[node.index()] == before.value; };
    const auto are_same = [&](const auto& nodes, const auto& before) {
        return std::equal(nodes.begin(), nodes.end(), before.begin(), is_same_node);
    };
    return model.tet_materials[tet] == tet_materials_[earlier] && are_same(model.mesh.tets[tet], mesh_.tets[earlier]) &&
           (mesh_.order == 1 || are_same(model.mesh.tet_mids[tet], mesh_.tet_mids[earlier]));
}

SameRows AssembledModel::rows_for(const StaticsModel& model, const TetsOfNodes& around, RunContext& context) const {
    SameRows same{std::vector<std::int32_t>(model.mesh.node_count(), -1),
                  std::vector<std::int32_t>(mesh_.node_count(), -1)};
    if (mesh_.order != model.mesh.order || materials_ != model.materials) return same;
    const std::vector<std::int32_t> origin = same_nodes(model);
    for (std::size_t node = 0; node < origin.size(); ++node)
        if (origin[node] >= 0) same.node_now[std::size_t(origin[node])] = std::int32_t(node);
    const auto has_same_row = [&](std::size_t node) {
        const auto before = std::size_t(origin[node]);
        const auto first = around.starts[node], first_before = around_.starts[before];
        if (around.starts[node + 1] - first != around_.starts[before + 1] - first_before) return false;
        for (auto t = first; t < around.starts[node + 1]; ++t)
            if (!is_same(model, std::size_t(around.tets[std::size_t(t)]),
                         std::size_t(around_.tets[std::size_t(t - first + first_before)]), origin))
                return false;
        return true;
    };
    parallel_for(context, origin.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node)
            if (origin[node] >= 0 && has_same_row(node)) same.row[node] = origin[node];
    });
    return same;
}

}  // namespace featuremesh

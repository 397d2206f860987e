// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/mesh_origin.h"

#include <algorithm>
#include <utility>

#include "core/ids.h"

namespace featuremesh {

namespace {

std::vector<std::int32_t> extended(std::vector<std::int32_t> origins, std::size_t count) {
    origins.resize(count, -1);
    return origins;
}

std::vector<std::int32_t> without(const std::vector<std::int32_t>& origins, const std::vector<TetId>& released) {
    std::vector<char> gone(origins.size(), 0);
    for (const TetId t : released) gone[t.index()] = 1;
    std::vector<std::int32_t> left;
    for (std::size_t t = 0; t < origins.size(); ++t)
        if (!gone[t]) left.push_back(origins[t]);
    return left;
}

/// Kept corner nodes stay in front; kept mid-side nodes are found by their numbers, which are never given twice.
std::vector<std::int32_t> node_origins(const Mesh& old, const Filled& filled, const std::vector<std::int32_t>& corners,
                                       const RunContext& context) {
    const Mesh& mesh = filled.mesh;
    std::vector<std::int32_t> origins = extended(corners, mesh.node_count());
    for (const NodeId n : filled.moved) origins[n.index()] = -1;
    if (old.order == 1 || mesh.order == 1) return origins;
    std::vector<std::pair<Number, std::int32_t>> of_number;
    for (std::size_t n = old.corner_count; n < old.node_count(); ++n)
        of_number.emplace_back(old.node_numbers[n], std::int32_t(n));
    if (!std::is_sorted(of_number.begin(), of_number.end())) std::sort(of_number.begin(), of_number.end());
    RoundWatch watch(context);
    auto it = of_number.begin();
    for (std::size_t n = mesh.corner_count; n < mesh.node_count(); ++n) {
        watch();
        const Number number = mesh.node_numbers[n];
        if (it == of_number.end() || it->first != number)  // kept ones are in their old order, as a rule
            it = std::lower_bound(of_number.begin(), of_number.end(), std::pair<Number, std::int32_t>{number, 0});
        if (it != of_number.end() && it->first == number) origins[n] = it++->second;
    }
    return origins;
}

std::vector<std::int32_t> through(const std::vector<std::int32_t>& earlier, const std::vector<std::int32_t>& later) {
    std::vector<std::int32_t> origins;
    origins.reserve(later.size());
    for (const std::int32_t was : later) origins.push_back(was < 0 ? was : earlier[std::size_t(was)]);
    return origins;
}

}  // namespace

MeshOrigin origin_of(const Filled& filled, MeshOrigin kept, const Mesh& before, std::size_t element_count,
                     const RunContext& context) {
    return {node_origins(before, filled, kept.nodes, context),
            extended(without(kept.elements, filled.released), element_count),
            without(std::move(kept.made_for), filled.moved)};
}

MeshOrigin through(const MeshOrigin& earlier, const MeshOrigin& later) {
    MeshOrigin origin{through(earlier.nodes, later.nodes), through(earlier.elements, later.elements), {}};
    for (std::size_t n = 0; n < later.nodes.size(); ++n) {
        if (later.nodes[n] < 0) continue;
        const std::optional<double> size = earlier.made_for.of(NodeId(later.nodes[n]));
        if (!size) continue;
        origin.made_for.nodes.emplace_back(n);
        origin.made_for.sizes.push_back(*size);
    }
    return origin;
}

}  // namespace featuremesh

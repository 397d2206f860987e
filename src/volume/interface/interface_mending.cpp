// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/interface/interface_mending.h"

#include <algorithm>

#include "mesh/quality.h"
#include "volume/improvement/improve.h"
#include "volume/improvement/local_mesh.h"
#include "volume/improvement/operations.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

/// Kept tets so far from bad ones at the interface, counted in tets, are taken in at most.
constexpr int most_rings = 3;
/// In each of the steps. Where many tets at an interface cannot be helped, refilling round all of them would cost more
/// than the cavity itself, and the mean quality.
constexpr std::size_t most_dear_plans = 300;

/// Kept nodes with new tets whose mean radius ratio is less are tried elsewhere: in a mesh from scratch it is 0.85 to
/// 0.93.
constexpr double poor_ratio = 0.85;
constexpr int sweeps_of_kept = 6;

/// The kept tets with a node of those given for each region, of all or of the `candidates` where there are any; one
/// that has nodes of two goes to the first.
std::vector<std::vector<TetId>> kept_tets_with(const std::vector<std::vector<NodeId>>& nodes, const Mesh& mesh,
                                               std::span<const TetId> candidates,
                                               std::span<const std::uint8_t> is_released, const RunContext& context) {
    std::vector<std::vector<TetId>> with(nodes.size());
    if (std::all_of(nodes.begin(), nodes.end(), [](const auto& list) { return list.empty(); })) return with;
    std::vector<int> region_of(mesh.node_count(), -1);
    for (std::size_t i = nodes.size(); i-- > 0;)
        for (const NodeId n : nodes[i]) region_of[n.index()] = static_cast<int>(i);
    RoundWatch watch(context);
    const auto look_at = [&](TetId tet) {
        watch();
        int first = -1;
        for (const NodeId n : mesh.tets[tet.index()])
            if (const int i = region_of[n.index()]; i >= 0 && (first < 0 || i < first)) first = i;
        if (first >= 0 && !is_released[tet.index()]) with[static_cast<std::size_t>(first)].push_back(tet);
    };
    for (const TetId tet : candidates) look_at(tet);
    for (std::size_t t = 0; candidates.empty() && t < mesh.tets.size(); ++t) look_at(TetId(t));
    return with;
}

/// Kept vertices inside the solid whose new tets have a poor mean radius ratio.
std::vector<int> poor_vertices(const InterfaceRegion& region, const Mesh& mesh) {
    const TetComplex& complex = region.complex;
    std::vector<double> sums(complex.points.size(), 0);
    std::vector<int> counts(complex.points.size(), 0);
    for (const Tet& tet : complex.tets) {
        if (tet[0] < 0 || std::none_of(tet.begin(), tet.end(), [&](int v) { return region.is_at_interface(v); }))
            continue;
        const auto& p = complex.points;
        const double ratio = radius_ratio(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]);
        for (const int v : tet) sums[v] += ratio, ++counts[v];
    }
    std::vector<int> poor;
    for (int v = 0; v < static_cast<int>(sums.size()); ++v) {
        const NodeId node = region.node_of(v);
        if (region.is_at_interface(v) && node.is_valid() && mesh.entities[node.index()].dim == 3 &&
            sums[v] < poor_ratio * counts[v])
            poor.push_back(v);
    }
    return poor;
}

bool has_needle(const TetComplex& complex, const Objective& objective) {
    return std::any_of(complex.tets.begin(), complex.tets.end(),
                       [&](const Tet& tet) { return tet[0] >= 0 && objective.is_excused(complex, tet); });
}

/// Moves the kept vertices, and free ones beside them, for the shapes of their tets.
void relax(InterfaceRegion& region, const Mesh& mesh, std::span<const int> vertices, std::span<const TetId> around,
           const Objective& objective, RunContext& context) {
    region.take_in(mesh, around);
    TetComplex& complex = region.complex;
    Region tets;
    std::vector<int> star;
    for (const int v : vertices) {
        if (!gather_star(complex, v, star)) continue;
        complex.mobility[v] = Mobility::kept;
        tets.insert(tets.end(), star.begin(), star.end());
    }
    if (tets.empty()) return;
    LocalMesh local(complex);
    improve(local, objective, list_of(vertex_move(local, objective)), std::move(tets), {.passes = sweeps_of_kept},
            context);
}

}  // namespace

void mend_interfaces(std::span<InterfaceRegion> regions, const Mesh& mesh, std::span<std::uint8_t> is_released,
                     const Objective& objective, RunContext& context) {
    for (int rings = 0; rings < most_rings; ++rings) {
        std::vector<Region> bad;
        for (const InterfaceRegion& region : regions)
            bad.push_back(region.with_rings(region.bad_tets_at_interface(objective), rings));
        if (std::all_of(bad.begin(), bad.end(), [](const auto& tets) { return tets.empty(); })) return;
        std::vector<std::vector<NodeId>> nodes;
        for (std::size_t i = 0; i < regions.size(); ++i) nodes.push_back(regions[i].nodes_of(bad[i]));
        const std::vector<std::vector<TetId>> around = kept_tets_with(nodes, mesh, {}, is_released, context);
        for (std::size_t i = 0; i < regions.size(); ++i) {
            if (around[i].empty()) continue;
            for (const TetId tet : around[i]) is_released[tet.index()] = 1;
            const std::vector<int> taken = regions[i].take_in(mesh, around[i]);
            if (rings > 0) regions[i].free_inner_nodes(mesh);
            bad[i].insert(bad[i].end(), taken.begin(), taken.end());
            LocalMesh local(regions[i].complex);
            improve(local, objective,
                    list_of(edge_ring(local, objective), vertex_move(local, objective), cone_refill(local, objective)),
                    std::move(bad[i]), {.dear_plans = most_dear_plans}, context);
        }
    }
}

std::size_t relax_interfaces(std::span<InterfaceRegion> regions, const Mesh& mesh, std::span<const TetId> rim,
                             std::span<std::uint8_t> is_released, const Objective& objective, RunContext& context) {
    std::vector<std::vector<int>> poor(regions.size());
    std::vector<std::vector<NodeId>> nodes(regions.size());
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (!regions[i].has_interface() || has_needle(regions[i].complex, objective)) continue;
        poor[i] = poor_vertices(regions[i], mesh);
        for (const int v : poor[i]) nodes[i].push_back(regions[i].node_of(v));
    }
    const std::vector<std::vector<TetId>> around = kept_tets_with(nodes, mesh, rim, is_released, context);
    std::size_t released = 0;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (around[i].empty()) continue;
        for (const TetId tet : around[i]) is_released[tet.index()] = 1;
        const std::size_t before = regions[i].changed_count(mesh);
        relax(regions[i], mesh, poor[i], around[i], objective, context);
        released += regions[i].changed_count(mesh) - before;
    }
    return released;
}

std::size_t give_back(InterfaceRegion& region, const Mesh& mesh, std::span<std::uint8_t> is_released) {
    const std::size_t taken = region.taken_count();
    const std::vector<TetId> given = region.give_back(mesh);
    for (const TetId tet : given) is_released[tet.index()] = 0;
    return taken - given.size();
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/seam_mending.h"

#include <algorithm>

#include "volume/optimise.h"

namespace featuremesh {

namespace {

/// Kept tets so far from bad ones at the seam, counted in tets, are taken in at most.
constexpr int most_rings = 3;
/// In each of the steps. Where many tets at a seam cannot be helped, refilling round all of them would cost more than
/// the cavity itself, and the mean quality.
constexpr std::size_t most_refills = 300;

/// The kept tets that share a node with the tets given for each region; one that does with two goes to the first.
std::vector<std::vector<TetId>> kept_tets_around(std::span<const SeamRegion> regions,
                                                 const std::vector<std::vector<int>>& tets, const Mesh& mesh,
                                                 std::span<const std::uint8_t> is_released, const RunContext& context) {
    std::vector<std::vector<TetId>> around(tets.size());
    std::vector<int> region_of(mesh.node_count(), -1);
    bool is_any = false;
    for (std::size_t i = tets.size(); i-- > 0;)
        for (const NodeId n : regions[i].nodes_of(tets[i])) region_of[n.index()] = static_cast<int>(i), is_any = true;
    if (!is_any) return around;
    RoundWatch watch(context);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        watch();
        int first = -1;
        for (const NodeId n : mesh.tets[t])
            if (const int i = region_of[n.index()]; i >= 0 && (first < 0 || i < first)) first = i;
        if (first >= 0 && !is_released[t]) around[static_cast<std::size_t>(first)].emplace_back(t);
    }
    return around;
}

void mend(SeamRegion& region, const Mesh& mesh, std::span<const TetId> around, bool may_move, SliverOptions options,
          RunContext& context) {
    const std::vector<int> taken = region.take_in(mesh, around);
    if (may_move) region.free_inner_nodes(mesh);
    options.among.insert(options.among.end(), taken.begin(), taken.end());
    remove_slivers(region.complex, options, context);
}

}  // namespace

void mend_seams(std::span<SeamRegion> regions, const Mesh& mesh, std::span<std::uint8_t> is_released,
                double target_dihedral_deg, RunContext& context) {
    for (int rings = 0; rings < most_rings; ++rings) {
        std::vector<std::vector<int>> bad;
        for (const SeamRegion& region : regions)
            bad.push_back(region.with_rings(region.bad_tets_at_seam(target_dihedral_deg), rings));
        if (std::all_of(bad.begin(), bad.end(), [](const auto& tets) { return tets.empty(); })) return;
        const std::vector<std::vector<TetId>> around = kept_tets_around(regions, bad, mesh, is_released, context);
        for (std::size_t i = 0; i < regions.size(); ++i) {
            if (around[i].empty()) continue;
            for (const TetId tet : around[i]) is_released[tet.index()] = 1;
            SliverOptions options;
            options.target_dihedral_deg = target_dihedral_deg;
            options.among = std::move(bad[i]);
            options.most_refills = most_refills;
            mend(regions[i], mesh, around[i], rings > 0, std::move(options), context);
        }
    }
}

std::size_t give_back(SeamRegion& region, const Mesh& mesh, std::span<std::uint8_t> is_released) {
    const std::size_t taken = region.taken_count();
    const std::vector<TetId> given = region.give_back(mesh);
    for (const TetId tet : given) is_released[tet.index()] = 0;
    return taken - given.size();
}

}  // namespace featuremesh

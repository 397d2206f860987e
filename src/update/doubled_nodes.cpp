// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/doubled_nodes.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "brep/brep.h"
#include "core/ids.h"
#include "mesh/mesh.h"
#include "update/kept_tets.h"

namespace featuremesh {

namespace {

/// The nodes of an old edge or vertex on a new edge, and the parameters there from the first to the last.
struct Stretch {
    std::vector<std::size_t> nodes;
    double first = 0, last = 0;

    void add(std::size_t node, double t) {
        first = nodes.empty() ? t : std::min(first, t);
        last = nodes.empty() ? t : std::max(last, t);
        nodes.push_back(node);
    }
    bool overlaps(const Stretch& other) const { return first <= other.last && other.first <= last; }
};

}  // namespace

std::vector<std::size_t> doubled_nodes(const KeepInput& input, std::span<const std::int32_t> motions,
                                       const KeptEntities& places) {
    std::vector<std::size_t> doubled;
    if (input.old_brep.body_count() < 2) return doubled;
    std::set<Entity> vertices;
    std::map<Entity, std::map<Entity, Stretch>> edges;  // by new edge, by old edge or vertex
    for (std::size_t n = 0; n < motions.size(); ++n) {
        const Entity now = places.entities()[n], was = input.old_mesh.entities[n];
        if (motions[n] == dropped || was.dim > 1) continue;
        if (now.dim == 0 && !vertices.insert(now).second) doubled.push_back(n);
        if (now.dim != 1) continue;
        edges[now][was].add(n, places.parameters()[n][0]);
    }
    for (const auto& [edge, stretches] : edges) {
        std::vector<const std::pair<const Entity, Stretch>*> taken;
        for (const auto& mine : stretches) {
            const auto is_there = [&](const auto* other) {
                return mine.second.overlaps(other->second) && !share_body(input.old_brep, mine.first, other->first);
            };
            if (std::any_of(taken.begin(), taken.end(), is_there))
                doubled.insert(doubled.end(), mine.second.nodes.begin(), mine.second.nodes.end());
            else
                taken.push_back(&mine);
        }
    }
    return doubled;
}

}  // namespace featuremesh

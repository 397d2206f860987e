// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/kept_surfaces.h"

#include <algorithm>

#include "core/ids.h"
#include "difference/feature_difference.h"
#include "mesh/mesh.h"
#include "update/kept_tets.h"

namespace featuremesh {

namespace {

/// Which nodes are clear of what changed on a surface. Triangles of one surface come one after the other, so of each
/// node only the last answer is known.
class ClearNodes {
  public:
    ClearNodes(const KeepInput& input, const std::function<double(std::size_t)>& margin_of)
        : in_(input), margin_of_(margin_of), told_(input.old_mesh.node_count()) {}

    bool has(std::size_t node, int surface) {
        Told& told = told_[node];
        if (told.surface != surface) {
            const double margin = margin_of_(node);
            const ChangedBoundary& changed = in_.difference.regions[0].changed;
            told = {surface, margin > 0 && !changed.is_within(margin, in_.old_mesh.points[node],
                                                              static_cast<std::size_t>(surface))};
        }
        return told.is_clear;
    }

  private:
    struct Told {
        int surface = -1;
        bool is_clear = false;
    };
    const KeepInput& in_;
    const std::function<double(std::size_t)>& margin_of_;
    std::vector<Told> told_;
};

}  // namespace

void KeptSurfaces::find(std::span<const std::int32_t> motions, const std::function<double(std::size_t)>& margin_of,
                        const RunContext& context) {
    if (std::find(motions.begin(), motions.end(), dropped) == motions.end()) return;
    is_kept_.assign(in_.old_mesh.triangles.size(), 1);
    ClearNodes clear(in_, margin_of);
    RoundWatch watch(context);
    keep_where([&](std::size_t triangle, std::size_t node) {
        watch();
        const int surface =
            in_.difference.regions[0].surface_of_old_face[in_.old_mesh.triangle_faces[triangle].index()];
        return motions[node] == 0 || (motions[node] == dropped && clear.has(node, surface));
    });
}

void KeptSurfaces::settle(std::span<const std::int32_t> motions) {
    if (!is_kept_.empty()) keep_where([&](std::size_t, std::size_t node) { return motions[node] == 0; });
}

/// Of the kept triangles those with only such nodes.
template <class Stays>
void KeptSurfaces::keep_where(Stays stays) {
    const Mesh& old = in_.old_mesh;
    is_used_.assign(old.node_count(), 0);
    for (std::size_t t = 0; t < is_kept_.size(); ++t) {
        if (!is_kept_[t]) continue;
        const auto all_stay = [&](const auto& nodes) {
            return std::all_of(nodes.begin(), nodes.end(), [&](NodeId n) { return stays(t, n.index()); });
        };
        is_kept_[t] = all_stay(old.triangles[t]) && (old.order == 1 || all_stay(old.triangle_mids[t]));
        if (!is_kept_[t]) continue;
        for (const NodeId n : old.triangles[t]) is_used_[n.index()] = 1;
        if (old.order == 2)
            for (const NodeId n : old.triangle_mids[t]) is_used_[n.index()] = 1;
    }
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// The local operations: one file each, one line here.
#pragma once

#include <limits>

#include "core/run_context.h"
#include "volume/improvement/local_mesh.h"
#include "volume/improvement/objective.h"
#include "volume/improvement/operation.h"
#include "volume/wanted_size.h"

namespace featuremesh {

/// Removes an edge of the tet: its ring of at most ten tets is triangulated in the best way.
std::unique_ptr<Operation> edge_ring(LocalMesh& mesh, const Objective& objective);

/// Moves a corner of the tet, of whatever mobility, to where its star's worst tet is better; where the objective asks
/// for shape, uphill in the sum of the radius ratios.
std::unique_ptr<Operation> vertex_move(LocalMesh& mesh, const Objective& objective);

inline constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

struct RefillOptions {
    bool is_last_resort = false;  ///< new vertices are tried in more places, at a price in time and mean shape
    /// Tets too thin may have a cavity of 240 tets filled from a new vertex, so often; else 48 tets are the limit.
    std::size_t most_large_cavities = 0;
};
/// Fills a cavity round the tet from one of its vertices (multi-face flip, collapse) or from a new one.
std::unique_ptr<Operation> cone_refill(LocalMesh& mesh, const Objective& objective, const RefillOptions& options = {});

/// Gives a tet that is barred a new vertex inside, or on one of its inner edges, which may move but not go again.
std::unique_ptr<Operation> tet_split(LocalMesh& mesh, const Objective& objective);

/// Collapses a free corner that is nearer to a neighbour than seeds may be to each other.
std::unique_ptr<Operation> close_point_collapse(LocalMesh& mesh, const Objective& objective, const WantedSize& size);

/// Improves copies of what is around the tet, with one of its corners first moved for this tet alone, and takes the
/// best: what takes two changes of which the first harms.
std::unique_ptr<Operation> lookahead(LocalMesh& mesh, const Objective& objective, const RunContext& context);

template <class... Each>
Operations list_of(Each... each) {
    Operations list;
    (list.push_back(std::move(each)), ...);
    return list;
}

}  // namespace featuremesh

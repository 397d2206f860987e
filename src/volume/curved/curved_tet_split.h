// SPDX-License-Identifier: GPL-3.0-or-later
// Refines a 4-node mesh where its 10-node elements would be folded.
#pragma once

#include <cstddef>
#include <vector>

#include "core/ids.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// Splits what makes the tets `folded` (of `curved`, which is `mesh` with mid-side nodes, same tets) bad. A tet with
/// two triangles on the boundary gets a node inside: where the boundary is smooth across their common side, no tet can
/// hold both. Any other gets a corner where the mid-side node of its most bent boundary side is, together with all
/// elements around that side. Elements below the three counts are kept and stay. No tet that has the least volume,
/// mm^3, is split into some that have not. Returns how many nodes were added.
struct KeptCounts {
    std::size_t segments = 0, triangles = 0, tets = 0;
};
std::size_t split_folded_tets(Mesh& mesh, const Mesh& curved, const std::vector<TetId>& folded, const KeptCounts& kept,
                              double least_volume = 0);

}  // namespace featuremesh

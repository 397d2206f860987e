// SPDX-License-Identifier: GPL-3.0-or-later
// The last resort where curved sides fold 10-node tets: sides as straight as those of 4-node tets.
#pragma once

#include <cstddef>
#include <vector>

#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"

namespace featuremesh {

struct StraightSides {
    Mesh mesh;                   ///< empty where nodes that may not move are in the way
    std::size_t sides = 0;       ///< on the shape, but straight
    double distance = 0;         ///< mm: no mid-side node is further from where it was on the shape
    std::vector<Entity> places;  ///< the edges and faces of these sides, ascending
};

/// Takes the bend from all sides of the tets `folded`, and from those of their neighbours that it folds in turn, until
/// none is folded or nearly so. Straight tets are valid, so this ends. `is_movable` by node.
StraightSides straighten(Mesh mesh, std::vector<TetId> folded, const std::vector<bool>& is_movable,
                         RunContext& context);

}  // namespace featuremesh

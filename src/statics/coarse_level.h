// SPDX-License-Identifier: GPL-3.0-or-later
// The corners of a mesh of 10-node tets as a mesh of 4-node tets, on which its multigrid goes on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "statics/model.h"
#include "statics/stiffness.h"

namespace featuremesh {

/// Linear displacements within a space of quadratic ones. Its nodes are the first ones of the 10-node mesh.
struct CoarseLevel {
    BlockMatrix matrix;                                ///< the stiffness of the 4-node tets
    std::vector<std::array<std::int32_t, 2>> parents;  ///< by node of the 10-node mesh the two whose mean it gets
    std::vector<char> is_held;                         ///< by component of the 10-node mesh; held ones get nothing
};

/// Of a model with 10-node tets. Its matrix is made of an earlier one in place where that is given; rows that are
/// `same` in the model's matrix are so in its own, too.
CoarseLevel coarse_level(const StaticsModel& model, const TetsOfNodes& around, RunContext& context,
                         BlockMatrix earlier = {}, const SameRows* same = nullptr);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows of a stiffness matrix are those of an earlier one, bit for bit, and need not be assembled again.
#pragma once

#include <cstdint>
#include <vector>

#include "core/run_context.h"
#include "mesh/mesh.h"
#include "statics/model.h"
#include "statics/stiffness.h"

namespace featuremesh {

/// What a matrix was assembled from.
class AssembledModel {
  public:
    AssembledModel() = default;
    explicit AssembledModel(const StaticsModel& model, const TetsOfNodes& around);

    /// Those rows of the model's matrix that the one assembled from this has: of nodes whose tets are the same in the
    /// same order, with the same nodes at the same places, held and made of the same.
    SameRows rows_for(const StaticsModel& model, const TetsOfNodes& around, RunContext& context) const;

  private:
    std::vector<std::int32_t> same_nodes(const StaticsModel& model) const;
    bool is_same(const StaticsModel& model, std::size_t tet, std::size_t earlier,
                 const std::vector<std::int32_t>& origin) const;

    Mesh mesh_;
    std::vector<Material> materials_;
    std::vector<std::int32_t> tet_materials_;
    std::vector<char> is_held_;
    TetsOfNodes around_;
    std::vector<std::int32_t> by_number_;  // nodes by ascending number
};

}  // namespace featuremesh

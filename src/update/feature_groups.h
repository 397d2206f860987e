// SPDX-License-Identifier: GPL-3.0-or-later
// Which tets belong to which feature: what the cellular model knows and no other mesher can offer.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/run_context.h"
#include "update/part_mesh.h"

namespace featuremesh {

/// By feature that owns material: its name and its tets, ascending. A tet belongs to the cell its centroid is in, and to every owner of that cell.
std::vector<std::pair<std::string, std::vector<TetId>>> tets_of_features(const PartMesh& part, RunContext& context);

}  // namespace featuremesh

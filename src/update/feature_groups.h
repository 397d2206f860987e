// SPDX-License-Identifier: GPL-3.0-or-later
// Which tets belong to which feature, which no other mesher can tell.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/ids.h"
#include "core/run_context.h"
#include "update/part_mesh.h"

namespace featuremesh {

/// By feature that owns material: its name and its tets, ascending. A tet belongs to every feature that has its
/// centroid in one of its volumes, so to the owners of the cell it is in.
std::vector<std::pair<std::string, std::vector<TetId>>> tets_of_features(const PartMesh& part, RunContext& context);

}  // namespace featuremesh

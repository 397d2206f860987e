// SPDX-License-Identifier: GPL-3.0-or-later
// Finds 10-node tets that their curved sides fold, and unfolds them by moving nodes.
#pragma once

#include <vector>

#include "core/run_context.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// The tets whose scaled Jacobian is at most `limit` somewhere, proved by its Bernstein coefficients. Only tets with a curved side are looked at.
std::vector<TetId> tets_at_most(const Mesh& mesh, double limit, RunContext& context);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Unfolds 10-node tets by moving nodes.
#pragma once

#include <vector>

#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "surface/projection.h"
#include "volume/curved/curved_tet_descent.h"

namespace featuremesh {

/// Moves nodes of the tets below the aim until they reach it or nothing helps any more, in this order: inner mid-side
/// nodes, mid-side nodes on faces (along the face), inner corner nodes, mid-side nodes on edges. A move is accepted
/// when the smallest scaled Jacobian around the node rises, and for a corner node only when no dihedral angle around it
/// gets bad or no volume goes below the least one. Then all of them together (curved_tet_descent.h), then one by one
/// for the sum of what the tets lack. `is_movable` by node. Returns the tets that are still below the aim.
std::vector<TetId> unfold_tets(Mesh& mesh, const Projector& projector, const std::vector<bool>& is_movable,
                               const CurvedTetAims& aims, RunContext& context);

}  // namespace featuremesh

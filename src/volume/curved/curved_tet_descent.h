// SPDX-License-Identifier: GPL-3.0-or-later
// Unfolds 10-node tets by moving all nodes around them at once.
#pragma once

#include <vector>

#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "surface/projection.h"
#include "volume/curved/low_tets.h"

namespace featuremesh {

/// What curved tets are improved towards.
struct CurvedTetAims {
    double scaled_jacobian;  ///< smallest of each tet
    /// mm^3: moving corners takes no straight tet below this, nor all corners at once below a third of what it had;
    /// none that has less below that
    double least_volume = 0;
};

/// Lowers a moving log barrier on the Bernstein coefficients of the tets around `bad` (Toulorge, Geuzaine, Remacle and
/// Lambrechts 2013) by quasi-Newton steps of all their movable mid-side nodes and inner corners, those on CAD entities
/// along these. Every coefficient below the wanted scaled Jacobian is pushed up to it. Where moving one node at a
/// time stops because a neighbour loses what the tet gains, this goes on.
void descend(Mesh& mesh, const TetsAtNode& tets_at, const Projector& projector, const std::vector<bool>& is_movable,
             const std::vector<TetId>& bad, const CurvedTetAims& aims, RunContext& context);

}  // namespace featuremesh

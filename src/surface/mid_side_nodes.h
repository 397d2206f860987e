// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the mid-side nodes of 10-node tets on the exact CAD edges and faces.
#pragma once

#include "core/run_context.h"
#include "features/brep.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// Makes a 4-node mesh a 10-node one: sides on CAD edges and faces get their mid-side node on the entity, half way in the edge's arc length, others in the
/// middle. Elements of `kept` (a 10-node mesh, its elements in front in the same order) keep theirs bit for bit.
Mesh curve_to_second_order(const Brep& brep, Mesh mesh, const Mesh* kept, RunContext& context);

}  // namespace featuremesh

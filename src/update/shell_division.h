// SPDX-License-Identifier: GPL-3.0-or-later
// Shells beside solids whose edges the filling of the solids divided.
#pragma once

#include <array>
#include <span>

#include "brep/brep.h"
#include "core/ids.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// Divides triangles on free faces at the nodes by which the segments at their sides were divided; what is divided gets
/// new numbers. `segments`: those of the 4-node mesh before that, which are in front still, each cut back to its first
/// piece.
void divide_shells(const Brep& brep, std::span<const std::array<NodeId, 2>> segments, Mesh& mesh);

}  // namespace featuremesh

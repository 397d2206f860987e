// SPDX-License-Identifier: GPL-3.0-or-later
// Finds surface triangles that lie the wrong way round on their face.
#pragma once

#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// The triangles whose normal is against that of their face at every corner. Tets do not tell: behind a fold of the
/// surface they can all be positive. A corner's parameters are its own on the face, else those of its CAD edge on the
/// face. `is_wanted` by node: only triangles with three such nodes are looked at; empty: all.
std::vector<TriangleId> turned_triangles(const Brep& brep, const Mesh& mesh, const std::vector<char>& is_wanted,
                                         RunContext& context);

}  // namespace featuremesh

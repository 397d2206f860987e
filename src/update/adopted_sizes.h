// SPDX-License-Identifier: GPL-3.0-or-later
// The edge lengths of an adopted mesh, as sources of the wanted size.
#pragma once

#include <vector>

#include "mesh/mesh.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// One source for every few nodes, at their middle, with the mean length of the sides of the tets around them; of at
/// most `size` where most of the mesh is clearly coarser than that, mm.
std::vector<SizeSource> local_sizes(const Mesh& mesh, double size);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of nodes along edges that lie beside one another, nearer than a projection can tell apart.
#pragma once

#include <cstddef>
#include <span>

#include "brep/brep.h"
#include "core/ids.h"
#include "mesh/mesh.h"
#include "surface/projection.h"

namespace featuremesh {

/// In a strip of needles nodes of one edge are on the edge beside it, too, as far as Tolerances::contact() goes. Which
/// way the needles' sides lean is free there. They are turned, with the tets on them, so that all nodes on an edge,
/// sorted by its parameter and those level with one another by number, follow one another along sides of the mesh.
/// Only among `triangles`, only with tets from `first_tet` on, and only where no tet gets much thinner or flatter, but
/// for the angle that a needle has anyway.
/// New tets are appended. Returns how many sides were turned.
std::size_t lean_needles(const Brep& brep, const Projector& projector, std::span<const TriangleId> triangles,
                         std::size_t first_tet, Mesh& mesh);

}  // namespace featuremesh

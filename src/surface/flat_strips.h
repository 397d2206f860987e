// SPDX-License-Identifier: GPL-3.0-or-later
// Narrow strips between faces in about the same plane.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/ids.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// The two edges, beside one another, of each strip with a triangle that no Delaunay triangulation has: one between a
/// piece of the one edge and a node of the other, where what lies beyond the piece is in about the same plane. With the
/// nodes of the two edges opposite one another it would have them. Triangles before `first_new` stay as they are.
std::vector<std::array<EdgeId, 2>> edges_of_flat_strips(const Mesh& mesh, std::size_t first_new);

}  // namespace featuremesh

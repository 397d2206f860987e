// SPDX-License-Identifier: GPL-3.0-or-later
// The tets around some nodes.
#pragma once

#include <span>
#include <vector>

#include "core/ids.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// Tets with a marked corner, ascending.
std::vector<TetId> tets_at_nodes(const Mesh& mesh, std::span<const char> is_marked);

}  // namespace featuremesh

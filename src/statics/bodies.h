// SPDX-License-Identifier: GPL-3.0-or-later
// Which tets hang together by their facets and so move as one body where nothing strains them.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace featuremesh {

/// By tet the body that it belongs to, counted from 0 in the order of their first tets. Tets that share only a node or
/// an edge are of different bodies: one can turn against the other.
std::vector<std::int32_t> bodies_of_tets(const Mesh& mesh);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// What a refusal says of edges that leave no room for tets.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "core/message.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// "Edge12 (0.0021 mm long)": the three shortest of the edges shorter than
/// Tolerances::least_length() between two corners of a tet, by the distance of their ends. None where there is none.
/// The tets' corners count in `nodes`; others are inside.
std::vector<Message> short_edges_among(const Brep& brep, const Mesh& mesh, std::span<const NodeId> nodes,
                                       std::span<const std::array<int, 4>> tets);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes of solids that touched, where these share edges and vertices now.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "update/keep.h"
#include "update/kept_entities.h"

namespace featuremesh {

/// Of the kept nodes, as they are placed, those on a new vertex that has one already, and on a stretch of a new edge
/// that has those of another solid's old edge.
std::vector<std::size_t> doubled_nodes(const KeepInput& input, std::span<const std::int32_t> motions,
                                       const KeptEntities& places);

}  // namespace featuremesh

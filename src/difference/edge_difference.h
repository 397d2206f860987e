// SPDX-License-Identifier: GPL-3.0-or-later
// What changed between the edges of two states, where there are no faces to tell.
#pragma once

#include "difference/boundary_match.h"
#include "difference/feature_difference.h"
#include "difference/trim_difference.h"

namespace featuremesh {

/// Appends the stretches of curves that one state has edges on and the other has not, and the vertices that only one of
/// them has, as triangles without area, no longer than the resolution.
void append_edge_difference(const BoundaryPair& pair, const BoundaryMatch& match, const Resolution& resolution,
                            std::vector<SpaceTriangle>& triangles);

}  // namespace featuremesh

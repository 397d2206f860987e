// SPDX-License-Identifier: GPL-3.0-or-later
// Which new faces, edges and vertices lie where an old one, moved, was.
#pragma once

#include "difference/boundary_match.h"
#include "difference/feature_difference.h"

namespace featuremesh {

/// Fills the region's tables of new faces, edges and vertices.
void find_partners(const BoundaryPair& pair, const BoundaryMatch& match, CarriedRegion& region);

/// What became of every face, without a motion.
std::vector<FaceChange> face_changes(const BoundaryPair& pair, const BoundaryMatch& match, const CarriedRegion& region);

}  // namespace featuremesh

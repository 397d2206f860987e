// SPDX-License-Identifier: GPL-3.0-or-later
// Whether faces of two shapes may cover the same place.
#pragma once

#include <vector>

#include "features/merged_edges.h"
#include "features/patch_faces.h"

namespace featuremesh {

/// Whether a face that appeared has all its edges on the surface of one that vanished, with material on the same side,
/// though the two are not of one carrier (their parameters differ): between shells they would be two walls with nothing
/// in between.
bool any_on_each_other(const std::vector<PatchFace>& faces, const MergedEdges& edges);

}  // namespace featuremesh

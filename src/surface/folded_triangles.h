// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a patch that stand across the surface.
#pragma once

#include <array>

#include "surface/patch_improvement.h"
#include "surface/triangle_patch.h"

namespace featuremesh {

/// Whether three points of the patch, in their order, stand across the surface: at their middle, or at all three, where
/// they reach more than half around it and their middle says nothing.
bool is_folded(const TrianglePatch& patch, const PatchGeometry& geometry, const std::array<int, 3>& corners);
bool is_folded(const TrianglePatch& patch, const PatchGeometry& geometry, int t);

/// Whether turning the side opposite corner i of t would make a folded triangle where there is none.
bool folds_by_turning(const TrianglePatch& patch, const PatchGeometry& geometry, int t, int i);

/// Turns a side of a folded triangle after which neither triangle beside it is; false where there is none.
bool unfold(TrianglePatch& patch, const PatchGeometry& geometry, int t);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// The books of the cells after an edit, without fusing again what the edit does not touch.
#pragma once

#include <optional>

#include "cells/cell_model.h"

namespace featuremesh {

/// A part before an edit.
struct CellsBefore {
    const FeatureTree& tree;
    const CellModel& cells;
};

/// A summary (CellModel::is_summary) of the new state. Solids of features that are the same to the last bit, or face by
/// face, are paired; around all others a box is laid, in which the few solids that reach into it are fused, once as
/// they were and once as they are. Outside of the box nothing changed, as long as both trees combine the common
/// features in the same way. Owners of final faces are those found in the box; the difference knows the other faces.
/// Without a fuse when the old books needed a fallback, the trees differ in more than volumes, most of the part is near
/// the change or the kernel cannot fuse what is in the box.
/// Nothing when the books do not close in the box: then the cells are to be built from nothing.
std::optional<CellModel> cells_after_edit(const CellsBefore& before, const FeatureTree& tree, const Brep& final_shape,
                                          RunContext& context);

/// A summary without owners of faces (the difference finds them). Trusts whom the state before an edit trusted; volumes
/// of features that did not change are the old ones, of others the sum of their solids.
CellModel cells_without_fuse(const FeatureTree& tree, const Brep& final_shape, const CellsBefore* before = nullptr);

}  // namespace featuremesh

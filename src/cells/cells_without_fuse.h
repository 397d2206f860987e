// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh needs of the cells, without fusing: the volumes of the features and which of them failed.
#pragma once

#include <optional>

#include "cells/cell_model.h"
#include "features/feature_tree.h"

namespace featuremesh {

/// A part before an edit.
struct CellsBefore {
    const FeatureTree& tree;
    const CellModel& cells;
};

/// No cells, no faces, no owners of faces: those are found by points when they are asked for. The volume of a feature
/// is the sum of its solids, or what it was before the edit where they are the same.
CellModel cells_without_fuse(const FeatureTree& tree, const Brep& final_shape,
                             const std::optional<CellsBefore>& before = {});

}  // namespace featuremesh

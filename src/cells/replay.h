// SPDX-License-Identifier: GPL-3.0-or-later
// The material as the feature tree says it should be.
#pragma once

#include <vector>

#include "cells/cell_model.h"
#include "features/feature_tree.h"

namespace featuremesh {

/// By cell: is it material after all features were applied in their order? The final shape decides what is; this is the
/// cross-check.
std::vector<bool> replay(const FeatureTree& tree, const std::vector<Cell>& cells);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// The volumes of an object that stands elsewhere once more: mirrored, linked, cloned or in an array.
#pragma once

#include <optional>
#include <vector>

#include "core/ids.h"
#include "features/document_view.h"
#include "features/feature_tree.h"
#include "features/raw_document.h"

namespace featuremesh {

/// The volumes that make the result of a feature one after the other, each adding, removing or limiting (`step`).
/// Nothing where the tree combines them otherwise, say cuts away what was itself cut.
std::optional<std::vector<FeatureVolume>> volumes_in_order(const FeatureTree& tree, FeatureId last);

/// The volumes of `source` where `copy` has them, by the placements of both or the mirror plane, or, of an array, once
/// for each element; nothing when none of that makes the solids of the one into those of the other.
std::optional<std::vector<FeatureVolume>> copied_volumes(const RawRecord& copy, const RawRecord& source,
                                                         const std::vector<FeatureVolume>& volumes,
                                                         const DocumentView& document);

}  // namespace featuremesh

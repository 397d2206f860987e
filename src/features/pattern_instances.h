// SPDX-License-Identifier: GPL-3.0-or-later
// A pattern's volumes as moved copies of the volumes it repeats.
#pragma once

#include <optional>
#include <vector>

#include "features/document_view.h"
#include "features/feature_tree.h"
#include "features/raw_document.h"

namespace featuremesh {

/// One volume per repeated volume and further occurrence, placed by the pattern's parameters. The parameters alone are
/// not trusted (versions differ in what they mean): the instances are returned only when they explain the shapes before
/// and after the pattern.
std::optional<std::vector<FeatureVolume>> pattern_instances(const RawRecord& pattern,
                                                            const std::vector<FeatureVolume>& originals,
                                                            const TopoDS_Shape& before, const TopoDS_Shape& after,
                                                            const DocumentView& document);

}  // namespace featuremesh

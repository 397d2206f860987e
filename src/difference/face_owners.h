// SPDX-License-Identifier: GPL-3.0-or-later
// Who owns the faces of a part whose cells were not built again as a whole.
#pragma once

#include <vector>

#include "difference/feature_difference.h"

namespace featuremesh {

/// By new FaceId. A face that was kept has the owners it had. A face that is trimmed differently or new has those that
/// were found in the edited box, and those of the old faces it overlaps whose volumes reach out of the box; where
/// nothing was fused, those whose volumes have a face there. `difference` has its faces and its first region.
std::vector<std::vector<Owner>> owners_after_edit(const PartState& old_state, const PartState& new_state,
                                                  const FeatureDifference& difference);

}  // namespace featuremesh

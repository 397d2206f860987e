// SPDX-License-Identifier: GPL-3.0-or-later
// Of several solids, those that an edit left as they were, or moved as a whole.
#pragma once

#include <cstdint>
#include <vector>

#include "update/keep.h"

namespace featuremesh {

/// By old solid: the index of the carried region under whose motion it is one of the new solids, face by face; -1 for
/// none, and for all where there is only one solid. A solid that shares faces with others is looked for in its old
/// place only.
std::vector<std::int32_t> motions_of_untouched_solids(const KeepInput& input);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Local sizes whose face, edge, vertex or solid the part does not have.
#pragma once

#include <vector>

#include "core/message.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// One line for each local size at an entity that is gone, with its name; such sizes are left out.
std::vector<Message> lost_sizes(const Brep& brep, const SizingOptions& options);

}  // namespace featuremesh

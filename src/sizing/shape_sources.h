// SPDX-License-Identifier: GPL-3.0-or-later
// Where the part itself asks for a size: local sizes, curvature, thin walls.
#pragma once

#include <vector>

#include "brep/brep.h"
#include "sizing/sizing_field.h"
#include "sizing/source_tree.h"

namespace featuremesh {

/// Balls that cover the entities on which something smaller than the global size is wanted. Nothing is tessellated but
/// for thin walls. Local sizes on entities that the part does not have are skipped and logged.
std::vector<SourceBall> shape_sources(const Brep& brep, const SizingOptions& options, RunContext& context);

}  // namespace featuremesh

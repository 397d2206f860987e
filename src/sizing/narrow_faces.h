// SPDX-License-Identifier: GPL-3.0-or-later
// Where faces are far narrower than the size.
#pragma once

#include <memory>

#include "brep/brep.h"
#include "sizing/size_provider.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// Balls along edges of a face that run beside one another (within one degree) for more than 1.25 pieces,
/// where the strip between them is narrower than a fifth of the size: pieces longer than four widths leave needles in
/// it. No piece is shorter than a quarter of the size, and what is narrower than a twenty-fifth is left to its needles,
/// since it would take too many. Nothing is asked for on the rim of a thin wall, whose tets are as thin everywhere, nor
/// between two edges that meet or approach one another, whose corner forces needles.
std::unique_ptr<SizeProvider> narrow_face_provider(const Brep& brep, const SizingOptions& options);

}  // namespace featuremesh

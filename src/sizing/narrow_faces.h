// SPDX-License-Identifier: GPL-3.0-or-later
// Where faces are far narrower than the size.
#pragma once

#include <vector>

#include "features/brep.h"
#include "sizing/sizing_field.h"
#include "sizing/source_ball.h"

namespace featuremesh {

/// Appends balls along edges of the face that run beside one another, where the face between them is narrower than a
/// fifth of the size: pieces longer than four widths leave needles in it. What is narrower than a twenty-fifth is left
/// to them, since it would take too many pieces. Nothing is asked for on the rim of a thin wall, whose tets are as thin
/// everywhere, nor between two edges that meet, whose corner forces needles.
void cover_narrow_face(const Brep& brep, FaceId face, const SizingOptions& options, std::vector<SourceBall>& out);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Covers an edge with balls of the size that is wanted there.
#pragma once

#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "sizing/size_provider.h"
#include "sizing/source_ball.h"

namespace featuremesh {

/// Appends the balls; none where nothing below `limit` (mm) is wanted, and none on a pole. Pieces are halved until they
/// are about two of the wanted edge lengths long.
void cover_edge(const Brep& brep, EdgeId edge, std::span<const EdgeWish> wishes, double limit,
                std::vector<SourceBall>& out);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces that a constrained triangulation tells of a facet though they lie over others of it.
#pragma once

#include <vector>

#include "volume/cavity.h"
#include "volume/recovery/facet_split.h"

namespace featuremesh {

/// Takes out every piece with a side that is its alone and yet no part of the facet's own sides, as the added points
/// cut them: such a piece spans points that were added between two of its corners. Gives back the facets that the
/// pieces left do not tile, ascending.
std::vector<int> drop_stray_pieces(const Cavity& cavity, FacetSplit& split);

}  // namespace featuremesh

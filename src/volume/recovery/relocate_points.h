// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the points that a recovery added to the boundary off it again.
#pragma once

#include <optional>
#include <span>

#include "core/geometry.h"
#include "volume/cavity.h"
#include "volume/fill_cavity.h"
#include "volume/recovery/constrained_delaunay.h"

namespace featuremesh {

/// Moves every added point from its facet or edge into the space behind, one copy into each region that it touches, and
/// puts the facets as they were in its place, with tets between them and the moved point (the idea of Weatherill and
/// Hassan 1994; George, Borouchaki and Saltel 2003). The boundary is then exactly what was asked for: no CAD face is
/// asked where the point belongs, and no kept tet has to go. The result has tets inside regions only. None where
/// rounding leaves a point no room to move.
std::optional<CavityFill> relocate_points(const Cavity& cavity, const ConstrainedTriangulation& recovered,
                                          std::span<const Vec3> seeds, RunContext& context);

}  // namespace featuremesh

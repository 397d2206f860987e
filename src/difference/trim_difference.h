// SPDX-License-Identifier: GPL-3.0-or-later
// Where exactly one of two trims of an underlying surface is, as triangles.
#pragma once

#include <array>
#include <vector>

#include "core/geometry.h"
#include "difference/boundary_match.h"
#include "difference/feature_difference.h"

namespace featuremesh {

using SpaceTriangle = std::array<Vec3, 3>;

/// Appends triangles that cover, up to resolution / 4, the symmetric difference of the group's old (moved) and new
/// trims and the changed pieces of their borders; they reach at most one cell of size `resolution` beyond it. Nothing
/// outside the domain.
///
/// The parameter plane is halved again and again where a changed piece runs, down to the resolution. A cell that no
/// changed piece enters lies wholly in the difference or wholly outside it: one point decides. One that few straight
/// pieces enter is cut along them.
void append_trim_difference(const BoundaryPair& pair, const BoundaryMatch& match, const SurfaceGroup& group,
                            const Resolution& resolution, std::vector<SpaceTriangle>& triangles);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Needles: tets with two boundary vertices far nearer to each other than to the rest. The CAD forces an angle upon
// them.
#pragma once

#include <array>

#include "core/geometry.h"

namespace featuremesh {

/// A needle's shortest side over its longest. If it is longer than that, the angle opposite to it is large enough to be
/// improved.
inline constexpr double needle_share = 0.005;
/// No needle is less flat, and few other tets are as flat.
inline constexpr double least_flatness_of_needle = 0.97;

/// The flatness of a needle without the angle opposite its short side: no mesh with both nodes has a larger one. That
/// of any other tet as it is.
double unforced_flatness(double flatness, const std::array<Vec3, 4>& corners,
                         const std::array<bool, 4>& is_on_boundary);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Where a point of a star-shaped region has the most room.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/geometry.h"

namespace featuremesh {

/// The point that lies furthest from the planes of the triangles among those that make tets of positive volume (point,
/// a, b, c) with all of them: the Chebyshev centre of the kernel (Boyd and Vandenberghe 2004, Convex Optimization,
/// section 8.5.1), by a linear program in exact arithmetic. It is looked for within `reach` of `start` along each axis.
/// None where no such point can be told in double precision.
std::optional<Vec3> kernel_centre(std::span<const std::array<Vec3, 3>> triangles, const Vec3& start, double reach);

}  // namespace featuremesh

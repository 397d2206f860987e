// SPDX-License-Identifier: GPL-3.0-or-later
// The radius ratios of tets that share a point, and how their sum grows with it.
#pragma once

#include <array>
#include <span>

#include "core/geometry.h"

namespace featuremesh {

/// A triangle that makes a tet of positive volume with a point: (point, corners).
struct SeenTriangle {
    std::array<Vec3, 3> corners;
    std::array<bool, 3> is_on_boundary{};  ///< by corner
};

/// Sum of the tets' radius ratios 3 r / R, and the way in which it grows; without volume a tet adds nothing.
struct RadiusRatios {
    double sum = 0;
    Vec3 gradient{};
};
RadiusRatios radius_ratios(const Vec3& point, std::span<const SeenTriangle> triangles);
double sum_of_radius_ratios(const Vec3& point, std::span<const SeenTriangle> triangles);

}  // namespace featuremesh

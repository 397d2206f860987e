// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a point lies before, behind or in a plane, without an error.
#pragma once

#include "core/geometry.h"

namespace featuremesh {

/// The sign of `signed_volume` of the points as they are given, exact: -1, 0 or 1.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace featuremesh

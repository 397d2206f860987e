// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a plane polygon into triangles between its corners.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/geometry.h"

namespace featuremesh {

/// The polygon `outline` (indices of points, counterclockwise seen against `normal`) as triangles that turn alike, best
/// ears first. Corners may lie on a line with their neighbours. Appends to `triangles`; false where no triangle with
/// area is left to cut off.
bool cut_polygon(std::span<const Vec3> points, std::vector<int> outline, const Vec3& normal,
                 std::vector<std::array<int, 3>>& triangles);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Points whose planes hold exactly: in another frame, and moved by less than counts.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry.h"
#include "volume/cavity.h"

namespace featuremesh {

/// The cavity's points and those after them in a frame along the plane that most of the facets' area lies in, and along
/// the largest one across it, if any. Coordinates that differ by no more than 1e-9 of the extent are made equal: what
/// lies in a plane across an axis but for rounding then does so exactly, as in a part that is not turned. Nothing where
/// that makes one of two points.
std::optional<std::vector<Vec3>> levelled_points(const Cavity& cavity, const std::vector<Vec3>& points);

}  // namespace featuremesh

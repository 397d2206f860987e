// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry.h"

namespace featuremesh {

/// Unit vectors spread evenly over the sphere.
const std::vector<Vec3>& directions_in_space();

}  // namespace featuremesh

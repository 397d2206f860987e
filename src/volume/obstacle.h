// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the way of a volume mesh.
#pragma once

#include <string>
#include <vector>

#include "sizing/sizing_field.h"

namespace featuremesh {

struct Obstacle {
    std::string message;                   ///< what, where (by the names of CAD faces), and what to try
    std::string place;                     ///< names of CAD faces
    std::vector<SizeSource> shorter = {};  ///< lengths with which it may work; none where sizes do not matter
};

}  // namespace featuremesh

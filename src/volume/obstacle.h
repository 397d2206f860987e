// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the way of a volume mesh.
#pragma once

#include <vector>

#include "core/ids.h"
#include "core/message.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

struct Obstacle {
    Message message;                       ///< what, where, and what to try
    std::vector<Entity> place;             ///< CAD faces
    std::vector<SizeSource> shorter = {};  ///< lengths with which it may work; none where sizes do not matter
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// What the report says of very thin tets.
#pragma once

#include <vector>

#include "core/message.h"
#include "mesh/mesh.h"
#include "mesh/quality.h"

namespace featuremesh {

/// That planes are many faces (`split_planes.h`); the details of the part that force angles below 2 degrees, shortest
/// first; and, if nothing forces the smallest angle, where that is, or the two faces that touch each other there.
std::vector<Message> warnings_of_thin_tets(const Mesh& mesh, const QualityReport& quality);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// What the report says of parts whose planes are many faces.
#pragma once

#include <optional>

#include "core/message.h"
#include "mesh/mesh.h"
#include "mesh/quality.h"

namespace featuremesh {

/// Where a mesh (STL) was made a solid each triangle is a face, and elements have to meet its edges, though most of
/// them lie within a plane. Nothing where few edges do, or most thin elements lie elsewhere.
std::optional<Message> warning_of_split_planes(const Mesh& mesh, const QualityReport& quality);

}  // namespace featuremesh

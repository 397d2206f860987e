// SPDX-License-Identifier: GPL-3.0-or-later
// How FreeCAD names the entities of a shape.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/ids.h"

namespace featuremesh {

/// "Face12", "Edge3", "Vertex1", "Solid1".
std::string name_of(Entity entity);

/// The other way; none for what is no such name.
std::optional<Entity> entity_named(std::string_view name);

}  // namespace featuremesh

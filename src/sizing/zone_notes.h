// SPDX-License-Identifier: GPL-3.0-or-later
// What a user should know of zones that cannot do, or do not do, what they are there for.
#pragma once

#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/message.h"
#include "sizing/size_zone.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// Throws InputError that names the zone for sizes or measures that make no sense.
void check_zone(const SizeZone& zone);

/// One line for each zone that changes nothing, since it is outside the part, near nothing of it, or not finer than the
/// rest; and for those that grow more slowly than asked. `nodes` are those of the mesh that was made with the options.
std::vector<Message> notes_on_zones(const Brep& brep, const SizingOptions& options, std::span<const Vec3> nodes);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes in places of the user's own: boxes, spheres, cylinders, and what is near faces and edges.
#pragma once

#include <memory>

#include "brep/brep.h"
#include "sizing/size_provider.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// `options.zones`, but for those that ask for nothing.
std::unique_ptr<SizeProvider> zone_provider(const Brep& brep, const SizingOptions& options);

}  // namespace featuremesh

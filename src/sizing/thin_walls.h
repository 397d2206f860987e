// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes by how thick the material is below a face.
#pragma once

#include <memory>

#include "brep/brep.h"
#include "sizing/size_provider.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// `options.elements_across_gap` elements across a wall, by rays into the material (wall_rays.h); none where it is 0.
std::unique_ptr<SizeProvider> thin_wall_provider(const Brep& brep, const SizingOptions& options);

}  // namespace featuremesh

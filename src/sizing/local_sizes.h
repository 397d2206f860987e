// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes that the user gives to faces, edges, vertices and solids.
#pragma once

#include <memory>

#include "brep/brep.h"
#include "sizing/size_provider.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// `options.local`. What is asked for in a solid is asked for on its faces, and for one of several solids in all cells
/// of a halved box inside it.
std::unique_ptr<SizeProvider> local_size_provider(const Brep& brep, const SizingOptions& options);

}  // namespace featuremesh

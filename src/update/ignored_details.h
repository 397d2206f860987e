// SPDX-License-Identifier: GPL-3.0-or-later
// What may be left out of a mesh because it is far smaller than the elements.
#pragma once

#include "brep/brep.h"
#include "update/options.h"

namespace featuremesh {

/// The length, mm, below which details are ignored where the part is refused with them; 0 where the user says how, and
/// where nothing is so small.
double ignorable_below(const Brep& brep, const MeshOptions& options);

}  // namespace featuremesh

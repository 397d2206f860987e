// SPDX-License-Identifier: GPL-3.0-or-later
// What is left out of a mesh because it is far smaller than the elements.
#pragma once

#include "brep/brep.h"
#include "update/options.h"

namespace featuremesh {

/// The length, mm, below which details are ignored: the user's, or what is negligible beside the elements, the smallest
/// local size, the part and the walls of each of its solids.
double length_to_ignore(const Brep& brep, const MeshOptions& options);

/// Whether the same details of the part are below the one length as below the other.
bool ignore_the_same(const Brep& brep, double length, double other);

}  // namespace featuremesh

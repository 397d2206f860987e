// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary recovery by constraint only around what is missing.
#pragma once

#include <optional>

#include "volume/cavity.h"
#include "volume/fill_cavity.h"
#include "volume/recovery/constrained_delaunay.h"

namespace featuremesh {

/// As constrained_delaunay for the whole cavity, but only the tets near missing facets are made anew: what a few
/// missing triangles cost no longer depends on the size of the mesh. None when added points would have to cut the
/// border of that neighbourhood.
std::optional<ConstrainedTriangulation> recover_locally(const Cavity& cavity, const CavityFill& fill,
                                                        const RunContext& context = {});

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Tets beside needles that the boundary forces, and where tets without volume were mended.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/run_context.h"
#include "volume/tet_complex.h"

namespace featuremesh {

/// Sliver removal looks at the worst tet of whatever it changes, and a needle is the worst wherever it comes in: all
/// tets with a vertex at it stay as they were. Here needles count by unforced_flatness, which lets the tets around
/// them improve: edges are removed, free vertices moved and those of the worst tets
/// collapsed where the worst so measured gets better and the burden of
/// all less; tets of a `thickness` below 1 are the worst of all. So do the tets `mended`, which were made for their
/// volume whatever that did to angles (`thicken`); tets that are gone may be among them. Returns how many operations
/// that took; without needles and mended tets none.
std::size_t improve_beside_needles(TetComplex& complex, std::vector<int> mended, double target_dihedral_deg,
                                   double least_volume, RunContext& context);

}  // namespace featuremesh

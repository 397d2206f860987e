// SPDX-License-Identifier: GPL-3.0-or-later
// Takes out free vertices that stand far closer together than the sizes ask for: what a recovery leaves behind.
#pragma once

#include <cstddef>
#include <span>

#include "core/run_context.h"
#include "volume/lattice_seeds.h"
#include "volume/tet_complex.h"

namespace featuremesh {

/// Collapses those of the vertices that are free and nearer to a neighbour than seeds may be to each other
/// (SeedOptions::spacing), each onto the neighbour that leaves the best worst angle: where that is no worse than it
/// was, no tet is smaller than the smallest was, the tets that miss the target do not weigh more, and no needle is
/// near. How many went.
std::size_t remove_crowded(TetComplex& complex, std::span<const int> vertices, const WantedSize& size,
                           double target_dihedral_deg, const RunContext& context);

}  // namespace featuremesh

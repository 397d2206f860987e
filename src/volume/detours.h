// SPDX-License-Identifier: GPL-3.0-or-later
// Tets that no single operation helps are helped by one that first harms others.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/run_context.h"
#include "surface/projection.h"
#include "volume/boundary_moves.h"
#include "volume/tet_complex.h"

namespace featuremesh {

/// Tries the tets that miss the target, worst first and not very many, on copies of what is around them: as it is, but
/// with new vertices in more places, and with a vertex moved for the tet's sake alone (`move_for_tet`). A copy is
/// mended
/// (`remove_slivers`, `move_on_boundary`, `optimise_shapes`), and the best one takes the original's place if of the
/// tets that differ the worst is no worse and the bad ones weigh less. Updates `vertices` like `move_on_boundary`.
/// Returns how many copies took a place.
std::size_t take_detours(TetComplex& complex, std::span<BoundaryVertex> vertices, const Projector& projector,
                         const BoundaryMoveOptions& options, RunContext& context);

}  // namespace featuremesh

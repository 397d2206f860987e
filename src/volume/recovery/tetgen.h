// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary recovery by the program TetGen, where it is installed.
#pragma once

#include <optional>
#include <span>

#include "core/geometry.h"
#include "core/run_context.h"
#include "volume/cavity.h"
#include "volume/fill_cavity.h"

namespace featuremesh {

/// Tets that have every facet as it is, with points added only inside (H. Si: TetGen, a Delaunay-based quality
/// tetrahedral mesh generator, 2015; its option -Y). Where facets are needles by the thousand, as of a solid that was
/// made of an STL mesh, it adds a few points in tenths of a second; flips take minutes, constraints add points by the
/// hundred thousand. TetGen is under the AGPL, so it is a program of its own to us, as CalculiX is. None where it is
/// not installed, or did not bring every facet back. Throws as run_isolated does.
std::optional<CavityFill> recover_by_tetgen(const Cavity& cavity, std::span<const Vec3> seeds, RunContext& context);

}  // namespace featuremesh

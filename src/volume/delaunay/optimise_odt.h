// SPDX-License-Identifier: GPL-3.0-or-later
// Variational optimisation (ODT) on connectivity as it is.
#pragma once

#include <cstddef>

#include "core/run_context.h"
#include "sizing/sizing_field.h"
#include "volume/tets/tet_complex.h"

namespace featuremesh {

struct OdtOptions {
    int sweeps = 3;               ///< at most; they end when nothing gains any more
    bool weight_by_size = false;  ///< V / s(centroid)^3 instead of V where the sizing is graded; then three times as
                                  ///< many sweeps: a graded lattice is not optimal inside
};
struct OdtReport {
    double energy_before = 0, energy_after = 0;  ///< sum of V S / 20, mm^5; never rises for uniform sizing
    std::size_t moves = 0, flips = 0;
};
/// Moves free vertices to the volume-weighted mean of the circumcentres of their star (Alliez et al. 2005, the exact
/// minimiser for fixed connectivity), backtracking where a tet would invert, and flips (2-3, 3-2, 4-4) where that
/// lowers the energy. Visits only vertices that gain.
OdtReport optimise_odt(TetComplex& complex, const SizingField& sizing, const OdtOptions& options, RunContext& context);

}  // namespace featuremesh

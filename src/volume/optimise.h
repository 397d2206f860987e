// SPDX-License-Identifier: GPL-3.0-or-later
// Variational optimisation (ODT) and removal of slivers by local operations, on connectivity as it is.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/run_context.h"
#include "sizing/sizing_field.h"
#include "volume/tet_complex.h"

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

struct SliverOptions {
    double target_dihedral_deg = 30;
    int passes = 30;              ///< at most; they end when nothing gains any more
    std::vector<int> among{};     ///< only these tets, and what changes on their account; empty: all
    bool is_last_resort = false;  ///< new vertices are tried in more places, at a price in time and mean shape
    std::optional<std::size_t>
        most_refills;  ///< of the dearest operation, tried in vain or not; none: many, more of them for more tets
};
struct SliverReport {
    std::size_t before = 0, left = 0;
    std::size_t forced = 0;   ///< of those left: the worst angle lies between two boundary triangles
    std::size_t refills = 0;  ///< tried, most of them in vain
    std::size_t edge_removals = 0, face_flips = 0, moves = 0, insertions = 0, collapses = 0;
};
/// Worst first; each operation is accepted only if the worst dihedral angle (small and large alike) of its cavity gets
/// better (and, where the target stays out of reach, not at the price of many more bad tets), and planned before
/// anything is changed. Boundary triangles (neighbour -1), boundary edges between them and fixed vertices stay as they
/// are. Free vertices may be inserted (appended to `points`) or collapsed (left without a tet).
SliverReport remove_slivers(TetComplex& complex, const SliverOptions& options, RunContext& context);

struct ShapeOptions {
    double target_dihedral_deg = 30;
    int sweeps = 3;          ///< at most; they end when nothing gains any more
    std::vector<int> among;  ///< only these vertices
    /// What the sum of its star's radius ratios has to gain before a vertex marked 2 is moved; none: it stays.
    std::optional<double> least_gain_of_kept{};
};
struct ShapeReport {
    std::size_t moves = 0;
};
/// Moves free vertices, and where that is asked for others that may be moved, uphill in the sum of the radius ratios of
/// their star, where that makes neither its worst angle nor its bad tets any worse.
ShapeReport optimise_shapes(TetComplex& complex, const ShapeOptions& options, RunContext& context);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// The last resort for tets that hardly have a volume.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "core/run_context.h"
#include "volume/tet_complex.h"

namespace featuremesh {

/// How far a tet is from being too thin: below 1 when its volume is less than `least_volume` (mm^3), or its height
/// about a millionth of its other lengths; not positive without volume.
double thickness(const TetComplex& complex, const std::array<int, 4>& tet, double least_volume);

/// A mesh with such a tet is refused: flat, as the validation of a mesh has it, or with clearly less than this volume,
/// mm^3.
bool is_too_thin(const TetComplex& complex, const std::array<int, 4>& tet, double least_volume);

struct Thickened {
    std::vector<int> left;     ///< tets of a thickness below 1 for which nothing helped, ascending
    std::vector<int> changed;  ///< tets that are new or have a moved corner; some may have gone since
};
/// Tets of a thickness below 1 get rid of it by moves and collapses of free vertices and removals of edges, whatever
/// that does to angles. What costs most, a new vertex, is tried for at most so many tets, and until about so many tets
/// under such vertices have been measured: two to three seconds' work, three times what any part seen needed.
Thickened thicken(TetComplex& complex, double least_volume, RunContext& context,
                  std::size_t most_insertions = std::numeric_limits<std::size_t>::max(),
                  std::size_t most_cones = 150'000'000);

}  // namespace featuremesh

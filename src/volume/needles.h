// SPDX-License-Identifier: GPL-3.0-or-later
// Tets that a short side of the boundary makes flat whatever is done: they must not hide all others beside them.
#pragma once

#include <array>

#include "volume/tet_complex.h"
#include "volume/tet_measures.h"

namespace featuremesh {

/// The side, by its place in edge_corners, that makes a tet with these corners a needle: the boundary has both its
/// ends, and it is shorter than 0.005 of the longest side. -1 for none.
int needle_side(const std::array<Vec3, 4>& corners, const std::array<bool, 4>& is_on_boundary);

/// `flatness` (tet_measures) of a tet with these corners, of which some are on the boundary; of a needle without the
/// angle opposite its short side: no mesh that has both nodes can have one worth speaking of.
double unforced_flatness(double flatness, const std::array<Vec3, 4>& corners,
                         const std::array<bool, 4>& is_on_boundary);

/// No needle is less flat: what the local operations ask first, since few tets are as flat.
inline constexpr double least_flatness_of_needle = 0.97;

/// Needles are not to be excused at vertices for which this is false.
inline bool may_have_needle(const TetComplex& complex, int vertex) {
    return complex.excuses_needles && complex.is_fixed[vertex] == 1;
}
/// Some tet of the complex is excused an angle.
bool has_needle(const TetComplex& complex);

/// The same for corners of a complex.
double unforced_flatness(const TetComplex& complex, const std::array<int, 4>& tet);
/// The tet's worst angle is the one that it is excused.
bool is_excused(const TetComplex& complex, const std::array<int, 4>& tet);

}  // namespace featuremesh

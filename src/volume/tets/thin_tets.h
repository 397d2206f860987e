// SPDX-License-Identifier: GPL-3.0-or-later
// Tets with next to no volume.
#pragma once

#include <algorithm>
#include <array>

#include "core/geometry.h"
#include "volume/tets/tet_complex.h"

namespace featuremesh {

/// Of six volumes against the product of three edges: some way above what the validation of a mesh refuses.
inline constexpr double least_volume_share = 3e-6;

/// A bound for `thickness` without roots, which nearly all tets pass.
inline bool may_be_thin(const std::array<Vec3, 4>& p, double least_volume) {
    const Vec3 u = p[1] - p[0], v = p[2] - p[0], w = p[3] - p[0];
    const double six_volumes = dot(cross(u, v), w), longest = 4 * std::max({dot(u, u), dot(v, v), dot(w, w)});
    return !(six_volumes >= 6 * least_volume &&
             six_volumes * six_volumes >= least_volume_share * least_volume_share * longest * longest * longest);
}

/// How far a tet is from being too thin: below 1 when its volume is less than the least, mm^3, or its height about a
/// millionth of its other lengths; not positive without volume.
double thickness(const std::array<Vec3, 4>& p, double least_volume);

/// As the validation of a mesh has it, which refuses a mesh with such a tet.
bool is_flat(const TetComplex& complex, const std::array<int, 4>& tet);
/// Flat, or with clearly less than this volume, mm^3.
bool is_too_thin(const TetComplex& complex, const std::array<int, 4>& tet, double least_volume);

}  // namespace featuremesh

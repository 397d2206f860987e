// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/tets/thin_tets.h"

#include <cmath>

namespace featuremesh {

double thickness(const std::array<Vec3, 4>& p, double least_volume) {
    const double six_volumes = dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
    const double ab = squared_length(p[1] - p[0]), ac = squared_length(p[2] - p[0]), ad = squared_length(p[3] - p[0]),
                 bc = squared_length(p[2] - p[1]), bd = squared_length(p[3] - p[1]), cd = squared_length(p[3] - p[2]);
    // the largest product of the three edges at a corner
    const double lengths = std::sqrt(std::max({ab * ac * ad, ab * bc * bd, ac * bc * cd, ad * bd * cd}));
    return std::min(six_volumes / (6 * least_volume), six_volumes / (least_volume_share * lengths));
}

bool is_flat(const TetComplex& complex, const std::array<int, 4>& tet) {
    const auto [a, b, c, d] = corners_of(complex, tet);
    const Vec3 u = b - a, v = c - a, w = d - a;
    return !(dot(cross(u, v), w) > 1.01e-6 * length(u) * length(v) * length(w));
}

bool is_too_thin(const TetComplex& complex, const std::array<int, 4>& tet, double least_volume) {
    // tets are mended until they have the least volume; with this share of it they are still no reason to refuse a part
    constexpr double tolerated_share = 0.92;
    const auto [a, b, c, d] = corners_of(complex, tet);
    return is_flat(complex, tet) || signed_volume(a, b, c, d) < tolerated_share * least_volume;
}

}  // namespace featuremesh

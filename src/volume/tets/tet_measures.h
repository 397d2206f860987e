// SPDX-License-Identifier: GPL-3.0-or-later
// What the local operations compare: dihedral angles as cosines, and the ODT energy. No trigonometry in the hot path.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/geometry.h"

namespace featuremesh {

/// The tet has no positive volume; worse than any angle.
inline constexpr double inverted_flatness = 2.0;

/// Largest squared cosine of the six dihedral angles: 1/9 for the regular tet, 1 for a flat one, `inverted_flatness`
/// without volume. It grows as min(smallest angle, 180 deg - largest angle) falls: small and large angles alike.
inline double flatness(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const Vec3 n1 = cross(v, w), n2 = cross(w, u), n3 = cross(u, v);
    if (!(dot(u, n1) > 0)) return inverted_flatness;
    // the four area vectors sum to zero, so all products follow from those of three of them
    const double s1 = dot(n1, n1), s2 = dot(n2, n2), s3 = dot(n3, n3);
    const double d12 = dot(n1, n2), d13 = dot(n1, n3), d23 = dot(n2, n3);
    const double d01 = s1 + d12 + d13, d02 = d12 + s2 + d23, d03 = d13 + d23 + s3;
    const double s0 = d01 + d02 + d03;
    const double r0 = 1 / s0, r1 = 1 / s1, r2 = 1 / s2, r3 = 1 / s3;
    const double m0 = std::max(d01 * d01 * r1, std::max(d02 * d02 * r2, d03 * d03 * r3)) * r0;
    const double m1 = std::max(d12 * d12 * r2, d13 * d13 * r3) * r1;
    return std::max(std::max(m0, m1), d23 * d23 * r2 * r3);
}

/// The flatness of a tet whose worst angle is this (or 180 degrees minus it).
inline double flatness_of_angle(double degrees) {
    const double cosine = std::cos(degrees * (3.14159265358979323846 / 180));
    return cosine * cosine;
}

/// What an optimiser aims at for a smallest angle: a little more, so that rounding does not leave a tet a hair below.
inline double flatness_to_reach(double degrees) {
    constexpr double margin = 1e-4;
    return flatness_of_angle(degrees + margin);
}

/// The worst angle, degrees, of a tet of this flatness.
inline double angle_of_flatness(double value) {
    return value > 1 ? 0.0 : std::acos(std::sqrt(value)) * (180 / 3.14159265358979323846);
}

/// 12 V times the vector from the first corner to the circumcentre, and 6 V.
struct Circumsphere {
    Circumsphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        const Vec3 u = b - a, v = c - a, w = d - a;
        const Vec3 vw = cross(v, w);
        six_volumes = dot(u, vw);
        scaled = squared_length(u) * vw + squared_length(v) * cross(w, u) + squared_length(w) * cross(u, v);
    }
    Vec3 scaled;
    double six_volumes;
};

/// ODT energy of a tet, V S / 20 with S the sum of the six squared edge lengths (Alliez et al. 2005), mm^5. Negative
/// volumes give negative values.
inline double odt_energy(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const double squares = 3 * (dot(u, u) + dot(v, v) + dot(w, w)) - 2 * (dot(u, v) + dot(v, w) + dot(w, u));
    return dot(u, cross(v, w)) * squares / 120;
}

}  // namespace featuremesh

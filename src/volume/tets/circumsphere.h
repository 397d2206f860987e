// SPDX-License-Identifier: GPL-3.0-or-later
// The sphere through the corners of a tet.
#pragma once

#include "core/geometry.h"

namespace featuremesh {

struct Ball {
    Vec3 center;
    double radius = 0;
};

/// Not exact: use it to keep points away, not to decide topology. An infinite or undefined radius for a flat tet.
inline Ball circumsphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const Vec3 vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
    const Vec3 offset = (squared_length(u) * vw + squared_length(v) * wu + squared_length(w) * uv) / (2 * dot(u, vw));
    return {a + offset, length(offset)};
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Squared distances of a point, mm^2; also to triangles without area.
#pragma once

#include <algorithm>
#include <array>

#include "core/geometry.h"

namespace featuremesh {

inline double squared_distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const double l2 = squared_length(ab);
    const double t = l2 > 0 ? std::clamp(dot(p - a, ab) / l2, 0.0, 1.0) : 0.0;
    return squared_length(p - (a + ab * t));
}

/// To the plane of the triangle when the foot is inside, else to the nearest side.
inline double squared_distance_to_triangle(const Vec3& p, const std::array<Vec3, 3>& t) {
    const auto& [a, b, c] = t;
    const Vec3 normal = cross(b - a, c - a);
    const double area2 = squared_length(normal);
    const bool inside = area2 > 0 && dot(cross(b - a, p - a), normal) >= 0 && dot(cross(c - b, p - b), normal) >= 0 &&
                        dot(cross(a - c, p - c), normal) >= 0;
    if (inside) {
        const double along = dot(p - a, normal);
        return along * along / area2;
    }
    return std::min({squared_distance_to_segment(p, a, b), squared_distance_to_segment(p, b, c),
                     squared_distance_to_segment(p, c, a)});
}

}  // namespace featuremesh

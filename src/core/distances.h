// SPDX-License-Identifier: GPL-3.0-or-later
// Squared distances of a point, mm^2.
#pragma once

#include <algorithm>
#include <array>

#include "core/geometry.h"

namespace featuremesh {

/// 0 within the box.
inline double squared_distance_to_box(const Vec3& p, const Box& box) {
    const auto outside = [](double x, double low, double high) { return std::max(std::max(low - x, x - high), 0.0); };
    return squared_length({outside(p.x, box.low.x, box.high.x), outside(p.y, box.low.y, box.high.y),
                           outside(p.z, box.low.z, box.high.z)});
}

/// Also where both ends are one point.
inline double squared_distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const double l2 = squared_length(ab);
    const double t = l2 > 0 ? std::clamp(dot(p - a, ab) / l2, 0.0, 1.0) : 0.0;
    return squared_length(p - (a + ab * t));
}

/// The point of a triangle that is nearest to another.
struct NearestInTriangle {
    std::array<double, 3> weights;  ///< its barycentric coordinates
    double squared_distance;
};

/// By the Voronoi regions of the triangle's corners, sides and inside [Ericson2005] (5.1.5); their borders are told
/// apart by products with the normal, so that a triangle without area is taken as its sides.
inline NearestInTriangle nearest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double ab_a = dot(ab, ap), ac_a = dot(ac, ap);
    if (ab_a <= 0 && ac_a <= 0) return {{1, 0, 0}, squared_length(ap)};
    const Vec3 bp = p - b;
    const double ab_b = dot(ab, bp), ac_b = dot(ac, bp);
    if (ab_b >= 0 && ac_b <= ab_b) return {{0, 1, 0}, squared_length(bp)};
    const Vec3 cp = p - c;
    const double ab_c = dot(ab, cp), ac_c = dot(ac, cp);
    if (ac_c >= 0 && ab_c <= ac_c) return {{0, 0, 1}, squared_length(cp)};
    const Vec3 normal = cross(ab, ac);
    const double over_c = dot(normal, cross(ap, bp));
    if (over_c <= 0 && ab_a > 0 && ab_b < 0) {
        const double share = ab_a / (ab_a - ab_b);
        return {{1 - share, share, 0}, squared_length(ap - ab * share)};
    }
    const double over_b = dot(normal, cross(cp, ap));
    if (over_b <= 0 && ac_a > 0 && ac_c < 0) {
        const double share = ac_a / (ac_a - ac_c);
        return {{1 - share, 0, share}, squared_length(ap - ac * share)};
    }
    const double over_a = dot(normal, cross(bp, cp)), to_b = ac_b - ab_b, to_c = ab_c - ac_c;
    if (over_a <= 0 && to_b > 0 && to_c > 0) {
        const double share = to_b / (to_b + to_c);
        return {{0, 1 - share, share}, squared_length(bp - (c - b) * share)};
    }
    const double squared_area = squared_length(normal), along = dot(ap, normal);
    return {{over_a / squared_area, over_b / squared_area, over_c / squared_area}, along * along / squared_area};
}

inline double squared_distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    return nearest_in_triangle(p, a, b, c).squared_distance;
}

}  // namespace featuremesh

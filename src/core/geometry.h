// SPDX-License-Identifier: GPL-3.0-or-later
// Points, boxes and rigid motions. Lengths in mm.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace featuremesh {

/// A point or a vector in space, mm.
struct Vec3 {
    double x = 0, y = 0, z = 0;
    constexpr double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
    constexpr bool operator==(const Vec3&) const = default;
    constexpr Vec3& operator+=(const Vec3& b) { return x += b.x, y += b.y, z += b.z, *this; }
    constexpr Vec3& operator-=(const Vec3& b) { return x -= b.x, y -= b.y, z -= b.z, *this; }
    constexpr Vec3& operator*=(double s) { return x *= s, y *= s, z *= s, *this; }
};

constexpr Vec3 operator+(Vec3 a, const Vec3& b) { return a += b; }
constexpr Vec3 operator-(Vec3 a, const Vec3& b) { return a -= b; }
constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Vec3 a, double s) { return a *= s; }
constexpr Vec3 operator*(double s, Vec3 a) { return a *= s; }
constexpr Vec3 operator/(const Vec3& a, double s) { return {a.x / s, a.y / s, a.z / s}; }
constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double squared_length(const Vec3& a) { return dot(a, a); }
inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }
inline double distance(const Vec3& a, const Vec3& b) { return length(a - b); }
inline Vec3 normalized(const Vec3& a) {
    const double l = length(a);
    return l > 0 ? a / l : a;
}

/// Of the tet (a, b, c, d); positive where d is on the side that (b-a)x(c-a) points to.
constexpr double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return dot(cross(b - a, c - a), d - a) / 6.0;
}

/// Axis-aligned box; empty (low > high) until something is added.
struct Box {
    Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
    Vec3 high = -low;

    bool is_empty() const { return low.x > high.x; }
    void add(const Vec3& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    void add(const Box& b) {
        if (!b.is_empty()) add(b.low), add(b.high);
    }
    Box grown(double margin) const {
        Box b = *this;
        b.low -= {margin, margin, margin};
        b.high += {margin, margin, margin};
        return b;
    }
    bool contains(const Vec3& p) const {
        return p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y && p.z <= high.z;
    }
    bool overlaps(const Box& b) const {
        return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y && low.z <= b.high.z &&
               b.low.z <= high.z;
    }
    bool is_close_to(const Box& b, double tolerance) const {
        return length(low - b.low) < tolerance && length(high - b.high) < tolerance;
    }
    Vec3 center() const { return (low + high) * 0.5; }
    Vec3 size() const { return high - low; }
    double diagonal() const { return is_empty() ? 0.0 : length(size()); }
};

/// x -> R x + t with R a rotation, row by row. The identity maps a point to the same bits.
struct RigidMotion {
    std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};
    Vec3 translation{};

    bool operator==(const RigidMotion&) const = default;
    bool is_identity() const { return *this == RigidMotion{}; }
    Vec3 rotate(const Vec3& v) const {
        const auto& r = rotation;
        return {r[0] * v.x + r[1] * v.y + r[2] * v.z, r[3] * v.x + r[4] * v.y + r[5] * v.z,
                r[6] * v.x + r[7] * v.y + r[8] * v.z};
    }
    Vec3 apply(const Vec3& p) const { return is_identity() ? p : rotate(p) + translation; }
    RigidMotion inverse() const {
        const auto& r = rotation;
        RigidMotion inv;
        inv.rotation = {r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]};
        inv.translation = -inv.rotate(translation);
        return inv;
    }
};

/// First `inner`, then `outer`.
inline RigidMotion compose(const RigidMotion& outer, const RigidMotion& inner) {
    RigidMotion m;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            m.rotation[3 * i + j] = 0;
            for (int k = 0; k < 3; ++k) m.rotation[3 * i + j] += outer.rotation[3 * i + k] * inner.rotation[3 * k + j];
        }
    m.translation = outer.rotate(inner.translation) + outer.translation;
    return m;
}

}  // namespace featuremesh

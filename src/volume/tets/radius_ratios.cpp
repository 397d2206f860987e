// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/tets/radius_ratios.h"

#include <cmath>

namespace featuremesh {

namespace {

/// Two numbers at a time, each as if it were alone.
typedef double Two __attribute__((vector_size(2 * sizeof(double))));

struct TwoVecs {
    Two x, y, z;
    Vec3 operator[](int i) const { return {x[i], y[i], z[i]}; }
};

TwoVecs both(const Vec3& a, const Vec3& b) { return {Two{a.x, b.x}, Two{a.y, b.y}, Two{a.z, b.z}}; }
TwoVecs operator+(const TwoVecs& a, const TwoVecs& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
TwoVecs operator-(const TwoVecs& a, const TwoVecs& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
TwoVecs operator*(const Two& s, const TwoVecs& a) { return {a.x * s, a.y * s, a.z * s}; }
TwoVecs operator/(const TwoVecs& a, const Two& s) { return {a.x / s, a.y / s, a.z / s}; }
Two dot(const TwoVecs& a, const TwoVecs& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
TwoVecs cross(const TwoVecs& a, const TwoVecs& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Two squared_length(const TwoVecs& a) { return dot(a, a); }
Two root(const Two& a) { return Two{std::sqrt(a[0]), std::sqrt(a[1])}; }
Two length(const TwoVecs& a) { return root(dot(a, a)); }

/// What the radius ratios 3 r / R = 6 (6 V)^2 / (2 A |12 V c|) of two tets (point, f) are made of, with A the surface
/// and c the way from f[0] to the circumcentre.
struct RatioParts {
    RatioParts(const TwoVecs& point, const std::array<TwoVecs, 3>& f)
        : u(f[2] - f[0]),
          v(f[1] - f[0]),
          w(point - f[0]),
          base(cross(u, v)),
          n1(cross(v, w)),
          n2(cross(w, u)),
          n3(cross(v - u, w - u)),
          six_volumes(dot(base, w)) {
        l1 = length(n1), l2 = length(n2), l3 = length(n3), surface = length(base) + l1 + l2 + l3;
        sphere = squared_length(u) * n1 + squared_length(v) * n2 + squared_length(w) * base;
        squared = squared_length(sphere);
    }
    /// 0 without volume.
    Two ratios() const {
        const Two all = 6 * six_volumes * six_volumes / (surface * root(squared));
        return Two{six_volumes[0] > 0 ? all[0] : 0, six_volumes[1] > 0 ? all[1] : 0};
    }
    /// Of the ratios' logarithms, for the point.
    TwoVecs gradients() const {
        const TwoVecs of_surface = cross(n1, v) / l1 + cross(u, n2) / l2 + cross(n3, v - u) / l3;
        const TwoVecs of_sphere =
            squared_length(u) * cross(sphere, v) + squared_length(v) * cross(u, sphere) + 2 * dot(sphere, base) * w;
        return 2 / six_volumes * base - of_surface / surface - of_sphere / squared;
    }

    TwoVecs u, v, w, base, n1, n2, n3;
    Two six_volumes;
    Two l1, l2, l3, surface, squared;
    TwoVecs sphere;
};

/// Calls visit(parts, count) for the triangles in turn, two at a time; `count` is 1 for the last of an odd number.
template <class Visit>
void visit_ratio_parts(const Vec3& point, std::span<const SeenTriangle> triangles, const Visit& visit) {
    const TwoVecs points = both(point, point);
    for (std::size_t i = 0; i < triangles.size(); i += 2) {
        const bool is_last = i + 1 == triangles.size();
        const auto &a = triangles[i].corners, &b = triangles[is_last ? i : i + 1].corners;
        visit(RatioParts(points, {both(a[0], b[0]), both(a[1], b[1]), both(a[2], b[2])}), is_last ? 1 : 2);
    }
}

}  // namespace

RadiusRatios radius_ratios(const Vec3& point, std::span<const SeenTriangle> triangles) {
    RadiusRatios found;
    visit_ratio_parts(point, triangles, [&](const RatioParts& parts, int count) {
        const Two ratios = parts.ratios();
        const TwoVecs gradients = parts.gradients();
        for (int k = 0; k < count; ++k) {
            if (!(ratios[k] > 0)) continue;
            found.sum += ratios[k];
            found.gradient += ratios[k] * gradients[k];
        }
    });
    return found;
}

double sum_of_radius_ratios(const Vec3& point, std::span<const SeenTriangle> triangles) {
    double sum = 0;
    visit_ratio_parts(point, triangles, [&](const RatioParts& parts, int count) {
        const Two ratios = parts.ratios();
        for (int k = 0; k < count; ++k) sum += ratios[k];
    });
    return sum;
}

}  // namespace featuremesh

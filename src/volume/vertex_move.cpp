// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/vertex_move.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "volume/needles.h"
#include "volume/tet_measures.h"
#include "volume/tet_topology.h"

namespace featuremesh {

namespace {

constexpr int direction_count = 24;

/// Directions spread evenly over the sphere (Fibonacci lattice).
const std::array<Vec3, direction_count>& directions() {
    static const auto spread = [] {
        std::array<Vec3, direction_count> made;
        const double golden = 2.39996322972865332;
        for (int i = 0; i < direction_count; ++i) {
            const double z = 1 - (2 * i + 1.0) / direction_count, r = std::sqrt(1 - z * z);
            made[i] = {r * std::cos(golden * i), r * std::sin(golden * i), z};
        }
        return made;
    }();
    return spread;
}

/// What the radius ratio 3 r / R = 6 (6 V)^2 / (2 A |12 V c|) of the tet (point, f) is made of, with A its surface and
/// c the way from f[0] to its circumcentre.
struct RatioParts {
    RatioParts(const Vec3& point, const std::array<Vec3, 3>& f)
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
    double ratio() const {
        return six_volumes > 0 ? 6 * six_volumes * six_volumes / (surface * std::sqrt(squared)) : 0;
    }
    /// Of the ratio's logarithm, for the point.
    Vec3 gradient() const {
        const Vec3 of_surface = cross(n1, v) / l1 + cross(u, n2) / l2 + cross(n3, v - u) / l3;
        const Vec3 of_sphere =
            squared_length(u) * cross(sphere, v) + squared_length(v) * cross(u, sphere) + 2 * dot(sphere, base) * w;
        return 2 / six_volumes * base - of_surface / surface - of_sphere / squared;
    }

    Vec3 u, v, w, base, n1, n2, n3;
    double six_volumes;
    double l1, l2, l3, surface, squared;
    Vec3 sphere;
};

}  // namespace

void StarShape::gather(const TetComplex& complex, std::span<const int> star, int vertex) {
    const auto is_outside = [&](int v) { return may_have_needle(complex, v); };
    faces_.clear();
    set_on_boundary(is_outside(vertex));
    for (int tet : star) {
        const Tet& v = complex.tets[tet];
        const auto& face = opposite_face[corner_of(v, vertex)];
        const int a = v[face[0]], b = v[face[1]], c = v[face[2]];
        add(complex.points[a], complex.points[b], complex.points[c], {is_outside(a), is_outside(b), is_outside(c)});
    }
}

double StarShape::flatness_at(const Vec3& point, const Face& face) const {
    const auto& [a, b, c] = face.corners;
    const double all = flatness(point, a, b, c);
    if (all < least_flatness_of_needle || all == inverted_flatness) return all;
    return unforced_flatness({point, a, b, c},
                             {is_on_boundary_, face.is_on_boundary[0], face.is_on_boundary[1], face.is_on_boundary[2]});
}

double StarShape::worst(const Vec3& point, double limit) const {
    double result = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        const auto& f = faces_[i];
        const double value = flatness_at(point, f);
        if (value <= result) continue;
        result = value;
        if (value < limit) continue;
        if (i > 0) std::swap(faces_[i], faces_[0]);
        return value;
    }
    return result;
}

double StarShape::burden(const Vec3& point, double target) const {
    double sum = 0;
    for (const auto& f : faces_) sum += featuremesh::burden(flatness_at(point, f), target);
    return sum;
}

double StarShape::steep_burden(const Vec3& point, double target) const {
    double sum = 0;
    for (const auto& f : faces_)
        if (const double value = flatness_at(point, f); value > target)
            sum += 1 / std::max(1e-6, 1 - value) - 1 / (1 - target);
    return sum;
}

StarShape::Ratios StarShape::radius_ratios(const Vec3& point) const {
    Ratios ratios;
    for (const auto& f : faces_) {
        const RatioParts parts(point, f.corners);
        const double ratio = parts.ratio();
        if (!(ratio > 0)) continue;
        ratios.sum += ratio;
        ratios.gradient += ratio * parts.gradient();
    }
    return ratios;
}

double StarShape::sum_of_radius_ratios(const Vec3& point) const {
    double sum = 0;
    for (const auto& f : faces_) sum += RatioParts(point, f.corners).ratio();
    return sum;
}

double StarShape::mean_height(const Vec3& point) const {
    double sum = 0;
    for (const auto& f : faces_) sum += distance(point, f.corners[0]);
    return sum / static_cast<double>(std::max<std::size_t>(1, faces_.size()));
}

double StarShape::climb(Vec3& point, double good_enough) const {
    double best = worst(point, 2 * inverted_flatness);
    const double start_step = 0.2 * mean_height(point);
    for (double step = start_step; step > 0.02 * start_step && best > good_enough;) {
        bool gained = false;
        for (const Vec3& direction : directions()) {
            const Vec3 trial = point + step * direction;
            const double value = worst(trial, best);
            if (value >= best) continue;
            best = value;
            point = trial;
            gained = true;
        }
        if (!gained) step *= 0.5;
    }
    return best;
}

}  // namespace featuremesh

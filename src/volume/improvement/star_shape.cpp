// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/improvement/star_shape.h"

#include <utility>

#include "volume/tets/tet_topology.h"

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

/// Calls visit(parts, count) for the faces in turn, two at a time; `count` is 1 for the last of an odd number.
template <class Faces, class Visit>
void visit_ratio_parts(const Vec3& point, const Faces& faces, Visit visit) {
    const TwoVecs points = both(point, point);
    for (std::size_t i = 0; i < faces.size(); i += 2) {
        const bool is_last = i + 1 == faces.size();
        const auto &a = faces[i].corners, &b = faces[is_last ? i : i + 1].corners;
        visit(RatioParts(points, {both(a[0], b[0]), both(a[1], b[1]), both(a[2], b[2])}), is_last ? 1 : 2);
    }
}

}  // namespace

std::span<const Vec3> directions_in_space() { return directions(); }

void StarShape::gather(const TetComplex& complex, std::span<const int> star, int vertex) {
    const auto is_outside = [&](int v) { return is_on_boundary(complex.mobility[static_cast<std::size_t>(v)]); };
    clear(is_outside(vertex));
    for (const int t : star) {
        const Tet& v = complex.tets[t];
        const auto& face = opposite_face[corner_of(v, vertex)];
        const int a = v[face[0]], b = v[face[1]], c = v[face[2]];
        add(complex.points[a], complex.points[b], complex.points[c], {is_outside(a), is_outside(b), is_outside(c)});
    }
}

double StarShape::worst(const Vec3& point, double limit) const {
    double result = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        const double flaw = flaw_at(point, faces_[i]);
        if (flaw <= result) continue;
        result = flaw;
        if (flaw < limit) continue;
        if (i > 0) std::swap(faces_[i], faces_[0]);
        evaluations_ += i + 1;
        return flaw;
    }
    evaluations_ += faces_.size();
    return result;
}

Value StarShape::value(const Vec3& point) const {
    Value sum{.shape = sum_of_radius_ratios(point), .count = static_cast<double>(faces_.size())};
    for (const Face& face : faces_) {
        const double flaw = flaw_at(point, face);
        sum.worst = std::max(sum.worst, flaw);
        sum.penalty += objective_.penalty(flaw);
    }
    return sum;
}

StarShape::Ratios StarShape::radius_ratios(const Vec3& point) const {
    Ratios found;
    visit_ratio_parts(point, faces_, [&](const RatioParts& parts, int count) {
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

double StarShape::sum_of_radius_ratios(const Vec3& point) const {
    double sum = 0;
    visit_ratio_parts(point, faces_, [&](const RatioParts& parts, int count) {
        const Two ratios = parts.ratios();
        for (int k = 0; k < count; ++k) sum += ratios[k];
    });
    return sum;
}

double StarShape::mean_height(const Vec3& point) const {
    double sum = 0;
    for (const auto& f : faces_) sum += distance(point, f.corners[0]);
    return sum / static_cast<double>(std::max<std::size_t>(1, faces_.size()));
}

Vec3 StarShape::middle() const {
    Vec3 sum{};
    for (const auto& f : faces_) sum += f.corners[0] + f.corners[1] + f.corners[2];
    return sum / static_cast<double>(std::max<std::size_t>(1, 3 * faces_.size()));
}

double StarShape::climb(Vec3& point, double good_enough) const {
    return climb(point, good_enough, directions(), [](const Vec3&) { return true; });
}

}  // namespace featuremesh

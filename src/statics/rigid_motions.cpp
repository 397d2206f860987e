// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/rigid_motions.h"

#include <algorithm>
#include <cmath>

namespace featuremesh {

namespace {

constexpr std::size_t count = RigidMotions::count;
constexpr std::array<Vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
/// Of what a motion is resisted by itself.
constexpr double least_pivot = 1e-9;

}  // namespace

RigidMotions::RigidMotions(std::span<const Vec3> points) {
    for (const Vec3& point : points) middle_ += point / double(points.size());
    for (const Vec3& point : points) radius_ = std::max(radius_, distance(point, middle_));
    if (radius_ == 0) radius_ = 1;
}

RigidMotions::Six RigidMotions::along(int axis, const Vec3& point) const {
    Six motions{};
    const Vec3 p = place(point);
    for (std::size_t about = 0; about < 3; ++about) {
        motions[about] = axes[about][axis];
        motions[about + 3] = cross(axes[about], p)[axis];
    }
    return motions;
}

Vec3 RigidMotions::moved(const Six& by, const Vec3& point) const {
    return Vec3{by[0], by[1], by[2]} + cross(Vec3{by[3], by[4], by[5]}, place(point));
}

void RigidMotions::add_force(const Vec3& force, const Vec3& point, Six& sums) const {
    const Vec3 moment = cross(place(point), force);
    for (int c = 0; c < 3; ++c) sums[std::size_t(c)] += force[c], sums[std::size_t(c) + 3] += moment[c];
}

SixFactor::SixFactor(const Square& matrix) {
    for (std::size_t j = 0; j < count; ++j) {
        double pivot = matrix[j][j];
        for (std::size_t k = 0; k < j; ++k) pivot -= factor_[j][k] * factor_[j][k];
        if (!(pivot > least_pivot * matrix[j][j])) continue;
        factor_[j][j] = std::sqrt(pivot);
        for (std::size_t i = j + 1; i < count; ++i) {
            double sum = matrix[i][j];
            for (std::size_t k = 0; k < j; ++k) sum -= factor_[i][k] * factor_[j][k];
            factor_[i][j] = sum / factor_[j][j];
        }
    }
}

RigidMotions::Six SixFactor::solve(Six right) const {
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < i; ++k) right[i] -= factor_[i][k] * right[k];
        right[i] = factor_[i][i] > 0 ? right[i] / factor_[i][i] : 0;
    }
    for (std::size_t i = count; i-- > 0;) {
        for (std::size_t k = i + 1; k < count; ++k) right[i] -= factor_[k][i] * right[k];
        right[i] = factor_[i][i] > 0 ? right[i] / factor_[i][i] : 0;
    }
    return right;
}

}  // namespace featuremesh

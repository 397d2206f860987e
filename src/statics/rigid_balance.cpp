// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/rigid_balance.h"

#include <algorithm>
#include <cmath>

#include "core/geometry.h"

namespace featuremesh {

namespace {

constexpr std::size_t grain = 4096;  // nodes
/// A motion that is resisted less than this, as a share of what each is by itself, is one of the others.
constexpr double least_pivot = 1e-9;

bool is_held(const StaticsModel& model, std::size_t node) {
    return model.is_held[3 * node] || model.is_held[3 * node + 1] || model.is_held[3 * node + 2];
}

}  // namespace

RigidBalance::RigidBalance(const StaticsModel& model, const BlockMatrix& matrix, RunContext& context) : model_(model) {
    const std::size_t nodes = matrix.node_count();
    for (const Vec3& point : model.mesh.points) middle_ += point / double(nodes);
    for (const Vec3& point : model.mesh.points) radius_ = std::max(radius_, distance(point, middle_));
    std::vector<std::vector<Resisted>> of_chunk(nodes / grain + 1);
    parallel_for(context, nodes, grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node) {
            const std::size_t first = matrix.begin(node), last = matrix.end(node);
            const auto is_beside = [&](std::int32_t other) { return is_held(model, std::size_t(other)); };
            if (std::none_of(matrix.neighbours.begin() + std::ptrdiff_t(first),
                             matrix.neighbours.begin() + std::ptrdiff_t(last), is_beside))
                continue;
            for (std::size_t r = 0; r < 3; ++r) {
                Resisted resisted{3 * node + r, {}};
                if (model.is_held[resisted.component]) continue;
                const double* value = matrix.values.data() + matrix.place(node, first) + r * matrix.width(node);
                for (std::size_t k = first; k < last; ++k)
                    for (std::size_t c = 0; c < 3; ++c, ++value) {
                        const Motions motions = at(3 * std::size_t(matrix.neighbours[k]) + c);
                        for (std::size_t i = 0; i < count; ++i) resisted.by[i] += *value * motions[i];
                    }
                of_chunk[begin / grain].push_back(resisted);
            }
        }
    });
    Square stiffness{};
    for (const auto& chunk : of_chunk)
        for (const Resisted& resisted : chunk) {
            const Motions motions = at(resisted.component);
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t j = 0; j < count; ++j) stiffness[i][j] += motions[i] * resisted.by[j];
            resisted_.push_back(resisted);
        }
    factor(stiffness);
}

/// From the middle, in radii.
Vec3 RigidBalance::place(std::size_t node) const { return (model_.mesh.points[node] - middle_) / radius_; }

/// How far each motion moves a component; held ones stay.
RigidBalance::Motions RigidBalance::at(std::size_t component) const {
    Motions motions{};
    if (model_.is_held[component]) return motions;
    const int c = int(component % 3);
    const Vec3 p = place(component / 3);
    const std::array<Vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        motions[axis] = axes[axis][c];
        motions[axis + 3] = cross(axes[axis], p)[c];
    }
    return motions;
}

void RigidBalance::factor(Square stiffness) {
    for (std::size_t j = 0; j < count; ++j) {
        double pivot = stiffness[j][j];
        for (std::size_t k = 0; k < j; ++k) pivot -= factor_[j][k] * factor_[j][k];
        if (!(pivot > least_pivot * stiffness[j][j])) continue;
        factor_[j][j] = std::sqrt(pivot);
        for (std::size_t i = j + 1; i < count; ++i) {
            double sum = stiffness[i][j];
            for (std::size_t k = 0; k < j; ++k) sum -= factor_[i][k] * factor_[j][k];
            factor_[i][j] = sum / factor_[j][j];
        }
    }
}

RigidBalance::Motions RigidBalance::solve(Motions forces) const {
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < i; ++k) forces[i] -= factor_[i][k] * forces[k];
        forces[i] = factor_[i][i] > 0 ? forces[i] / factor_[i][i] : 0;
    }
    for (std::size_t i = count; i-- > 0;) {
        for (std::size_t k = i + 1; k < count; ++k) forces[i] -= factor_[k][i] * forces[k];
        forces[i] = factor_[i][i] > 0 ? forces[i] / factor_[i][i] : 0;
    }
    return forces;
}

void RigidBalance::correct(std::span<const double> forces, std::span<double> moved) const {
    const auto vector_at = [](const auto& of, std::size_t i) { return Vec3{of[i], of[i + 1], of[i + 2]}; };
    Vec3 force, moment;
    for (std::size_t node = 0; node < forces.size() / 3; ++node) {
        const Vec3 here = vector_at(forces, 3 * node);
        force += here, moment += cross(place(node), here);
    }
    Motions left{force.x, force.y, force.z, moment.x, moment.y, moment.z};
    for (const Resisted& resisted : resisted_)
        for (std::size_t i = 0; i < count; ++i) left[i] -= resisted.by[i] * moved[resisted.component];
    const Motions by = solve(left);
    for (std::size_t node = 0; node < forces.size() / 3; ++node) {
        const Vec3 step = vector_at(by, 0) + cross(vector_at(by, 3), place(node));
        for (int c = 0; c < 3; ++c)
            if (!model_.is_held[3 * node + std::size_t(c)]) moved[3 * node + std::size_t(c)] += step[c];
    }
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/rigid_balance.h"

#include <algorithm>

#include "core/geometry.h"

namespace featuremesh {

namespace {

constexpr std::size_t grain = 4096;  // nodes

bool is_held(const StaticsModel& model, std::size_t node) {
    return model.is_held[3 * node] || model.is_held[3 * node + 1] || model.is_held[3 * node + 2];
}

}  // namespace

RigidBalance::RigidBalance(const StaticsModel& model, const BlockMatrix& matrix, RunContext& context)
    : model_(model), motions_(model.mesh.points) {
    const std::size_t nodes = matrix.node_count();
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
                        const Six motions = at(3 * std::size_t(matrix.neighbours[k]) + c);
                        for (std::size_t i = 0; i < RigidMotions::count; ++i) resisted.by[i] += *value * motions[i];
                    }
                of_chunk[begin / grain].push_back(resisted);
            }
        }
    });
    SixFactor::Square stiffness{};
    for (const auto& chunk : of_chunk)
        for (const Resisted& resisted : chunk) {
            const Six motions = at(resisted.component);
            for (std::size_t i = 0; i < RigidMotions::count; ++i)
                for (std::size_t j = 0; j < RigidMotions::count; ++j) stiffness[i][j] += motions[i] * resisted.by[j];
            resisted_.push_back(resisted);
        }
    factor_ = SixFactor(stiffness);
}

/// How far each motion moves a component; held ones stay.
RigidMotions::Six RigidBalance::at(std::size_t component) const {
    if (model_.is_held[component]) return {};
    return motions_.along(int(component % 3), model_.mesh.points[component / 3]);
}

void RigidBalance::correct(std::span<const double> forces, std::span<double> moved) const {
    Six left{};
    for (std::size_t node = 0; node < forces.size() / 3; ++node)
        motions_.add_force({forces[3 * node], forces[3 * node + 1], forces[3 * node + 2]}, model_.mesh.points[node],
                           left);
    for (const Resisted& resisted : resisted_)
        for (std::size_t i = 0; i < RigidMotions::count; ++i) left[i] -= resisted.by[i] * moved[resisted.component];
    const Six by = factor_.solve(left);
    for (std::size_t node = 0; node < forces.size() / 3; ++node) {
        const Vec3 step = motions_.moved(by, model_.mesh.points[node]);
        for (int c = 0; c < 3; ++c)
            if (!model_.is_held[3 * node + std::size_t(c)]) moved[3 * node + std::size_t(c)] += step[c];
    }
}

}  // namespace featuremesh

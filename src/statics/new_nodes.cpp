// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/new_nodes.h"

#include <algorithm>

#include "core/geometry.h"
#include "statics/rigid_motions.h"

namespace featuremesh {

namespace {

Vec3 vector_at(std::span<const double> of, std::int32_t node) {
    const double* v = of.data() + 3 * std::size_t(node);
    return {v[0], v[1], v[2]};
}

/// The motion by which the sum of squares of what these nodes are displaced beside it is least.
RigidMotions::Six closest(const RigidMotions& motions, const std::vector<std::int32_t>& nodes,
                          const std::vector<Vec3>& points, std::span<const double> moved) {
    SixFactor::Square square{};
    RigidMotions::Six right{};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Vec3 by = vector_at(moved, nodes[i]);
        motions.add_force(by, points[i], right);
        for (int axis = 0; axis < 3; ++axis) {
            const RigidMotions::Six along = motions.along(axis, points[i]);
            for (std::size_t a = 0; a < along.size(); ++a)
                for (std::size_t b = 0; b < along.size(); ++b) square[a][b] += along[a] * along[b];
        }
    }
    return SixFactor(square).solve(right);
}

}  // namespace

std::vector<std::int32_t> with_neighbours(std::vector<std::int32_t> nodes, const BlockMatrix& matrix, int layers,
                                          std::size_t enough) {
    std::vector<char> is_in(matrix.node_count(), 0);
    for (const std::int32_t node : nodes) is_in[std::size_t(node)] = 1;
    std::size_t first = 0;
    do {
        const std::size_t count = nodes.size();
        for (; first < count; ++first) {
            const auto node = std::size_t(nodes[first]);
            for (std::size_t k = matrix.begin(node); k < matrix.end(node); ++k)
                if (char& is_other_in = is_in[std::size_t(matrix.neighbours[k])]; !is_other_in)
                    is_other_in = 1, nodes.push_back(matrix.neighbours[k]);
        }
    } while (--layers > 0 && first < nodes.size() && nodes.size() < enough);
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

void move_with_kept(const StaticsModel& model, const BlockMatrix& matrix, std::span<const std::int32_t> fresh,
                    std::span<double> moved) {
    enum State : char { kept, is_new, taken };
    std::vector<State> state(matrix.node_count(), kept);
    for (const std::int32_t node : fresh) state[std::size_t(node)] = is_new;
    for (const std::int32_t seed : fresh) {
        if (state[std::size_t(seed)] != is_new) continue;
        std::vector<std::int32_t> together{seed}, beside;
        state[std::size_t(seed)] = taken;
        for (std::size_t i = 0; i < together.size(); ++i) {
            const auto node = std::size_t(together[i]);
            for (std::size_t k = matrix.begin(node); k < matrix.end(node); ++k) {
                const std::int32_t other = matrix.neighbours[k];
                if (state[std::size_t(other)] == kept) beside.push_back(other);
                if (state[std::size_t(other)] != is_new) continue;
                state[std::size_t(other)] = taken;
                together.push_back(other);
            }
        }
        std::sort(beside.begin(), beside.end());
        beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
        if (beside.empty()) continue;
        std::vector<Vec3> points;
        for (const std::int32_t node : beside) points.push_back(model.mesh.points[std::size_t(node)]);
        const RigidMotions motions(points);
        const RigidMotions::Six by = closest(motions, beside, points, moved);
        for (const std::int32_t node : together) {
            const Vec3 step = motions.moved(by, model.mesh.points[std::size_t(node)]);
            for (std::size_t c = 0; c < 3; ++c)
                if (const std::size_t i = 3 * std::size_t(node) + c; !model.is_held[i]) moved[i] = step[int(c)];
        }
    }
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/stiffness.h"

#include <algorithm>
#include <span>

#include "core/geometry.h"
#include "core/ids.h"
#include "statics/elements.h"

namespace featuremesh {

namespace {

constexpr std::size_t grain = 1024;

template <class Visit>
void for_each_node(const Mesh& mesh, std::size_t tet, Visit visit) {
    for (const NodeId node : mesh.tets[tet]) visit(node);
    if (mesh.order == 2)
        for (const NodeId node : mesh.tet_mids[tet]) visit(node);
}

bool is_same(const SameRows* same, std::size_t node) { return same && same->row[node] >= 0; }

void copy_neighbours(const SameRows& same, std::size_t node, std::vector<std::int32_t>& found) {
    const auto row = std::size_t(same.row[node]);
    const auto first = std::ptrdiff_t(found.size());
    for (auto k = same.matrix.starts[row]; k < same.matrix.starts[row + 1]; ++k)
        found.push_back(same.node_now[std::size_t(same.matrix.neighbours[std::size_t(k)])]);
    if (!std::is_sorted(found.begin() + first, found.end())) std::sort(found.begin() + first, found.end());
}

void gather_neighbours(const Mesh& mesh, const TetsOfNodes& around, std::size_t node,
                       std::vector<std::int32_t>& found) {
    const auto first = std::ptrdiff_t(found.size());
    found.push_back(std::int32_t(node));  // even where no tet has it
    for (auto t = around.starts[node]; t < around.starts[node + 1]; ++t)
        for_each_node(mesh, std::size_t(around.tets[std::size_t(t)]), [&](NodeId other) {
            if (std::find(found.begin() + first, found.end(), other.value) == found.end()) found.push_back(other.value);
        });
    std::sort(found.begin() + first, found.end());
}

BlockMatrix pattern_of(const Mesh& mesh, const TetsOfNodes& around, RunContext& context, const SameRows* same) {
    const std::size_t n = mesh.node_count();
    BlockMatrix matrix;
    matrix.starts.assign(n + 1, 0);
    std::vector<std::vector<std::int32_t>> of_chunk(n / grain + 1);
    parallel_for(context, n, grain, [&](std::size_t begin, std::size_t end) {
        auto& found = of_chunk[begin / grain];
        for (std::size_t node = begin; node < end; ++node) {
            const std::size_t before = found.size();
            is_same(same, node) ? copy_neighbours(*same, node, found) : gather_neighbours(mesh, around, node, found);
            matrix.starts[node + 1] = std::int64_t(found.size() - before);
        }
    });
    for (std::size_t node = 0; node < n; ++node) matrix.starts[node + 1] += matrix.starts[node];
    matrix.neighbours.reserve(std::size_t(matrix.starts[n]));
    for (auto& found : of_chunk) {
        matrix.neighbours.insert(matrix.neighbours.end(), found.begin(), found.end());
        std::vector<std::int32_t>().swap(found);
    }
    return matrix;
}

/// One node's three rows of the matrix while they are summed.
class Rows {
  public:
    Rows(BlockMatrix& matrix, std::size_t node)
        : neighbours_(matrix.neighbours.data() + matrix.starts[node],
                      std::size_t(matrix.starts[node + 1] - matrix.starts[node])),
          values_(matrix.values.data() + 9 * matrix.starts[node]) {}

    void clear() { std::fill_n(values_, 9 * neighbours_.size(), 0.0); }

    /// Adds the block of the row's shape function and another one's at one point: the part of div(stress) that
    /// depends on it. `first` and `shear` are Lame's constants times the point's volume.
    void add(NodeId other, const Vec3& ga, const Vec3& gb, double first, double shear) {
        const auto at = std::find(neighbours_.begin(), neighbours_.end(), other.value) - neighbours_.begin();
        const double along = shear * dot(ga, gb);
        for (int r = 0; r < 3; ++r) {
            double* row = this->row(r) + 3 * at;
            for (int c = 0; c < 3; ++c) row[c] += first * ga[r] * gb[c] + shear * ga[c] * gb[r];
            row[r] += along;
        }
    }

    void hold(std::size_t node, const std::vector<char>& is_held) {
        for (int r = 0; r < 3; ++r)
            for (std::size_t k = 0; k < neighbours_.size(); ++k)
                for (int c = 0; c < 3; ++c) {
                    const auto other = std::size_t(neighbours_[k]);
                    const bool is_diagonal = other == node && r == c;
                    if (!is_diagonal && (is_held[3 * node + std::size_t(r)] || is_held[3 * other + std::size_t(c)]))
                        row(r)[3 * k + std::size_t(c)] = 0;
                }
    }

  private:
    double* row(int r) { return values_ + std::size_t(r) * 3 * neighbours_.size(); }

    std::span<const std::int32_t> neighbours_;
    double* values_;
};

/// Lame's constants.
struct Lame {
    double first, shear;
};

template <class ElementType>
void add_element(const ElementType& element, const Lame& lame, std::size_t node, Rows& rows) {
    const auto own =
        std::size_t(std::find(element.nodes.begin(), element.nodes.end(), NodeId(node)) - element.nodes.begin());
    for (const auto& point : element.points) {
        const double first = lame.first * point.volume, shear = lame.shear * point.volume;
        for (std::size_t b = 0; b < element.nodes.size(); ++b)
            rows.add(element.nodes[b], point.gradients[own], point.gradients[b], first, shear);
    }
}

void fill_rows(const StaticsModel& model, const std::vector<Lame>& lame, const TetsOfNodes& around, std::size_t node,
               BlockMatrix& matrix) {
    Rows rows(matrix, node);
    rows.clear();
    for (auto t = around.starts[node]; t < around.starts[node + 1]; ++t) {
        const auto tet = std::size_t(around.tets[std::size_t(t)]);
        with_element(model.mesh, tet, [&](const auto& element) {
            add_element(element, lame[std::size_t(model.tet_materials[tet])], node, rows);
        });
    }
    rows.hold(node, model.is_held);
}

/// Neighbours may follow one another in another order than in the earlier matrix.
void copy_rows(const SameRows& same, std::size_t node, BlockMatrix& matrix) {
    const auto row = std::size_t(same.row[node]);
    const std::int32_t* before = same.matrix.neighbours.data() + same.matrix.starts[row];
    const std::int32_t* now = matrix.neighbours.data() + matrix.starts[node];
    const auto count = std::size_t(matrix.starts[node + 1] - matrix.starts[node]);
    const double* from = same.matrix.values.data() + 9 * same.matrix.starts[row];
    double* to = matrix.values.data() + 9 * matrix.starts[node];
    for (std::size_t k = 0; k < count; ++k) {
        const std::int32_t neighbour = same.node_now[std::size_t(before[k])];
        const auto at = now[k] == neighbour ? k : std::size_t(std::lower_bound(now, now + count, neighbour) - now);
        for (std::size_t r = 0; r < 3; ++r) std::copy_n(from + 3 * (r * count + k), 3, to + 3 * (r * count + at));
    }
}

}  // namespace

TetsOfNodes tets_of_nodes(const Mesh& mesh) {
    TetsOfNodes around;
    around.starts.assign(mesh.node_count() + 1, 0);
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet)
        for_each_node(mesh, tet, [&](NodeId node) { ++around.starts[node.index() + 1]; });
    for (std::size_t node = 0; node < mesh.node_count(); ++node) around.starts[node + 1] += around.starts[node];
    around.tets.resize(std::size_t(around.starts.back()));
    std::vector<std::int64_t> next(around.starts.begin(), around.starts.end() - 1);
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet)
        for_each_node(mesh, tet,
                      [&](NodeId node) { around.tets[std::size_t(next[node.index()]++)] = std::int32_t(tet); });
    return around;
}

BlockMatrix assemble_stiffness(const StaticsModel& model, const TetsOfNodes& around, RunContext& context,
                               const SameRows* same) {
    BlockMatrix matrix = pattern_of(model.mesh, around, context, same);
    matrix.values.resize(9 * matrix.neighbours.size());
    std::vector<Lame> lame;
    for (const Material& material : model.materials) lame.push_back({material.lame_first(), material.shear_modulus()});
    parallel_for(context, model.mesh.node_count(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node)
            is_same(same, node) ? copy_rows(*same, node, matrix) : fill_rows(model, lame, around, node, matrix);
    });
    return matrix;
}

void multiply(const BlockMatrix& matrix, const double* x, double* y, RunContext& context) {
    parallel_for(context, matrix.node_count(), 4 * grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node) {
            const auto first = std::size_t(matrix.starts[node]), last = std::size_t(matrix.starts[node + 1]);
            const std::size_t width = 3 * (last - first);
            const double* row = matrix.values.data() + 9 * first;
            double sums[3] = {0, 0, 0};
            for (std::size_t k = first; k < last; ++k, row += 3) {
                const double* u = x + 3 * std::size_t(matrix.neighbours[k]);
                for (std::size_t r = 0; r < 3; ++r)
                    sums[r] += row[r * width] * u[0] + row[r * width + 1] * u[1] + row[r * width + 2] * u[2];
            }
            for (std::size_t r = 0; r < 3; ++r) y[3 * node + r] = sums[r];
        }
    });
}

}  // namespace featuremesh

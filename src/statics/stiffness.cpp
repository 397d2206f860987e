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

bool is_same(const EarlierRows* earlier, std::size_t node) { return earlier && earlier->same.row[node] >= 0; }

void copy_neighbours(const EarlierRows& earlier, std::size_t node, std::vector<std::int32_t>& found) {
    const auto row = std::size_t(earlier.same.row[node]);
    const auto first = std::ptrdiff_t(found.size());
    for (std::size_t k = earlier.matrix.begin(row); k < earlier.matrix.end(row); ++k)
        found.push_back(earlier.same.node_now[std::size_t(earlier.matrix.neighbours[k])]);
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

/// The neighbours of rows, one row after the other.
struct Neighbours {
    std::vector<std::int64_t> counts;  ///< by row
    std::vector<std::vector<std::int32_t>> of_chunk;

    /// `gather(row, found)` adds those of a row to what was found.
    template <class Gather>
    Neighbours(std::size_t rows, RunContext& context, const Gather& gather)
        : counts(rows, 0), of_chunk(rows / grain + 1) {
        parallel_for(context, rows, grain, [&](std::size_t begin, std::size_t end) {
            auto& found = of_chunk[begin / grain];
            for (std::size_t row = begin; row < end; ++row) {
                const std::size_t before = found.size();
                gather(row, found);
                counts[row] = std::int64_t(found.size() - before);
            }
        });
    }

    std::size_t size() const {
        std::size_t size = 0;
        for (const auto& found : of_chunk) size += found.size();
        return size;
    }

    void move_behind(std::vector<std::int32_t>& all) {
        for (auto& found : of_chunk) {
            all.insert(all.end(), found.begin(), found.end());
            std::vector<std::int32_t>().swap(found);
        }
    }
};

BlockMatrix pattern_of(const Mesh& mesh, const TetsOfNodes& around, RunContext& context, const EarlierRows* earlier) {
    const std::size_t n = mesh.node_count();
    Neighbours found(n, context, [&](std::size_t node, auto& of) {
        is_same(earlier, node) ? copy_neighbours(*earlier, node, of) : gather_neighbours(mesh, around, node, of);
    });
    BlockMatrix matrix;
    matrix.begins.resize(n), matrix.ends.resize(n);
    std::int64_t at = 0;
    for (std::size_t node = 0; node < n; ++node) matrix.begins[node] = at, matrix.ends[node] = at += found.counts[node];
    matrix.neighbours.reserve(with_room(std::size_t(at)));
    found.move_behind(matrix.neighbours);
    return matrix;
}

/// One node's three rows of the matrix while they are summed.
class Rows {
  public:
    Rows(BlockMatrix& matrix, std::size_t node)
        : neighbours_(matrix.neighbours.data() + matrix.begin(node), matrix.end(node) - matrix.begin(node)),
          values_(matrix.values.data() + 9 * matrix.begin(node)) {}

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
void copy_rows(const EarlierRows& earlier, std::size_t node, BlockMatrix& matrix) {
    const auto row = std::size_t(earlier.same.row[node]);
    const std::int32_t* before = earlier.matrix.neighbours.data() + earlier.matrix.begin(row);
    const std::int32_t* now = matrix.neighbours.data() + matrix.begin(node);
    const std::size_t count = matrix.end(node) - matrix.begin(node);
    const double* from = earlier.matrix.values.data() + 9 * earlier.matrix.begin(row);
    double* to = matrix.values.data() + 9 * matrix.begin(node);
    for (std::size_t k = 0; k < count; ++k) {
        const std::int32_t neighbour = earlier.same.node_now[std::size_t(before[k])];
        const auto at = now[k] == neighbour ? k : std::size_t(std::lower_bound(now, now + count, neighbour) - now);
        for (std::size_t r = 0; r < 3; ++r) std::copy_n(from + 3 * (r * count + k), 3, to + 3 * (r * count + at));
    }
}

std::vector<Lame> lame_constants(const StaticsModel& model) {
    std::vector<Lame> lame;
    for (const Material& material : model.materials) lame.push_back({material.lame_first(), material.shear_modulus()});
    return lame;
}

std::vector<std::size_t> other_rows(const SameRows& same) {
    std::vector<std::size_t> others;
    for (std::size_t node = 0; node < same.row.size(); ++node)
        if (same.row[node] < 0) others.push_back(node);
    return others;
}

/// Gives rows that are the same the numbers of today; the other ones are empty.
void renumber(BlockMatrix& matrix, const SameRows& same, RunContext& context) {
    const std::size_t n = same.row.size();
    const std::vector<std::int64_t> begins = std::move(matrix.begins), ends = std::move(matrix.ends);
    matrix.begins.assign(n, 0), matrix.ends.assign(n, 0);
    parallel_for(context, n, grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node) {
            if (same.row[node] < 0) continue;
            matrix.begins[node] = begins[std::size_t(same.row[node])],
            matrix.ends[node] = ends[std::size_t(same.row[node])];
            for (std::size_t k = matrix.begin(node); k < matrix.end(node); ++k)
                matrix.neighbours[k] = same.node_now[std::size_t(matrix.neighbours[k])];
        }
    });
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
                               const EarlierRows* earlier) {
    BlockMatrix matrix = pattern_of(model.mesh, around, context, earlier);
    matrix.values.reserve(9 * with_room(matrix.neighbours.size()));
    matrix.values.resize(9 * matrix.neighbours.size());
    const std::vector<Lame> lame = lame_constants(model);
    parallel_for(context, model.mesh.node_count(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node)
            is_same(earlier, node) ? copy_rows(*earlier, node, matrix) : fill_rows(model, lame, around, node, matrix);
    });
    return matrix;
}

BlockMatrix changed_stiffness(BlockMatrix earlier, const SameRows& same, const StaticsModel& model,
                              const TetsOfNodes& around, RunContext& context) {
    const std::vector<std::size_t> others = other_rows(same);
    Neighbours found(others.size(), context,
                     [&](std::size_t i, auto& of) { gather_neighbours(model.mesh, around, others[i], of); });
    BlockMatrix matrix = std::move(earlier);
    const std::size_t blocks = matrix.neighbours.size() + found.size();
    if (blocks > matrix.neighbours.capacity() || 9 * blocks > matrix.values.capacity()) {
        const EarlierRows from{matrix, same};
        return assemble_stiffness(model, around, context, &from);
    }
    renumber(matrix, same, context);
    matrix.blocks_before = matrix.neighbours.size();
    auto at = std::int64_t(matrix.blocks_before);
    for (std::size_t i = 0; i < others.size(); ++i)
        matrix.begins[others[i]] = at, matrix.ends[others[i]] = at += found.counts[i];
    found.move_behind(matrix.neighbours);
    matrix.values.resize(9 * blocks);
    const std::vector<Lame> lame = lame_constants(model);
    parallel_for(context, others.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) fill_rows(model, lame, around, others[i], matrix);
    });
    return matrix;
}

/// Row by row of a node's three, as they lie in memory.
void multiply(const BlockMatrix& matrix, const double* x, double* y, RunContext& context) {
    parallel_for(context, matrix.node_count(), 4 * grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node) {
            const std::size_t first = matrix.begin(node), last = matrix.end(node);
            const double* value = matrix.values.data() + 9 * first;
            for (std::size_t r = 0; r < 3; ++r) {
                double sum = 0;
                for (std::size_t k = first; k < last; ++k, value += 3) {
                    const double* u = x + 3 * std::size_t(matrix.neighbours[k]);
                    sum += value[0] * u[0] + value[1] * u[1] + value[2] * u[2];
                }
                y[3 * node + r] = sum;
            }
        }
    });
}

}  // namespace featuremesh

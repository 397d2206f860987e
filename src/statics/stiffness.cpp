// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/stiffness.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/geometry.h"
#include "core/ids.h"
#include "core/sort_once.h"
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

/// Lame's constants.
struct Lame {
    double first, shear;
};

std::vector<Lame> lame_constants(const StaticsModel& model) {
    std::vector<Lame> lame;
    for (const Material& material : model.materials) lame.push_back({material.lame_first(), material.shear_modulus()});
    return lame;
}

/// Three rows of an element's stiffness: that of one of its nodes.
template <std::size_t node_count>
using RowsOfNode = std::array<std::array<double, 3 * node_count>, 3>;

/// The sum over the points of integration of volume, a node's gradient and all gradients.
template <std::size_t node_count, std::size_t point_count>
RowsOfNode<node_count> gradient_products(const Element<node_count, point_count>& element, std::size_t node) {
    RowsOfNode<node_count> sums{};
    for (const auto& [volume, gradients] : element.points)
        for (std::size_t r = 0; r < 3; ++r) {
            const double own = volume * gradients[node][int(r)];
            for (std::size_t other = 0; other < node_count; ++other) {
                sums[r][3 * other] += own * gradients[other].x;
                sums[r][3 * other + 1] += own * gradients[other].y;
                sums[r][3 * other + 2] += own * gradients[other].z;
            }
        }
    return sums;
}

template <std::size_t node_count, std::size_t point_count>
RowsOfNode<node_count> stiffness_of(const Element<node_count, point_count>& element, const Lame& lame,
                                    std::size_t node) {
    const RowsOfNode<node_count> products = gradient_products(element, node);
    RowsOfNode<node_count> rows;
    for (std::size_t i = 0; i < 3 * node_count; i += 3) {
        const double along = lame.shear * (products[0][i] + products[1][i + 1] + products[2][i + 2]);
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c)
                rows[r][i + c] =
                    lame.first * products[r][i + c] + lame.shear * products[c][i + r] + (r == c ? along : 0);
    }
    return rows;
}

/// Sums rows of the matrix, over their tets in ascending order.
class RowSums {
  public:
    /// The nodes whose rows are summed ascend.
    RowSums(std::span<const std::size_t> nodes, BlockMatrix& matrix) : nodes_(nodes), matrix_(matrix) {
        for (const std::size_t node : nodes)
            std::fill_n(matrix.values.data() + matrix.place(node, matrix.begin(node)), 3 * matrix.width(node), 0.0);
    }

    template <class ElementType>
    void add(const ElementType& element, const Lame& lame) {
        for (std::size_t i = 0; i < element.nodes.size(); ++i)
            if (const std::size_t node = element.nodes[i].index();
                std::binary_search(nodes_.begin(), nodes_.end(), node))
                add(node, element.nodes, stiffness_of(element, lame, i));
    }

    /// Rows and columns of held components get nothing but their diagonal value.
    void hold(const std::vector<char>& is_held) {
        for (const std::size_t node : nodes_)
            for (std::size_t k = matrix_.begin(node); k < matrix_.end(node); ++k)
                for (std::size_t r = 0; r < 3; ++r)
                    for (std::size_t c = 0; c < 3; ++c) {
                        const auto row = 3 * node + r, column = 3 * std::size_t(matrix_.neighbours[k]) + c;
                        if (row != column && (is_held[row] || is_held[column])) value(node, k, r)[c] = 0;
                    }
    }

  private:
    double* value(std::size_t node, std::size_t k, std::size_t r) {
        return matrix_.values.data() + matrix_.place(node, k) + r * matrix_.width(node);
    }

    template <std::size_t count>
    void add(std::size_t node, const std::array<NodeId, count>& others, const RowsOfNode<count>& rows) {
        const std::int32_t* all = matrix_.neighbours.data();
        for (std::size_t i = 0; i < count; ++i) {
            const std::int32_t* at =
                std::lower_bound(all + matrix_.begin(node), all + matrix_.end(node), others[i].value);
            for (std::size_t r = 0; r < 3; ++r) {
                double* to = value(node, std::size_t(at - all), r);
                for (std::size_t c = 0; c < 3; ++c) to[c] += rows[r][3 * i + c];
            }
        }
    }

    std::span<const std::size_t> nodes_;
    BlockMatrix& matrix_;
};

/// The tets that have any of the nodes, ascending.
std::vector<std::int32_t> tets_of(std::span<const std::size_t> nodes, const TetsOfNodes& around) {
    std::vector<std::int32_t> tets;
    for (const std::size_t node : nodes)
        tets.insert(tets.end(), around.tets.begin() + around.starts[node],
                    around.tets.begin() + around.starts[node + 1]);
    sort_once(tets);
    return tets;
}

/// Fills the rows of ascending nodes. Those of a chunk share the gradients of their elements.
void fill_rows(const StaticsModel& model, std::span<const std::size_t> nodes, const TetsOfNodes& around,
               BlockMatrix& matrix, RunContext& context) {
    const std::vector<Lame> lame = lame_constants(model);
    parallel_for(context, nodes.size(), grain, [&](std::size_t begin, std::size_t end) {
        const auto of_chunk = nodes.subspan(begin, end - begin);
        RowSums rows(of_chunk, matrix);
        for (const std::int32_t tet : tets_of(of_chunk, around))
            with_element(model.mesh, std::size_t(tet), [&](const auto& element) {
                rows.add(element, lame[std::size_t(model.tet_materials[std::size_t(tet)])]);
            });
        rows.hold(model.is_held);
    });
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

/// Those of so many rows that are not taken from an earlier matrix.
std::vector<std::size_t> other_rows(std::size_t count, const SameRows* same) {
    std::vector<std::size_t> others;
    for (std::size_t node = 0; node < count; ++node)
        if (!same || same->row[node] < 0) others.push_back(node);
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
    if (earlier)
        parallel_for(context, model.mesh.node_count(), grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t node = begin; node < end; ++node)
                if (is_same(earlier, node)) copy_rows(*earlier, node, matrix);
        });
    fill_rows(model, other_rows(model.mesh.node_count(), earlier ? &earlier->same : nullptr), around, matrix, context);
    return matrix;
}

BlockMatrix changed_stiffness(BlockMatrix earlier, const SameRows& same, const StaticsModel& model,
                              const TetsOfNodes& around, RunContext& context) {
    const std::vector<std::size_t> others = other_rows(model.mesh.node_count(), &same);
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
    fill_rows(model, others, around, matrix, context);
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

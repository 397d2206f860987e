// SPDX-License-Identifier: GPL-3.0-or-later
// The stiffness matrix of a model, in blocks of three by three.
#pragma once

#include <cstdint>
#include <vector>

#include "core/run_context.h"
#include "mesh/mesh.h"
#include "statics/growing_values.h"
#include "statics/model.h"

namespace featuremesh {

/// Which tets have a node, by node: `tets[starts[i]]` to `tets[starts[i + 1]]`, ascending; mid-side nodes count.
struct TetsOfNodes {
    std::vector<std::int64_t> starts;
    std::vector<std::int32_t> tets;
};
TetsOfNodes tets_of_nodes(const Mesh& mesh);

/// A sparse symmetric matrix of 3 x 3 blocks. The neighbours of node i, itself included, are `neighbours[begins[i]]` to
/// `neighbours[ends[i]]`. Its values begin at `values[9 * begins[i]]`: three rows, one after the other, each with three
/// values per neighbour. As assembled, neighbours ascend and each node's rows follow on the last one's; of a matrix
/// that was changed in place (changed_stiffness) neither need be so, and between rows there may be what is no more
/// used.
struct BlockMatrix {
    std::vector<std::int64_t> begins, ends;
    std::vector<std::int32_t> neighbours;
    GrowingValues<double> values;
    std::size_t blocks_before = 0;  ///< so many blocks lie as in the matrix that was changed in place to this

    std::size_t node_count() const { return begins.size(); }
    std::size_t begin(std::size_t node) const { return std::size_t(begins[node]); }
    std::size_t end(std::size_t node) const { return std::size_t(ends[node]); }
    /// How many values a row has.
    std::size_t width(std::size_t node) const { return 3 * (end(node) - begin(node)); }
    /// Where a block's values in the first of its node's three rows begin.
    std::size_t place(std::size_t node, std::size_t block) const { return 9 * begin(node) + 3 * (block - begin(node)); }
};

/// y = A x, each row by itself.
void multiply(const BlockMatrix& matrix, const double* x, double* y, RunContext& context);

/// Rows that an earlier matrix has already.
struct SameRows {
    std::vector<std::int32_t> row;       ///< by node its row there, -1 where it has another
    std::vector<std::int32_t> node_now;  ///< by node there the one that it is now
};

/// An earlier matrix and those of its rows that are taken.
struct EarlierRows {
    const BlockMatrix& matrix;
    const SameRows& same;
};

/// The stiffness matrix; rows and columns of held components are zero but for their diagonal value. The same bytes for
/// any number of threads, and whatever rows are the same: each is summed by itself, over its tets in ascending order.
BlockMatrix assemble_stiffness(const StaticsModel& model, const TetsOfNodes& around, RunContext& context,
                               const EarlierRows* earlier = nullptr);

/// The same matrix, but made of an earlier one in place: rows that are the same stay where they are, others follow
/// behind. Where no room is left for these it is assembled as above. The same bytes for any number of threads.
BlockMatrix changed_stiffness(BlockMatrix earlier, const SameRows& same, const StaticsModel& model,
                              const TetsOfNodes& around, RunContext& context);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// The stiffness matrix of a model, in blocks of three by three.
#pragma once

#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "core/run_context.h"
#include "mesh/mesh.h"
#include "statics/model.h"

namespace featuremesh {

/// Which tets have a node, by node: `tets[starts[i]]` to `tets[starts[i + 1]]`, ascending; mid-side nodes count.
struct TetsOfNodes {
    std::vector<std::int64_t> starts;
    std::vector<std::int32_t> tets;
};
TetsOfNodes tets_of_nodes(const Mesh& mesh);

/// Numbers that are not set when a vector of them grows: whole matrices are written once only, on all threads.
template <class T>
struct UnsetValues : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UnsetValues<U>;
    };
    template <class U>
    void construct(U* at) noexcept {
        ::new (static_cast<void*>(at)) U;
    }
    template <class U, class... Arguments>
    void construct(U* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
    }
};

/// A sparse symmetric matrix of 3 x 3 blocks. The neighbours of node i, itself included, are `neighbours[starts[i]]` to
/// `neighbours[starts[i + 1]]`, ascending. Its values begin at `values[9 * starts[i]]`: three rows, one after the
/// other, each with three values per neighbour.
struct BlockMatrix {
    std::vector<std::int64_t> starts;
    std::vector<std::int32_t> neighbours;
    std::vector<double, UnsetValues<double>> values;

    std::size_t node_count() const { return starts.empty() ? 0 : starts.size() - 1; }
};

/// y = A x, each row by itself.
void multiply(const BlockMatrix& matrix, const double* x, double* y, RunContext& context);

/// Rows that an earlier matrix has already.
struct SameRows {
    const BlockMatrix& matrix;
    std::vector<std::int32_t> row;       ///< by node its row there, -1 where it has another
    std::vector<std::int32_t> node_now;  ///< by node there the one that it is now
};

/// The stiffness matrix; rows and columns of held components are zero but for their diagonal value. The same bytes for
/// any number of threads, and whatever rows are `same`: each row is summed by itself, over its tets in ascending order.
BlockMatrix assemble_stiffness(const StaticsModel& model, const TetsOfNodes& around, RunContext& context,
                               const SameRows* same = nullptr);

}  // namespace featuremesh

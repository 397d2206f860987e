// SPDX-License-Identifier: GPL-3.0-or-later
// A matrix in single precision, which has half the memory to read. Its products are summed in double precision.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/run_context.h"
#include "statics/growing_values.h"

namespace featuremesh {

/// Row i has the blocks `begins[i]` to `ends[i]`, at those columns.
struct RowsOfBlocks {
    std::span<const std::int64_t> begins, ends;
    std::span<const std::int32_t> columns;
};

/// Each begins where the last one ends.
inline RowsOfBlocks rows_of(std::span<const std::int64_t> starts, std::span<const std::int32_t> columns) {
    return {starts.first(starts.size() - 1), starts.subspan(1), columns};
}

/// Blocks of `height` by `across` numbers, 3 or 6 each, column by column.
class RoundedBlocks {
  public:
    RoundedBlocks() = default;
    RoundedBlocks(std::size_t height, std::size_t across) : height_(height), across_(across) {}
    RoundedBlocks(std::size_t height, std::size_t across, const RowsOfBlocks& rows, const double* values,
                  RunContext& threads)
        : RoundedBlocks(height, across) {
        take(rows, values, threads);
    }

    /// Takes a matrix, of which this has so many blocks already. What `rows` refers to has to outlive this. `values`
    /// has for each row of blocks `height` rows of numbers, one after the other.
    void take(const RowsOfBlocks& rows, const double* values, RunContext& threads, std::size_t blocks_before = 0);

    /// y = A x, each row by itself, in one order on every machine; `by_parts` as on one without AVX2.
    void multiply(const double* x, double* y, RunContext& threads, bool by_parts = false) const;

  private:
    void round(std::size_t row, const double* values);
    void find_order();

    std::size_t height_ = 0, across_ = 0;
    RowsOfBlocks rows_;
    std::vector<std::int32_t> order_;  ///< of rows as they lie in memory; empty where that is their own
    GrowingValues<float> values_;
};

}  // namespace featuremesh

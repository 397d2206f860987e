// SPDX-License-Identifier: GPL-3.0-or-later
// A matrix in single precision, which has half the memory to read. Its products are summed in double precision.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/run_context.h"

namespace featuremesh {

/// Blocks of `height` by `across` numbers, 3 or 6 each, column by column.
class RoundedBlocks {
  public:
    RoundedBlocks() = default;
    /// Row i has the blocks `starts[i]` to `starts[i + 1]`, at those columns; both have to outlive this. `values` has
    /// for each row of blocks `height` rows of numbers, one after the other.
    RoundedBlocks(std::size_t height, std::size_t across, std::span<const std::int64_t> starts,
                  std::span<const std::int32_t> columns, const double* values, RunContext& threads);

    /// y = A x, each row by itself, in one order on every machine; `by_parts` as on one without AVX2.
    void multiply(const double* x, double* y, RunContext& threads, bool by_parts = false) const;

  private:
    std::size_t height_ = 0, across_ = 0;
    std::span<const std::int64_t> starts_;
    std::span<const std::int32_t> columns_;
    std::vector<float> values_;
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/rounded_blocks.h"

#include <algorithm>
#include <numeric>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace featuremesh {

namespace {

constexpr std::size_t grain = 4096;  // blocks' rows
constexpr std::size_t lanes = 4;     // numbers that are multiplied at a time

// A vector of GCC and Clang; a machine without such registers does the same sums in the same order by parts.
typedef double Sums __attribute__((vector_size(8 * lanes)));

struct Rows {
    const std::int64_t *begins, *ends;
    const std::int32_t *columns, *order;
    const float* values;
    const double* x;
    double* y;
};

/// A column that does not fill its vectors is read beyond its end, and what comes of that is left out.
template <std::size_t height, std::size_t across, class Read>
[[gnu::always_inline]] inline void multiply_rows(const Rows& rows, std::size_t begin, std::size_t end, Read read) {
    constexpr std::size_t vectors = (height + lanes - 1) / lanes;
    for (std::size_t i = begin; i < end; ++i) {
        const std::size_t row = rows.order ? std::size_t(rows.order[i]) : i;
        Sums sums[vectors][3] = {};
        for (auto k = std::size_t(rows.begins[row]); k < std::size_t(rows.ends[row]); ++k) {
            const float* block = rows.values + height * across * k;
            const double* u = rows.x + across * std::size_t(rows.columns[k]);
            for (std::size_t c = 0; c < across; ++c)
                for (std::size_t v = 0; v < vectors; ++v) {
                    Sums column;
                    read(block + height * c + lanes * v, column);
                    sums[v][c % 3] += column * u[c];
                }
        }
        for (std::size_t r = 0; r < height; ++r) {
            const auto& of = sums[r / lanes];
            rows.y[height * row + r] = of[0][r % lanes] + of[1][r % lanes] + of[2][r % lanes];
        }
    }
}

template <class Read>
[[gnu::always_inline]] inline void multiply_blocks(std::size_t height, std::size_t across, const Rows& rows,
                                                   std::size_t begin, std::size_t end, Read read) {
    if (height == 3)
        across == 3 ? multiply_rows<3, 3>(rows, begin, end, read) : multiply_rows<3, 6>(rows, begin, end, read);
    else
        across == 3 ? multiply_rows<6, 3>(rows, begin, end, read) : multiply_rows<6, 6>(rows, begin, end, read);
}

void multiply_anywhere(std::size_t height, std::size_t across, const Rows& rows, std::size_t begin, std::size_t end) {
    multiply_blocks(height, across, rows, begin, end, [](const float* from, Sums& to) {
        to = Sums{double(from[0]), double(from[1]), double(from[2]), double(from[3])};
    });
}

#if defined(__x86_64__)
/// The compilers convert by parts what is not said so.
[[gnu::target("avx2")]] void multiply_by_avx2(std::size_t height, std::size_t across, const Rows& rows,
                                              std::size_t begin, std::size_t end) {
    const auto read = [](const float* from, Sums& to) __attribute__((target("avx2"))) {
        to = _mm256_cvtps_pd(_mm_loadu_ps(from));
    };
    multiply_blocks(height, across, rows, begin, end, read);
}
const bool has_avx2 = __builtin_cpu_supports("avx2");
#endif

}  // namespace

void RoundedBlocks::take(const RowsOfBlocks& rows, const double* values, RunContext& threads,
                         std::size_t blocks_before) {
    rows_ = rows;
    find_order();
    const std::size_t numbers = height_ * across_;
    if (blocks_before == 0) {
        values_ = {};
        values_.reserve(numbers * with_room(rows.columns.size()) + 2 * lanes);
    }
    values_.resize(numbers * rows.columns.size() + 2 * lanes);
    parallel_for(threads, rows.begins.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row)
            if (std::size_t(rows.begins[row]) >= blocks_before) round(row, values);
    });
}

/// Rows that were changed in place lie in another order than they are counted, and memory is read fastest as it lies.
void RoundedBlocks::find_order() {
    order_.clear();
    if (std::is_sorted(rows_.begins.begin(), rows_.begins.end())) return;
    order_.resize(rows_.begins.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) {
        return rows_.begins[std::size_t(a)] < rows_.begins[std::size_t(b)];
    });
}

void RoundedBlocks::round(std::size_t row, const double* values) {
    const auto first = std::size_t(rows_.begins[row]), width = across_ * (std::size_t(rows_.ends[row]) - first);
    const double* from = values + height_ * across_ * first;
    float* to = values_.data() + height_ * across_ * first;
    for (std::size_t k = 0; k < width; ++k)
        for (std::size_t r = 0; r < height_; ++r) to[height_ * k + r] = float(from[r * width + k]);
}

void RoundedBlocks::multiply(const double* x, double* y, RunContext& threads, [[maybe_unused]] bool by_parts) const {
    const Rows rows{rows_.begins.data(),
                    rows_.ends.data(),
                    rows_.columns.data(),
                    order_.empty() ? nullptr : order_.data(),
                    values_.data(),
                    x,
                    y};
    parallel_for(threads, rows_.begins.size(), grain, [&](std::size_t begin, std::size_t end) {
#if defined(__x86_64__)
        if (has_avx2 && !by_parts) return multiply_by_avx2(height_, across_, rows, begin, end);
#endif
        multiply_anywhere(height_, across_, rows, begin, end);
    });
}

}  // namespace featuremesh

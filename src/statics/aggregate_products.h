// SPDX-License-Identifier: GPL-3.0-or-later
// The products that the set-up of an aggregation needs on each level: A P and P^T A P, with A the stiffness and P the
// rigid motions of aggregates at the nodes. They are made by blocks on all threads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/run_context.h"

namespace featuremesh {

/// Which blocks there are in rows of blocks, of `height` by `across` numbers each. The numbers lie as in PETSc: for
/// each row of blocks `height` rows of numbers, one after the other.
struct BlockPattern {
    std::size_t height = 0, across = 0;
    std::vector<std::int64_t> starts{0};
    std::vector<std::int32_t> columns;  ///< of blocks, ascending within a row

    std::size_t count() const { return starts.size() - 1; }
    std::size_t begin(std::size_t row) const { return std::size_t(starts[row]); }
    std::size_t end(std::size_t row) const { return std::size_t(starts[row + 1]); }
    /// How many numbers a row of numbers has.
    std::size_t width(std::size_t row) const { return across * (end(row) - begin(row)); }
    /// Where the numbers of a row of blocks begin, and those of one of its blocks.
    std::size_t place(std::size_t row) const { return across * height * begin(row); }
    std::size_t place(std::size_t row, std::size_t block) const { return place(row) + across * (block - begin(row)); }
    std::size_t find(std::size_t row, std::int32_t column) const {
        const auto first = columns.begin() + starts[row], last = columns.begin() + starts[row + 1];
        return std::size_t(std::lower_bound(first, last, column) - columns.begin());
    }

    /// That of blocks of `height` by six of which `visit(row, add)` calls add(column), as often as it likes.
    template <class Visit>
    static BlockPattern gathered(std::size_t rows, std::size_t height, RunContext& threads, const Visit& visit) {
        constexpr std::size_t grain = 256;
        BlockPattern blocks{height, 6, std::vector<std::int64_t>(rows + 1, 0), {}};
        std::vector<std::vector<std::int32_t>> of_chunk(rows / grain + 1);
        parallel_for(threads, rows, grain, [&](std::size_t begin, std::size_t end) {
            auto& found = of_chunk[begin / grain];
            for (std::size_t row = begin; row < end; ++row) {
                const auto first = std::ptrdiff_t(found.size());
                visit(row, [&](std::int32_t column) {
                    if (std::find(found.begin() + first, found.end(), column) == found.end()) found.push_back(column);
                });
                std::sort(found.begin() + first, found.end());
                blocks.starts[row + 1] = std::int64_t(found.size()) - first;
            }
        });
        for (std::size_t row = 0; row < rows; ++row) blocks.starts[row + 1] += blocks.starts[row];
        for (const auto& found : of_chunk) blocks.columns.insert(blocks.columns.end(), found.begin(), found.end());
        return blocks;
    }
};

/// A matrix of blocks.
struct Blocks {
    const BlockPattern& pattern;
    const double* values;
};

/// By aggregate the blocks of its motions, ascending by node.
struct NodesOfAggregates {
    std::vector<std::int64_t> starts;
    std::vector<std::int32_t> nodes;
    std::vector<std::int64_t> blocks;

    NodesOfAggregates(const BlockPattern& motions, std::size_t count) : starts(count + 1, 0) {
        for (const std::int32_t aggregate : motions.columns) ++starts[std::size_t(aggregate) + 1];
        for (std::size_t i = 0; i < count; ++i) starts[i + 1] += starts[i];
        nodes.resize(motions.columns.size()), blocks.resize(motions.columns.size());
        std::vector<std::int64_t> next(starts.begin(), starts.end() - 1);
        for (std::size_t node = 0; node < motions.count(); ++node)
            for (std::size_t block = motions.begin(node); block < motions.end(node); ++block) {
                const auto at = std::size_t(next[std::size_t(motions.columns[block])]++);
                nodes[at] = std::int32_t(node), blocks[at] = std::int64_t(block);
            }
    }
};

/// The products of one stiffness, in blocks of `height` by `height`, with motions of `height` by six. Each row of
/// blocks is summed by itself, in one order for any number of threads.
template <std::size_t height>
class LevelProducts {
  public:
    /// A P is held for `slab` nodes at a time.
    LevelProducts(const Blocks& stiffness, const Blocks& motions, RunContext& threads, std::size_t slab = 32768)
        : a_(stiffness.pattern),
          a_values_(stiffness.values),
          p_(motions.pattern),
          p_values_(motions.values),
          threads_(threads),
          slab_(slab) {}

    /// Of A P.
    BlockPattern pattern() const {
        return BlockPattern::gathered(a_.count(), height, threads_, [&](std::size_t node, const auto& add) {
            for (std::size_t k = a_.begin(node); k < a_.end(node); ++k) {
                const auto other = std::size_t(a_.columns[k]);
                for (std::size_t block = p_.begin(other); block < p_.end(other); ++block) add(p_.columns[block]);
            }
        });
    }

    /// Of P^T A P, with `product` that of A P.
    BlockPattern pattern(const BlockPattern& product, const NodesOfAggregates& has) const {
        return BlockPattern::gathered(has.starts.size() - 1, 6, threads_, [&](std::size_t aggregate, const auto& add) {
            for (auto i = std::size_t(has.starts[aggregate]); i < std::size_t(has.starts[aggregate + 1]); ++i) {
                const auto node = std::size_t(has.nodes[i]);
                for (std::size_t k = product.begin(node); k < product.end(node); ++k) add(product.columns[k]);
            }
        });
    }

    /// A P at the nodes from `first` to `last`.
    void multiply(const BlockPattern& product, std::size_t first, std::size_t last, double* values) const {
        std::fill(values, values + (product.place(last) - product.place(first)), 0.0);
        parallel_for(threads_, last - first, 256, [&](std::size_t begin, std::size_t end) {
            for (std::size_t node = first + begin; node < first + end; ++node)
                multiply_at(product, node, values + (product.place(node) - product.place(first)));
        });
    }

    /// P^T A P.
    void condense(const BlockPattern& product, const NodesOfAggregates& has, const BlockPattern& condensed,
                  double* values) const {
        std::fill(values, values + condensed.place(condensed.count()), 0.0);
        std::vector<std::int64_t> next(has.starts.begin(), has.starts.end() - 1);
        std::vector<double> held;
        for (std::size_t first = 0; first < product.count(); first += slab_) {
            const std::size_t last = std::min(first + slab_, product.count());
            held.resize(product.place(last) - product.place(first));
            multiply(product, first, last, held.data());
            parallel_for(threads_, condensed.count(), 16, [&](std::size_t begin, std::size_t end) {
                for (std::size_t aggregate = begin; aggregate < end; ++aggregate)
                    for (auto& i = next[aggregate]; i < has.starts[aggregate + 1]; ++i) {
                        const auto node = std::size_t(has.nodes[std::size_t(i)]);
                        if (node >= last) break;
                        add_node(product, node, held.data() + (product.place(node) - product.place(first)),
                                 std::size_t(has.blocks[std::size_t(i)]), condensed, aggregate, values);
                    }
            });
        }
    }

  private:
    void multiply_at(const BlockPattern& product, std::size_t node, double* values) const {
        const std::size_t wide = a_.width(node), width = product.width(node);
        for (std::size_t k = a_.begin(node); k < a_.end(node); ++k) {
            const auto other = std::size_t(a_.columns[k]);
            const double* factors = a_values_ + a_.place(node, k);
            for (std::size_t block = p_.begin(other); block < p_.end(other); ++block) {
                const double* rows = p_values_ + p_.place(other, block);
                double* to = values + 6 * (product.find(node, p_.columns[block]) - product.begin(node));
                for (std::size_t r = 0; r < height; ++r)
                    add_rows(factors + r * wide, 1, rows, p_.width(other), to + r * width);
            }
        }
    }

    /// Adds to the rows of an aggregate what a node gives, of which `block` has the aggregate's motions and `held` A P.
    void add_node(const BlockPattern& product, std::size_t node, const double* held, std::size_t block,
                  const BlockPattern& condensed, std::size_t aggregate, double* values) const {
        const double* factors = p_values_ + p_.place(node, block);
        const std::size_t down = p_.width(node), width = condensed.width(aggregate);
        for (std::size_t k = product.begin(node); k < product.end(node); ++k) {
            const double* rows = held + 6 * (k - product.begin(node));
            double* to = values + condensed.place(aggregate, condensed.find(aggregate, product.columns[k]));
            for (std::size_t r = 0; r < 6; ++r) add_rows(factors + r, down, rows, product.width(node), to + r * width);
        }
    }

    /// Adds so many rows of six numbers, times factors.
    static void add_rows(const double* factors, std::size_t apart, const double* rows, std::size_t width, double* to) {
        double sums[6];
        std::copy(to, to + 6, sums);
        for (std::size_t r = 0; r < height; ++r)
            for (std::size_t i = 0; i < 6; ++i) sums[i] += factors[r * apart] * rows[r * width + i];
        std::copy(sums, sums + 6, to);
    }

    const BlockPattern& a_;
    const double* a_values_;
    const BlockPattern& p_;
    const double* p_values_;
    RunContext& threads_;
    std::size_t slab_;
};

}  // namespace featuremesh

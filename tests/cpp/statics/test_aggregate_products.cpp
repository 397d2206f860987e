// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include "catch.h"
#include "statics/aggregate_products.h"
#include "statics/rounded_blocks.h"

using namespace featuremesh;

namespace {

/// Random blocks, each there with a probability of a third, those on the diagonal always.
struct RandomBlocks {
    BlockPattern pattern;
    std::vector<double> values;

    RandomBlocks(std::size_t rows, std::size_t columns, std::size_t height, std::size_t across, std::mt19937& random)
        : pattern{height, across, {0}, {}} {
        for (std::size_t row = 0; row < rows; ++row) {
            for (std::size_t column = 0; column < columns; ++column)
                if (column == row % columns || random() % 3 == 0) pattern.columns.push_back(std::int32_t(column));
            pattern.starts.push_back(std::int64_t(pattern.columns.size()));
        }
        values.resize(pattern.place(rows));
        for (double& value : values) value = double(random() % 2000) / 1000 - 1;
    }

    Blocks blocks() const { return {pattern, values.data()}; }
};

using Dense = std::vector<std::vector<double>>;

Dense dense(const BlockPattern& pattern, const double* values, std::size_t columns) {
    Dense matrix(pattern.height * pattern.count(), std::vector<double>(pattern.across * columns, 0.0));
    for (std::size_t row = 0; row < pattern.count(); ++row)
        for (std::size_t block = pattern.begin(row); block < pattern.end(row); ++block)
            for (std::size_t r = 0; r < pattern.height; ++r)
                for (std::size_t c = 0; c < pattern.across; ++c)
                    matrix[pattern.height * row + r][pattern.across * std::size_t(pattern.columns[block]) + c] =
                        values[pattern.place(row, block) + r * pattern.width(row) + c];
    return matrix;
}

Dense times(const Dense& a, const Dense& b) {
    Dense product(a.size(), std::vector<double>(b[0].size(), 0.0));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k)
            for (std::size_t j = 0; j < b[0].size(); ++j) product[i][j] += a[i][k] * b[k][j];
    return product;
}

Dense transposed(const Dense& a) {
    Dense turned(a[0].size(), std::vector<double>(a.size()));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < a[0].size(); ++j) turned[j][i] = a[i][j];
    return turned;
}

double largest_difference(const Dense& a, const Dense& b) {
    REQUIRE(a.size() == b.size());
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < a[i].size(); ++j) most = std::max(most, std::abs(a[i][j] - b[i][j]));
    return most;
}

template <std::size_t height>
void check_products(std::size_t nodes, std::size_t aggregates, int threads) {
    std::mt19937 random(7);
    const RandomBlocks stiffness(nodes, nodes, height, height, random);
    const RandomBlocks motions(nodes, aggregates, height, 6, random);
    RunContext context;
    context.threads = threads;
    const LevelProducts<height> level(stiffness.blocks(), motions.blocks(), context, 7);
    const Dense a = dense(stiffness.pattern, stiffness.values.data(), nodes);
    const Dense p = dense(motions.pattern, motions.values.data(), aggregates);

    const BlockPattern product = level.pattern();
    std::vector<double> values(product.place(nodes), 7.0);
    level.multiply(product, 0, nodes, values.data());
    CHECK(largest_difference(dense(product, values.data(), aggregates), times(a, p)) < 1e-12);

    const NodesOfAggregates has(motions.pattern, aggregates);
    const BlockPattern condensed = level.pattern(product, has);
    std::vector<double> twice(condensed.place(aggregates), 7.0);
    level.condense(product, has, condensed, twice.data());
    CHECK(largest_difference(dense(condensed, twice.data(), aggregates), times(transposed(p), times(a, p))) < 1e-11);
}

}  // namespace

TEST_CASE("products of an aggregation by blocks are those of the matrices, on any number of threads") {
    const int threads = GENERATE(1, 3);
    check_products<3>(40, 9, threads);
    check_products<6>(20, 5, threads);
    check_products<3>(1, 1, threads);
}

TEST_CASE("products in single precision are those of the rounded matrix, on any number of threads") {
    const std::size_t height = GENERATE(3, 6), across = GENERATE(3, 6), rows = 5000;
    std::mt19937 random(11);
    BlockPattern pattern{height, across, {0}, {}};
    for (std::size_t row = 0; row < rows; ++row) {
        for (const std::size_t column : {row / 2, row, rows - 1})
            if (pattern.columns.size() == pattern.begin(row) || std::size_t(pattern.columns.back()) < column)
                pattern.columns.push_back(std::int32_t(column));
        pattern.starts.push_back(std::int64_t(pattern.columns.size()));
    }
    std::vector<double> values(pattern.place(rows)), x(across * rows), expected(height * rows, 0.0);
    for (double& value : values) value = double(random() % 2000) / 700 - 1;
    for (double& value : x) value = double(random() % 2000) / 900 - 1;
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t block = pattern.begin(row); block < pattern.end(row); ++block)
            for (std::size_t r = 0; r < height; ++r)
                for (std::size_t c = 0; c < across; ++c)
                    expected[height * row + r] +=
                        double(float(values[pattern.place(row, block) + r * pattern.width(row) + c])) *
                        x[across * std::size_t(pattern.columns[block]) + c];
    std::vector<std::vector<double>> found;
    for (const int threads : {1, 4}) {
        RunContext context;
        context.threads = threads;
        const RoundedBlocks matrix(height, across, rows_of(pattern.starts, pattern.columns), values.data(), context);
        found.emplace_back(height * rows, 7.0);
        matrix.multiply(x.data(), found.back().data(), context);
        double most = 0;
        for (std::size_t i = 0; i < height * rows; ++i) most = std::max(most, std::abs(found.back()[i] - expected[i]));
        CHECK(most < 1e-13);
        std::vector<double> by_parts(height * rows, 7.0);
        matrix.multiply(x.data(), by_parts.data(), context, true);
        CHECK(by_parts == found.back());  // a machine without AVX2 has the same bytes

        std::vector<std::int64_t> begins(pattern.starts.rbegin() + 1, pattern.starts.rend());
        std::vector<std::int64_t> ends(pattern.starts.rbegin(), pattern.starts.rend() - 1);
        RoundedBlocks last_first(height, across);
        last_first.take({begins, ends, pattern.columns}, values.data(), context);
        std::vector<double> backwards(height * rows, 7.0);
        last_first.multiply(x.data(), backwards.data(), context);
        for (std::size_t row = 0; row < rows; ++row)
            CHECK(std::equal(backwards.begin() + std::ptrdiff_t(height * row),
                             backwards.begin() + std::ptrdiff_t(height * (row + 1)),
                             found.back().begin() + std::ptrdiff_t(height * (rows - 1 - row))));
    }
    CHECK(found[0] == found[1]);
}

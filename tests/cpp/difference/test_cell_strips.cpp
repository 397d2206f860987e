// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/cell_strips.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "catch.h"

using namespace featuremesh;

namespace {
constexpr double slack = 1e-9;

double height_of(const UvLine& line, double u) {
    return line[0][1] + (line[1][1] - line[0][1]) * (u - line[0][0]) / (line[1][0] - line[0][0]);
}

bool is_along(const UvLine& line, double u) { return (line[0][0] < u) != (line[1][0] < u); }

std::size_t lines_below(const std::vector<UvLine>& lines, const Uv& p) {
    return std::size_t(std::count_if(lines.begin(), lines.end(), [&](const UvLine& line) {
        return is_along(line, p[0]) && height_of(line, p[0]) < p[1];
    }));
}

bool is_on_a_line(const std::vector<UvLine>& lines, const Uv& p) {
    return std::any_of(lines.begin(), lines.end(), [&](const UvLine& line) {
        return is_along(line, p[0]) && std::abs(height_of(line, p[0]) - p[1]) < 1e-9;
    });
}
}  // namespace

TEST_CASE("strips of a cell tell how many lines are below a point") {
    const unsigned seed = GENERATE(range(1u, 40u));
    INFO("seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> u(-3, 5), v(-2, 2), within(0, 1);
    const UvBox cell{{-1, -1}, {3, 1}};
    std::vector<UvLine> lines;
    for (unsigned i = 0; i < seed % 9; ++i)
        if (const auto part = part_inside({Uv{u(random), v(random)}, Uv{u(random), v(random)}}, cell))
            lines.push_back(*part);
    if (seed % 3 == 0) lines.push_back({Uv{0.5, -1}, Uv{0.5, 1}}), lines.push_back({Uv{-1, 0}, Uv{3, 0}});

    double right = cell.low[0];
    for (const CellStrip& strip : strips_of(cell, lines, slack)) {
        CHECK(strip.left == right);
        right = strip.right;
        for (int i = 0; i < 50; ++i) {
            const double share = within(random);
            for (std::size_t k = 0; k + 1 < strip.heights.size(); ++k) {
                const Uv p = strip.between(k, share);
                if (!is_on_a_line(lines, p)) CHECK(lines_below(lines, p) == k);
            }
        }
    }
    CHECK(right == cell.high[0]);
}

TEST_CASE("the part of a line inside a box") {
    const UvBox box{{0, 0}, {2, 1}};
    CHECK(part_inside({Uv{-1, 0.5}, Uv{3, 0.5}}, box) == UvLine{Uv{0, 0.5}, Uv{2, 0.5}});
    CHECK(part_inside({Uv{1, 0.25}, Uv{1, 0.75}}, box) == UvLine{Uv{1, 0.25}, Uv{1, 0.75}});
    CHECK(part_inside({Uv{-1, -1}, Uv{1, 1}}, box) == UvLine{Uv{0, 0}, Uv{1, 1}});
    CHECK_FALSE(part_inside({Uv{-1, 0.5}, Uv{0.5, 2.5}}, box));
    CHECK_FALSE(part_inside({Uv{3, 0}, Uv{3, 1}}, box));
}

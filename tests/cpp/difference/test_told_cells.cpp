// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/told_cells.h"

#include "catch.h"

using namespace featuremesh;

TEST_CASE("a cell answers for those that share a border with it, however small") {
    const UvBox root{{-3, 0}, {5, 2}}, low_left{{-3, 0}, {1, 1}}, low_right{{1, 0}, {5, 1}}, high_right{{1, 1}, {5, 2}};
    ToldCells told(root);
    CHECK(!told.beside(low_left));

    told.add(low_left, true);
    CHECK(told.beside(low_right) == true);
    CHECK(!told.beside(high_right));
    CHECK(told.beside({{-1, 1}, {0, 1.25}}) == true);
    CHECK(!told.beside({{-1, 1.25}, {0, 1.5}}));
    CHECK(!told.beside({{1, 1.5}, {1.5, 2}}));

    told.add(high_right, false);
    CHECK(told.beside({{0.5, 1.5}, {1, 1.75}}) == false);
    CHECK(told.beside({{0.5, 1}, {1, 1.25}}).has_value());
}

TEST_CASE("borders meet where halving in two ways rounds them otherwise") {
    const UvBox root{{0.1, 0.3}, {0.7, 0.9}};
    UvBox left = root, right = root;
    left.high[0] = 0.5 * (root.low[0] + root.high[0]);
    right.low[0] = root.at(0.5, 0)[0] * (1 + 1e-15);
    ToldCells told(root);
    told.add(left, false);
    CHECK(told.beside(right) == false);
}

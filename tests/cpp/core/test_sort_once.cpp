// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>
#include <set>
#include <vector>

#include "catch.h"
#include "core/sort_once.h"

using namespace featuremesh;

TEST_CASE("a list has each item once and in order, as a set has") {
    std::mt19937 random(3);
    for (const std::size_t length : {0, 1, 2, 10, 1000})
        for (const int largest : {0, 5, 100000}) {
            std::vector<int> list(length);
            for (int& item : list) item = std::uniform_int_distribution(-largest, largest)(random);
            const std::set<int> items(list.begin(), list.end());
            const std::vector<int> expected(items.begin(), items.end());
            sort_once(list);
            CHECK(list == expected);
            sort_once(list);
            CHECK(list == expected);
        }
}

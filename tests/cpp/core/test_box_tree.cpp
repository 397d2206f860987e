// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "catch.h"
#include "core/box_tree.h"

using namespace featuremesh;

TEST_CASE("a tree of boxes finds what going over all of them finds") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(0, 100), extent(0, 12);
    std::vector<Box> boxes;
    for (int i = 0; i < 300; ++i) {
        const Vec3 low{place(random), place(random), place(random)};
        boxes.push_back({low, low + Vec3{extent(random), extent(random), extent(random)}});
    }
    const BoxTree tree(boxes);
    for (int i = 0; i < 200; ++i) {
        const Vec3 p{place(random), place(random), place(random)};
        const auto is_beyond = [&](const Box& box) { return box.high.x > p.x && box.low.y < p.y; };
        std::vector<std::int32_t> around, beyond, all_around, all_beyond;
        tree.visit_around(p, [&](std::int32_t b) { around.push_back(b); });
        tree.visit_where(is_beyond, [&](std::int32_t b) { beyond.push_back(b); });
        for (std::int32_t b = 0; b < 300; ++b) {
            if (boxes[std::size_t(b)].contains(p)) all_around.push_back(b);
            if (is_beyond(boxes[std::size_t(b)])) all_beyond.push_back(b);
        }
        std::sort(around.begin(), around.end());
        std::sort(beyond.begin(), beyond.end());
        CHECK(around == all_around);
        CHECK(beyond == all_beyond);
    }
}

TEST_CASE("boxes with nothing in them are never met, and the tree is as without them") {
    std::vector<Box> boxes;
    for (int i = 0; i < 60; ++i) {
        boxes.emplace_back();
        if (i % 3 == 0) boxes.push_back({{double(i), 0, 0}, {i + 0.5, 1, 1}});
    }
    const BoxTree tree(boxes);
    std::size_t met = 0, entered = 0;
    const auto enters = [&](const Box&) { return ++entered, true; };
    tree.visit_where(enters, [&](std::int32_t b) {
        CHECK_FALSE(boxes[std::size_t(b)].is_empty());
        ++met;
    });
    CHECK(met == 20);
    CHECK(entered < 40);
    CHECK(BoxTree(std::vector<Box>(9)).box().is_empty());
}

TEST_CASE("a tree of boxes finds what is nearest, and of equals the first") {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> place(0, 100);
    std::vector<Vec3> points;
    for (int i = 0; i < 300; ++i) points.push_back({place(random), place(random), place(random)});
    points.insert(points.end(), points.begin(), points.begin() + 100);  // a hundred are there twice
    std::vector<Box> boxes(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) boxes[i].add(points[i]);
    const BoxTree tree(boxes);
    for (int i = 0; i < 200; ++i) {
        const Vec3 p{place(random), place(random), place(random)};
        const auto distance = [&](std::int32_t b) { return squared_length(points[std::size_t(b)] - p); };
        std::int32_t nearest = 0;
        for (std::int32_t b = 0; b < std::int32_t(points.size()); ++b)
            if (distance(b) < distance(nearest)) nearest = b;
        CHECK(tree.nearest(p, distance) == nearest);
        const double least = distance(nearest);
        CHECK(tree.least_distance(p, 1e9, 0, distance) == least);
        CHECK(tree.least_distance(p, 0.5 * least, 0, distance) == 0.5 * least);
        const double enough = 2 * least, found = tree.least_distance(p, 1e9, enough, distance);
        CHECK((found >= least && found < enough));
    }
}

TEST_CASE("something is nearest to a point so far away that its distances are infinite, too") {
    const std::array<Box, 2> boxes{Box{{0, 0, 0}, {1, 1, 1}}, Box{{2, 0, 0}, {3, 1, 1}}};
    const auto distance = [&](std::int32_t i) {
        return squared_distance_to_box({1e200, 0, 0}, boxes[static_cast<std::size_t>(i)]);
    };
    CHECK(BoxTree(boxes).nearest({1e200, 0, 0}, distance) >= 0);
}

TEST_CASE("a tree without boxes finds nothing") {
    const BoxTree tree({});
    int found = 0;
    tree.visit_around({0, 0, 0}, [&](std::int32_t) { ++found; });
    CHECK(found == 0);
    CHECK(tree.nearest({0, 0, 0}, [](std::int32_t) { return 0.0; }) == -1);
    CHECK(tree.least_distance({0, 0, 0}, 3, 0, [](std::int32_t) { return 0.0; }) == 3);
}

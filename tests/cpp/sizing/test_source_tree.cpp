// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include "catch.h"
#include "sizing/source_tree.h"

using namespace featuremesh;

namespace {
std::vector<SourceBall> random_balls(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(0, 100), radius(0, 3), size(0.5, 4);
    std::vector<SourceBall> balls;
    for (int i = 0; i < count; ++i)
        balls.push_back({{coordinate(random), coordinate(random), coordinate(random)}, radius(random), size(random)});
    return balls;
}
}  // namespace

TEST_CASE("the tree finds the minimum over all balls") {
    const double slope = 0.3, limit = 9;
    for (int count : {1, 3, 40, 3000}) {
        const auto balls = random_balls(count, 17);
        // half of the queries fall out of the box
        const SourceTree tree(balls, slope, limit, {{0, 0, 0}, {100, 100, 60}});
        std::mt19937 random(4);
        std::uniform_real_distribution<double> coordinate(-20, 120);
        for (int i = 0; i < 400; ++i) {
            const Vec3 p{coordinate(random), coordinate(random), coordinate(random)};
            double wanted = limit;
            for (const SourceBall& ball : balls)
                wanted = std::min(wanted, ball.size + slope * std::max(0.0, distance(p, ball.center) - ball.radius));
            REQUIRE(tree.at(p) == Approx(wanted).epsilon(1e-12));
        }
    }
}

TEST_CASE("without sources, and without growth") {
    CHECK(SourceTree({}, 0.3, 5.0, Box{}).empty());
    CHECK(SourceTree({}, 0.3, 5.0, Box{}).at({1, 2, 3}) == 5.0);
    const SourceTree flat({{{0, 0, 0}, 0, 2}, {{9, 0, 0}, 0, 3}}, 0.0, 5.0, {{-200, -200, -200}, {200, 200, 200}});
    CHECK(flat.at({100, 100, 100}) == Approx(2.0));
    CHECK(flat.at({300, 100, 100}) == Approx(2.0));
}

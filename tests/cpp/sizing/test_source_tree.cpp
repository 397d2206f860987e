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
        const SourceTree tree(balls, slope, limit);
        std::mt19937 random(4);
        std::uniform_real_distribution<double> near(-20, 120), far(-2000, 2000);
        for (int i = 0; i < 400; ++i) {
            auto& coordinate = i % 10 ? near : far;
            const Vec3 p{coordinate(random), coordinate(random), coordinate(random)};
            double wanted = limit;
            for (const SourceBall& ball : balls)
                wanted = std::min(wanted, ball.size + slope * std::max(0.0, distance(p, ball.center) - ball.radius));
            REQUIRE(tree.at(p) == Approx(wanted).epsilon(1e-12));
        }
    }
}

TEST_CASE("an answer does not depend on what was asked before, nor of which tree") {
    const double slope = 0.3, limit = 9;
    const Vec3 far_off{1e6, 0, 0};
    const SourceTree many(random_balls(3000, 17), slope, limit), few(random_balls(40, 3), slope, limit),
        none({{{50, 50, 50}, 0, 1}}, slope, limit);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> coordinate(-20, 120), step(-1, 1), length(0, 1);
    for (int walk = 0; walk < 40; ++walk) {
        Vec3 p{coordinate(random), coordinate(random), coordinate(random)};
        const double reach = std::pow(10, 2 - 4 * length(random));  // from steps across the whole to tiny ones
        for (int i = 0; i < 30; ++i) {
            p += reach * Vec3{step(random), step(random), step(random)};
            const double in_turn[] = {many.at(p), few.at(p), none.at(p), many.at(p)};
            const SourceTree* trees[] = {&many, &few, &none, &many};
            for (int k = 0; k < 4; ++k) {
                trees[k]->at(far_off);
                REQUIRE(trees[k]->at(p) == in_turn[k]);
            }
            REQUIRE(many.at(p) == in_turn[0]);
        }
    }
}

TEST_CASE("sources far from the origin and of very different sizes are told apart") {
    const double slope = 0.2, limit = 1e3;
    for (const double scale : {1e-3, 1.0, 1e3}) {
        std::vector<SourceBall> balls = random_balls(500, 23);
        for (std::size_t i = 0; i < balls.size(); ++i) {
            balls[i].center = balls[i].center * scale + Vec3{1e5, -1e5, 3e5};
            balls[i].radius = i % 2 ? 0 : balls[i].radius * scale;
            balls[i].size *= i % 7 ? scale : 1e-3 * scale;
        }
        const SourceTree tree(balls, slope, limit * scale);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> coordinate(-10, 110);
        for (int i = 0; i < 300; ++i) {
            const Vec3 p =
                Vec3{coordinate(random), coordinate(random), coordinate(random)} * scale + Vec3{1e5, -1e5, 3e5};
            double wanted = limit * scale;
            for (const SourceBall& ball : balls)
                wanted = std::min(wanted, ball.size + slope * std::max(0.0, distance(p, ball.center) - ball.radius));
            REQUIRE(tree.at(p) == Approx(wanted).epsilon(1e-12));
        }
    }
}

TEST_CASE("without sources, and without growth") {
    CHECK(SourceTree({}, 0.3, 5.0).empty());
    CHECK(SourceTree({}, 0.3, 5.0).at({1, 2, 3}) == 5.0);
    const SourceTree flat({{{0, 0, 0}, 0, 2}, {{9, 0, 0}, 0, 3}}, 0.0, 5.0);
    CHECK(flat.at({100, 100, 100}) == Approx(2.0));
    CHECK(flat.at({300, 100, 100}) == Approx(2.0));
}

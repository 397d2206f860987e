// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include "catch.h"
#include "core/distances.h"

using namespace featuremesh;

namespace {

class RandomPoints {
  public:
    explicit RandomPoints(unsigned seed) : random_(seed) {}
    Vec3 point() { return {unit_(random_), unit_(random_), unit_(random_)}; }
    double share() { return 0.5 + 0.5 * unit_(random_); }

  private:
    std::mt19937 random_;
    std::uniform_real_distribution<double> unit_{-1, 1};
};

double least_of_many(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    double least = 1e300;
    for (int i = 0; i <= 200; ++i)
        for (int j = 0; i + j <= 200; ++j)
            least = std::min(least, distance(p, a + (b - a) * (i / 200.0) + (c - a) * (j / 200.0)));
    return least;
}

double least_of_sides(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::min({squared_distance_to_segment(p, a, b), squared_distance_to_segment(p, b, c),
                     squared_distance_to_segment(p, c, a)});
}

void check_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto [weights, squared] = nearest_in_triangle(p, a, b, c);
    for (const double weight : weights) CHECK(weight >= 0);
    CHECK(weights[0] + weights[1] + weights[2] == Approx(1));
    CHECK(distance(p, a * weights[0] + b * weights[1] + c * weights[2]) == Approx(std::sqrt(squared)).margin(1e-9));
}

}  // namespace

TEST_CASE("the distance to a triangle is that of brute force") {
    RandomPoints random(7);
    for (int trial = 0; trial < 50; ++trial) {
        const Vec3 a = random.point(), b = random.point(), c = random.point(), p = random.point();
        const double least = least_of_many(p, a, b, c), found = std::sqrt(squared_distance_to_triangle(p, a, b, c));
        CHECK(found <= least + 1e-12);
        CHECK(found > least - 0.02);
        check_weights(p, a, b, c);
    }
}

TEST_CASE("the distance to a triangle without area is that to its sides") {
    RandomPoints random(8);
    for (int trial = 0; trial < 300; ++trial) {
        const Vec3 a = random.point(), b = random.point(), p = random.point() * 2, c = a + (b - a) * random.share();
        for (const auto& [u, v, w] :
             {std::array{a, b, c}, {b, c, a}, {c, a, b}, {a, c, b}, {a, a, b}, {a, b, b}, {a, b, a}, {a, a, a}}) {
            CHECK(squared_distance_to_triangle(p, u, v, w) == Approx(least_of_sides(p, u, v, w)));
            check_weights(p, u, v, w);
        }
    }
}

TEST_CASE("the distance to a needle is that to its long side, but for its width") {
    RandomPoints random(9);
    for (const double width : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15})
        for (int trial = 0; trial < 100; ++trial) {
            const Vec3 a = random.point(), b = random.point(), p = random.point() * 2;
            const Vec3 c = a + (b - a) * random.share() + random.point() * width;
            const double to_side = std::sqrt(squared_distance_to_segment(p, a, b));
            CHECK(std::abs(std::sqrt(squared_distance_to_triangle(p, a, b, c)) - to_side) <= 2 * width + 1e-12);
        }
}

TEST_CASE("the distance to a box is none within it, and that to its nearest corner, edge or side outside") {
    const Box box{{0, 0, 0}, {1, 2, 3}};
    CHECK(squared_distance_to_box({0.5, 0, 3}, box) == 0);
    CHECK(squared_distance_to_box({0.5, 1, 5}, box) == 4);
    CHECK(squared_distance_to_box({-1, 1, 5}, box) == 5);
    CHECK(squared_distance_to_box({2, 3, -1}, box) == 3);
}

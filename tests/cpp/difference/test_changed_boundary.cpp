// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include "catch.h"
#include "difference/feature_difference.h"

using namespace featuremesh;

namespace {
using Triangle = std::array<Vec3, 3>;

std::vector<Triangle> random_triangles(std::size_t count, double size, std::mt19937& random) {
    std::uniform_real_distribution<double> at(0, 100), step(-size, size);
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 a{at(random), at(random), at(random)};
        triangles.push_back({a, a + Vec3{step(random), step(random), step(random)},
                             a + Vec3{step(random), step(random), step(random)}});
    }
    return triangles;
}

/// By sampling the triangle ever more finely around the best point.
double brute_force(const Vec3& p, const Triangle& t) {
    double s0 = 0, t0 = 0, width = 1, best = 1e300;
    for (int level = 0; level < 30; ++level, width *= 0.6) {
        double best_s = s0, best_t = t0;
        for (int i = -4; i <= 4; ++i)
            for (int j = -4; j <= 4; ++j) {
                const double s = std::clamp(s0 + width * i / 4, 0.0, 1.0);
                const double r = std::clamp(t0 + width * j / 4, 0.0, 1.0 - s);
                const double d = distance(p, t[0] + (t[1] - t[0]) * s + (t[2] - t[0]) * r);
                if (d < best) best = d, best_s = s, best_t = r;
            }
        s0 = best_s, t0 = best_t;
    }
    return best;
}
}  // namespace

TEST_CASE("the distance agrees with sampling the triangles") {
    std::mt19937 random(7);
    std::vector<Triangle> triangles = random_triangles(40, 15, random);
    triangles.push_back({Vec3{5, 5, 5}, Vec3{5, 5, 5}, Vec3{9, 5, 5}});  // without area
    const ChangedBoundary changed(triangles);
    std::uniform_real_distribution<double> at(-20, 120);
    for (int i = 0; i < 60; ++i) {
        const Vec3 p{at(random), at(random), at(random)};
        double expected = 1e300;
        for (const Triangle& t : triangles) expected = std::min(expected, brute_force(p, t));
        CHECK(changed.distance(p, 1e9) == Approx(expected).epsilon(1e-4).margin(1e-4));
        CHECK(changed.distance(p, 3.0) == Approx(std::min(3.0, expected)).epsilon(1e-4).margin(1e-4));
    }
}

TEST_CASE("what is within reach is closer than it") {
    std::mt19937 random(17);
    const std::vector<Triangle> triangles = random_triangles(300, 4, random);
    const ChangedBoundary everywhere(triangles), in_box(triangles, Box{{20, 20, 20}, {80, 80, 80}});
    std::uniform_real_distribution<double> at(-10, 110), reach(0, 12);
    int within = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p{at(random), at(random), at(random)};
        const double r = reach(random);
        CHECK(everywhere.is_within(r, p) == (everywhere.distance(p, r) < r));
        CHECK(in_box.is_within(r, p) == (in_box.distance(p, r) < r));
        within += everywhere.is_within(r, p);
    }
    CHECK((within > 100 && within < 1900));
}

TEST_CASE("of one surface only what changed there is within reach") {
    std::mt19937 random(27);
    const std::vector<std::size_t> ends{7, 7, 90, 91, 300};  // the second surface has nothing that changed
    const std::vector<Triangle> triangles = random_triangles(ends.back(), 4, random);
    const ChangedBoundary all(triangles, ends);
    std::uniform_real_distribution<double> at(-10, 110), reach(0, 30);
    std::size_t within = 0;
    for (std::size_t s = 0; s < ends.size(); ++s) {
        const auto begin = triangles.begin() + std::ptrdiff_t(s == 0 ? 0 : ends[s - 1]);
        const ChangedBoundary alone(std::vector<Triangle>(begin, triangles.begin() + std::ptrdiff_t(ends[s])));
        for (int i = 0; i < 200; ++i) {
            const Vec3 p{at(random), at(random), at(random)};
            const double r = reach(random);
            CHECK(all.is_within(r, p, s) == alone.is_within(r, p));
            within += all.is_within(r, p, s);
        }
    }
    CHECK(within > 100);
    CHECK(within < 900);
}

TEST_CASE("nothing changed is as far as the limit") {
    const ChangedBoundary nothing;
    CHECK_FALSE(nothing.is_within(7.5, {1, 2, 3}));
    CHECK(nothing.is_empty());
    CHECK(nothing.box().is_empty());
    CHECK(nothing.distance({1, 2, 3}, 7.5) == 7.5);
}

TEST_CASE("outside its domain everything counts as changed") {
    const ChangedBoundary changed({}, Box{{0, 0, 0}, {10, 10, 10}});
    CHECK_FALSE(changed.is_empty());
    CHECK(changed.box().contains({1e6, -1e6, 0}));
    CHECK(changed.distance({-1, 5, 5}, 3) == 0);
    CHECK(changed.distance({2, 5, 5}, 3) == Approx(2));
    CHECK(changed.distance({5, 5, 5}, 3) == 3);
}

TEST_CASE("a limit cuts the distance off and changes nothing else") {
    std::mt19937 random(11);
    const ChangedBoundary changed(random_triangles(1000, 1.5, random));
    std::uniform_real_distribution<double> at(0, 100);
    int near = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p{at(random), at(random), at(random)};
        const double whole = changed.distance(p, 1e9);
        near += whole < 2;
        CHECK(changed.distance(p, 2.0) == std::min(whole, 2.0));
    }
    CHECK(near > 10);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "catch.h"
#include "volume/improvement/objective.h"
#include "volume/tets/flatness_of_four.h"
#include "volume/tets/tet_measures.h"

using namespace featuremesh;

namespace {

/// Tets of all kinds: good, turned over, flat, and with a point next to a corner.
class RandomTets {
  public:
    Vec3 point() { return {share_(random_), share_(random_), share_(random_)}; }
    SeenTriangle triangle(const Vec3& seen_from) {
        SeenTriangle made{{point(), point(), point()}};
        if (random_() % 4 == 0) made.corners[2].z = 1e-9 * made.corners[2].z + seen_from.z;
        if (random_() % 8 == 0) made.corners[0] = seen_from + 1e-5 * made.corners[0];
        return made;
    }

  private:
    std::mt19937 random_{7};
    std::uniform_real_distribution<double> share_{-1, 1};
};

/// A hair above the least volume, or of a height far below the longest side.
bool is_near_thin(const std::array<Vec3, 4>& p, const PlainTets& plain) {
    const double longest = 2 * std::max({distance(p[0], p[1]), distance(p[0], p[2]), distance(p[0], p[3])});
    const double volume = signed_volume(p[0], p[1], p[2], p[3]);
    return volume < 1.001 * plain.least_volume || 6 * volume < 1.001 * plain.least_share * std::pow(longest, 3);
}

}  // namespace

TEST_CASE("four tets at a time have the flatness, to the bit, that each has by itself") {
    constexpr double least_volume = 1e-4;
    const Objective objective({.least_volume = least_volume});
    const PlainTets plain = objective.plain_tets();
    RandomTets random;
    std::size_t plain_count = 0, special = 0;
    for (int round = 0; round < 400; ++round) {
        const Vec3 point = random.point();
        std::array<SeenTriangle, 4> triangles;
        FourTriangles four;
        for (std::size_t i = 0; i < 4; ++i) four.set(i, triangles[i] = random.triangle(point));
        const std::array<double, 4> found = flatness_of_four(point, four, plain);
        REQUIRE(found == flatness_by_parts(point, four, plain));
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& [a, b, c] = triangles[i].corners;
            if (found[i] < 0) {
                ++special;
                CHECK((flatness(point, a, b, c) >= plain.flatness || is_near_thin({point, a, b, c}, plain)));
            } else {
                ++plain_count;
                CHECK(found[i] == flatness(point, a, b, c));
                CHECK(found[i] == objective.flaw({point, a, b, c}, {true, true, true, true}));
                CHECK(signed_volume(point, a, b, c) >= least_volume);
            }
        }
    }
    CHECK(plain_count > 400);
    CHECK(special > 400);
}

TEST_CASE("a run of fours ends at the first tet that is not plain, or as flat as the limit") {
    const PlainTets plain = Objective({.least_volume = 1e-4}).plain_tets();
    RandomTets random;
    std::size_t whole = 0;
    for (int round = 0; round < 400; ++round) {
        const Vec3 point = random.point();
        std::vector<FourTriangles> fours(3);
        for (FourTriangles& four : fours)
            for (std::size_t i = 0; i < 4; ++i) {
                SeenTriangle triangle = random.triangle(point);
                const auto& [a, b, c] = triangle.corners;
                if (signed_volume(point, a, b, c) < 0) std::swap(triangle.corners[0], triangle.corners[1]);
                four.set(i, triangle);
            }
        const double limit = round % 2 == 0 ? 0.9 : 2;
        const auto ends = [&](double flatness) { return flatness < 0 || flatness >= limit; };
        std::size_t end = 0;
        double most = 0;
        for (; end < fours.size(); ++end) {
            const auto found = flatness_of_four(point, fours[end], plain);
            if (std::any_of(found.begin(), found.end(), ends)) break;
            most = std::max(most, *std::max_element(found.begin(), found.end()));
        }
        const PlainRun run = plain_run(point, fours, 0, plain, limit);
        CHECK(run.end == end);
        CHECK(run.most == most);
        if (end == fours.size())
            ++whole;
        else
            CHECK(run.flatness == flatness_of_four(point, fours[end], plain));
    }
    CHECK(whole > 0);
    CHECK(whole < 400);
}

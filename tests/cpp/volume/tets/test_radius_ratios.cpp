// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/tets/radius_ratios.h"

#include <array>
#include <vector>

#include "catch.h"
#include "mesh/quality.h"

using namespace featuremesh;

TEST_CASE("radius ratios of tets round a point, and the way in which they grow") {
    const std::vector<SeenTriangle> seen{{{{{1, 0, 0}, {0.1, 1.2, 0}, {0, 0.1, 0.9}}}},
                                         {{{{0, 1, 0.2}, {-1, 0.1, 0}, {0.1, 0, 1.1}}}}};
    const Vec3 p{-0.1, 0.05, -0.2};
    const RadiusRatios ratios = radius_ratios(p, seen);
    double expected = 0;
    for (const SeenTriangle& t : seen) expected += radius_ratio(p, t.corners[0], t.corners[1], t.corners[2]);
    CHECK(ratios.sum == Approx(expected));
    CHECK(sum_of_radius_ratios(p, seen) == Approx(ratios.sum));
    const double h = 1e-5;
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        const double rise = sum_of_radius_ratios(p + h * axis, seen) - sum_of_radius_ratios(p - h * axis, seen);
        CHECK(dot(ratios.gradient, axis) == Approx(rise / (2 * h)).margin(1e-6));
    }
    CHECK(sum_of_radius_ratios({5, 5, 5}, seen) == 0);
}

TEST_CASE("each tet counts once, and by itself, whether their number is odd or even") {
    const Vec3 p{-0.1, 0.05, -0.2};
    const std::vector<SeenTriangle> all{{{{{1, 0, 0}, {0.1, 1.2, 0}, {0, 0.1, 0.9}}}},
                                        {{{{0, 1, 0.2}, {-1, 0.1, 0}, {0.1, 0, 1.1}}}},
                                        {{{{0.1, 1.2, 0}, {1, 0, 0}, {0, 0.1, 0.9}}}},  // turned: no volume
                                        {{{{0.9, 0.1, 0}, {0.2, 1.3, 0}, {0, 0.2, 0.8}}}},
                                        {{{{0, 1.1, 0.1}, {-1, 0.2, 0}, {0.2, 0, 1.2}}}}};
    std::vector<SeenTriangle> seen;
    RadiusRatios sum;
    for (const SeenTriangle& triangle : all) {
        seen.push_back(triangle);
        const RadiusRatios alone = radius_ratios(p, std::array{triangle}), together = radius_ratios(p, seen);
        sum.sum += alone.sum;
        sum.gradient += alone.gradient;
        CHECK(together.sum == sum.sum);  // to the last bit
        CHECK(together.gradient == sum.gradient);
        CHECK(sum_of_radius_ratios(p, seen) == sum.sum);
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "catch.h"
#include "volume/tets/needles.h"
#include "volume/tets/tet_measures.h"

using namespace featuremesh;

namespace {

constexpr std::array<bool, 4> all_on_boundary{true, true, true, true}, none_on_boundary{};

double unforced(const std::array<Vec3, 4>& tet, const std::array<bool, 4>& is_on_boundary) {
    return unforced_flatness(flatness(tet[0], tet[1], tet[2], tet[3]), tet, is_on_boundary);
}

}  // namespace

TEST_CASE("the angle opposite a needle's short side does not count") {
    const std::array<Vec3, 4> needle{{{0, 0, 0}, {1e-4, 0, 0}, {0.3, 1, -0.6}, {-0.2, 0.8, 0.7}}};
    const double all = flatness(needle[0], needle[1], needle[2], needle[3]);
    REQUIRE(angle_of_flatness(all) < 0.01);
    CHECK(angle_of_flatness(unforced(needle, all_on_boundary)) > 20);
    CHECK(unforced(needle, none_on_boundary) == all);
    CHECK(unforced(needle, {true, false, true, true}) == all);
}

TEST_CASE("a needle without volume stays the worst there is") {
    const std::array<Vec3, 4> flat{{{0, 0, 0}, {1e-4, 0, 0}, {0.3, 1, 0}, {-0.2, 0.8, 0}}};
    CHECK(unforced(flat, all_on_boundary) == inverted_flatness);
}

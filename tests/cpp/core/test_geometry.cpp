// SPDX-License-Identifier: GPL-3.0-or-later
#include "catch.h"
#include "core/geometry.h"

using namespace featuremesh;

namespace {
RigidMotion quarter_turn_about_z() {
    RigidMotion m;
    m.rotation = {0, -1, 0, 1, 0, 0, 0, 0, 1};
    m.translation = {1, 2, 3};
    return m;
}
}  // namespace

TEST_CASE("the identity maps a point to the same bits") {
    const Vec3 p{0.1, -0.0, 1e300};
    const Vec3 q = RigidMotion{}.apply(p);
    CHECK(q == p);
    CHECK(std::signbit(q.y));
}

TEST_CASE("a motion and its inverse cancel") {
    const RigidMotion m = quarter_turn_about_z();
    CHECK(m.apply({1, 0, 0}) == Vec3{1, 3, 3});
    CHECK(distance(m.inverse().apply(m.apply({4, 5, 6})), {4, 5, 6}) < 1e-14);
    CHECK(distance(compose(m, m).apply({1, 0, 0}), m.apply(m.apply({1, 0, 0}))) < 1e-14);
}

TEST_CASE("signed volume of the unit corner tet") {
    CHECK(signed_volume({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == Approx(1.0 / 6));
    CHECK(signed_volume({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}) == Approx(-1.0 / 6));
}

TEST_CASE("an empty box contains nothing and adds nothing") {
    Box box;
    CHECK(box.is_empty());
    CHECK_FALSE(box.contains({0, 0, 0}));
    box.add(Box{});
    CHECK(box.is_empty());
    box.add(Vec3{1, 1, 1});
    CHECK(box.contains({1, 1, 1}));
    CHECK(box.grown(0.5).overlaps(Box{{1.4, 1, 1}, {2, 2, 2}}));
}

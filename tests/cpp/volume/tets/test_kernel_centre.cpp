// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/tets/kernel_centre.h"

#include <cmath>
#include <vector>

#include "catch.h"

using namespace featuremesh;

namespace {

using Triangles = std::vector<std::array<Vec3, 3>>;

/// The sides of a tet as a point within sees them.
Triangles sides(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return {{a, c, b}, {a, b, d}, {b, c, d}, {a, d, c}};
}

}  // namespace

TEST_CASE("a tet's kernel centre is the centre of the ball within") {
    const double side = (3 - std::sqrt(3.0)) / 6;
    for (const double scale : {1.0, 1e-9}) {
        const Vec3 foot{7, 8, 9};
        const Vec3 at[] = {foot, foot + Vec3{scale, 0, 0}, foot + Vec3{0, scale, 0}, foot + Vec3{0, 0, scale}};
        const auto centre = kernel_centre(sides(at[0], at[1], at[2], at[3]), foot, 2 * scale);
        REQUIRE(centre);
        CHECK(distance(*centre, foot + Vec3{side, side, side} * scale) < 1e-6 * scale + 4e-15);
    }
}

TEST_CASE("without a point that sees every triangle there is no kernel centre") {
    const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
    Triangles triangles = sides(a, b, c, d);
    CHECK(kernel_centre(triangles, a, 2).has_value());
    CHECK_FALSE(kernel_centre(triangles, {5, 5, 5}, 1).has_value());
    Triangles with_line = triangles;
    with_line.push_back({a, b, b});
    CHECK_FALSE(kernel_centre(with_line, a, 2).has_value());
    triangles.push_back({{{2, 0, 0}, {2, 0, 1}, {2, 1, 0}}});  // seen from x > 2
    CHECK_FALSE(kernel_centre(triangles, a, 9).has_value());
}

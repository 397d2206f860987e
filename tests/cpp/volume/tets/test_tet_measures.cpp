// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>

#include "catch.h"
#include "volume/tets/box_of_tets.h"

using namespace featuremesh;

namespace {

constexpr double pi = 3.14159265358979323846;

/// min(smallest, 180 - largest) of the dihedral angles, degrees, the slow way.
double worst_angle(const std::array<Vec3, 4>& p) {
    double worst = 180;
    for (const auto& [i, j] : edge_corners) {
        const auto& [k, l] = opposite_edge[i][j];
        const Vec3 along = normalized(p[j] - p[i]);
        const Vec3 a = p[k] - p[i] - dot(p[k] - p[i], along) * along, b = p[l] - p[i] - dot(p[l] - p[i], along) * along;
        const double angle = std::acos(dot(a, b) / (length(a) * length(b))) * 180 / pi;
        worst = std::min({worst, angle, 180 - angle});
    }
    return worst;
}

std::array<Vec3, 4> random_tet(std::mt19937& random) {
    std::uniform_real_distribution<double> c(0, 1);
    std::array<Vec3, 4> p;
    do
        for (Vec3& v : p) v = {c(random), c(random), c(random)};
    while (signed_volume(p[0], p[1], p[2], p[3]) < 1e-3);
    return p;
}

}  // namespace

TEST_CASE("the tables of corners keep the orientation") {
    const auto is_even = [](const Tet& p) {
        int inversions = 0;
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j) inversions += p[i] > p[j];
        return inversions % 2 == 0;
    };
    for (int i = 0; i < 4; ++i) {
        const auto& f = opposite_face[i];
        CHECK(is_even({i, f[0], f[1], f[2]}));
        for (int j = 0; j < 4; ++j)
            if (i != j) CHECK(is_even({i, j, opposite_edge[i][j][0], opposite_edge[i][j][1]}));
    }
}

TEST_CASE("flatness is the squared cosine of the worst dihedral angle") {
    std::mt19937 random(7);
    for (int round = 0; round < 1000; ++round) {
        const auto p = random_tet(random);
        REQUIRE(angle_of_flatness(flatness(p[0], p[1], p[2], p[3])) == Approx(worst_angle(p)).epsilon(1e-6));
        REQUIRE(flatness(p[1], p[0], p[2], p[3]) == inverted_flatness);
    }
    CHECK(flatness({1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}) == Approx(1.0 / 9));
    CHECK(angle_of_flatness(flatness_of_angle(30)) == Approx(30));
    CHECK(angle_of_flatness(flatness_of_angle(150)) == Approx(30));
}

TEST_CASE("the ODT energy is V S / 20 and the paraboloid's gap") {
    std::mt19937 random(8);
    for (int round = 0; round < 100; ++round) {
        const auto p = random_tet(random);
        double squares = 0;
        for (const auto& [i, j] : edge_corners) squares += squared_length(p[i] - p[j]);
        const double volume = signed_volume(p[0], p[1], p[2], p[3]);
        REQUIRE(odt_energy(p[0], p[1], p[2], p[3]) == Approx(volume * squares / 20));
        // quadrature of second order: the gap between |x|^2 and its linear interpolation
        const double a = 0.58541019662496852, b = 0.1381966011250105;
        double gap = 0;
        for (int i = 0; i < 4; ++i) {
            Vec3 x{};
            double linear = 0;
            for (int j = 0; j < 4; ++j) {
                x += (i == j ? a : b) * p[j];
                linear += (i == j ? a : b) * squared_length(p[j]);
            }
            gap += volume / 4 * (linear - squared_length(x));
        }
        REQUIRE(odt_energy(p[0], p[1], p[2], p[3]) == Approx(gap));
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/levelled_points.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "../../mesh/box_mesh.h"
#include "catch.h"

using namespace featuremesh;

namespace {

constexpr int cubes = 4;

/// The box, 1 x 1 x 1, turned about an axis across none of its planes, and away from the origin.
Mesh turned_box(double angle) {
    Mesh mesh = box_mesh(cubes);
    const Vec3 axis = normalized({1, 2, 3});
    for (Vec3& p : mesh.points) {
        p = std::cos(angle) * p + std::sin(angle) * cross(axis, p) + (1 - std::cos(angle)) * dot(axis, p) * axis;
        p = p + Vec3{17.3, -5.9, 0.7};
    }
    return mesh;
}

Cavity cavity_of(Mesh mesh) {
    mesh.tets.clear(), mesh.tet_solids.clear(), mesh.tet_numbers.clear();
    const std::vector<std::array<SolidId, 2>> outer_faces(6, {SolidId(0), SolidId()});
    return find_cavity(mesh, outer_faces);
}

/// How many places along each axis the points have.
std::array<std::size_t, 3> places_along(const std::vector<Vec3>& points) {
    std::array<std::size_t, 3> counts{};
    for (int k = 0; k < 3; ++k) {
        std::set<double> places;
        for (const Vec3& p : points) places.insert(p[k]);
        counts[k] = places.size();
    }
    return counts;
}

}  // namespace

TEST_CASE("in the frame of its facets a turned box has its planes exactly, but for less than counts where it was") {
    const double angle = GENERATE(0.0, 0.3, 1.1, 2.7);
    const double noise = GENERATE(0.0, 2e-11);
    INFO("angle " << angle << ", noise " << noise << ", seed 5");
    Mesh mesh = turned_box(angle);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> by(-noise, noise);
    for (Vec3& p : mesh.points) p = p + Vec3{by(random), by(random), by(random)};
    const Cavity cavity = cavity_of(mesh);
    std::vector<Vec3> points = cavity.points;
    for (std::size_t n = 0; n < mesh.node_count(); ++n)
        if (mesh.entities[n].dim == 3) points.push_back(mesh.points[n]);
    const std::vector<Vec3> levelled = levelled_points(cavity, points).value();
    REQUIRE(levelled.size() == points.size());
    CHECK(places_along(levelled) == std::array<std::size_t, 3>{cubes + 1, cubes + 1, cubes + 1});
    double worst = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            worst = std::max(worst, std::abs(distance(levelled[i], levelled[j]) - distance(points[i], points[j])));
    CHECK(worst < 1e-9);
}

TEST_CASE("the frame that points are levelled in is right-handed, so that volumes keep their signs") {
    const Mesh mesh = turned_box(0.8);
    const Cavity cavity = cavity_of(mesh);
    const std::vector<Vec3> levelled = levelled_points(cavity, mesh.points).value();
    double worst = 0;
    for (const auto& tet : mesh.tets) {
        const auto at = [&](int corner) { return levelled[tet[corner].index()]; };
        const double volume = signed_volume(at(0), at(1), at(2), at(3));
        worst = std::max(worst, std::abs(volume - 1.0 / (6 * cubes * cubes * cubes)));
    }
    CHECK(worst < 1e-9);
}

TEST_CASE("what is off a plane by more than counts stays off it") {
    const Mesh mesh = turned_box(0.8);
    const Cavity cavity = cavity_of(mesh);
    std::vector<Vec3> points = cavity.points;
    points.push_back(points.front() + 1e-6 * normalized({1, -2, 0.5}));
    const std::vector<Vec3> levelled = levelled_points(cavity, points).value();
    CHECK(distance(levelled.front(), levelled.back()) == Approx(1e-6));
}

TEST_CASE("where two points would become one nothing is levelled") {
    const Mesh mesh = turned_box(0.8);
    const Cavity cavity = cavity_of(mesh);
    std::vector<Vec3> points = cavity.points;
    REQUIRE(levelled_points(cavity, points).has_value());
    points.push_back(points.front() + 1e-12 * normalized({1, -2, 0.5}));
    CHECK_FALSE(levelled_points(cavity, points).has_value());
}

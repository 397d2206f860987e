// SPDX-License-Identifier: GPL-3.0-or-later
// Points enough to be divided: the parts' tets joined are those of all points at once.
#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"
#include "core/errors.h"
#include "mesh/second_order.h"
#include "volume/delaunay/triangulation.h"

using namespace featuremesh;

namespace {

std::vector<std::array<int, 4>> sorted(std::vector<std::array<int, 4>> tets) {
    for (auto& tet : tets) std::sort(tet.begin(), tet.end());
    std::sort(tets.begin(), tets.end());
    return tets;
}

std::array<int, 3> side(const std::array<int, 4>& tet, int k) {
    std::array<int, 3> corners{tet[tet_faces[k][0]], tet[tet_faces[k][1]], tet[tet_faces[k][2]]};
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// Each side has the tet beyond it as neighbour, which knows it, too; sides without one have no double.
bool are_linked(const Triangulation& t) {
    std::vector<std::array<int, 3>> hull;
    for (std::size_t i = 0; i < t.tets.size(); ++i)
        for (int k = 0; k < 4; ++k) {
            const int other = t.neighbours[i][k];
            if (other < 0) {
                hull.push_back(side(t.tets[i], k));
                continue;
            }
            bool is_known = false;
            for (int m = 0; m < 4; ++m)
                is_known |=
                    t.neighbours[other][m] == static_cast<int>(i) && side(t.tets[other], m) == side(t.tets[i], k);
            if (!is_known) return false;
        }
    std::sort(hull.begin(), hull.end());
    return std::adjacent_find(hull.begin(), hull.end()) == hull.end();
}

void check_against_the_whole(const std::vector<Vec3>& points) {
    RunContext context;
    GrowingDelaunay whole;
    whole.insert(points, context);
    const Triangulation joined = delaunay(points, context);
    CHECK(sorted(joined.tets) == sorted(whole.tets(context).tets));
    CHECK(are_linked(joined));
    for (const int threads : {2, 4}) {
        RunContext more;
        more.threads = threads;
        const Triangulation same = delaunay(points, more);
        CHECK(same.tets == joined.tets);
        CHECK(same.neighbours == joined.neighbours);
    }
}

std::vector<Vec3> grid(int nx, int ny, int nz) {
    std::vector<Vec3> points;
    for (int x = 0; x < nx; ++x)
        for (int y = 0; y < ny; ++y)
            for (int z = 0; z < nz; ++z) points.push_back({double(x), double(y), double(z)});
    return points;
}

Vec3 turned(const Vec3& p) {
    const double c = std::cos(0.3), s = std::sin(0.3);
    const Vec3 q{c * p.x - s * p.y, s * p.x + c * p.y, p.z};
    return {c * q.x - s * q.z, q.y, s * q.x + c * q.z};
}

}  // namespace

TEST_CASE("divided points have the tets of the whole: at random") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Vec3> points;
    for (int i = 0; i < 52000; ++i) points.push_back({3 * unit(random), unit(random), 2 * unit(random)});
    check_against_the_whole(points);
}

TEST_CASE("divided points have the tets of the whole: a cubic lattice, eight on each sphere") {
    check_against_the_whole(grid(60, 30, 14));
}

TEST_CASE("divided points have the tets of the whole: a lattice that is turned") {
    std::vector<Vec3> points = grid(46, 24, 23);
    for (Vec3& p : points) p = turned(p);
    check_against_the_whole(points);
}

TEST_CASE("divided points have the tets of the whole: planes with space between them") {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Vec3> points = grid(90, 60, 1);
    for (int i = 0; i < 12000; ++i) points.push_back({90 * unit(random), 60 * unit(random), 20});
    for (int i = 0; i < 12000; ++i) points.push_back({90, 60 * unit(random), 20 * unit(random)});
    check_against_the_whole(points);
}

TEST_CASE("divided points have the tets of the whole: shells of balls") {
    std::mt19937 random(13);
    std::normal_distribution<double> normal;
    std::vector<Vec3> points;
    for (int i = 0; i < 25000; ++i) {
        const Vec3 way{normal(random), normal(random), normal(random)};
        points.push_back(way * ((i % 2 ? 1.0 : 0.8) / length(way)));
    }
    check_against_the_whole(points);
}

TEST_CASE("points that no cut divides, and two in the same place") {
    RunContext context;
    std::vector<Vec3> points = grid(150, 150, 1);
    CHECK(delaunay(points, context).tets.empty());
    for (int i = 0; i < 20000; ++i) points.push_back({0.5, 0.5, 1.0 + i});
    const Triangulation t = delaunay(points, context);
    CHECK(are_linked(t));
    points.push_back(points[77]);
    CHECK_THROWS_AS(delaunay(points, context), MeshError);
}

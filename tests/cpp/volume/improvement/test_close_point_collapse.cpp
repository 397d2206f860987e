// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>

#include "catch.h"
#include "volume/improvement/improved.h"

using namespace featuremesh;

namespace {

constexpr double target_deg = 30;

WantedSize uniform(double size) {
    return {[size](const Vec3&) { return size; }, size, true};
}

std::size_t collapse_close_points(TetComplex& complex, const WantedSize& size) {
    RunContext context;
    const Objective objective = objective_for(target_deg, 0, 1);
    LocalMesh mesh(complex);
    return improve(mesh, objective, list_of(close_point_collapse(mesh, objective, size)), {}, {}, context).changes;
}

/// Splits the vertex's tets by points of their own, a tenth of the way to the other corners' middle.
int add_close_points(TetComplex& complex, int vertex) {
    CavityEditor editor(complex);
    std::vector<int> star;
    REQUIRE(gather_star(complex, vertex, star));
    for (const int t : star) {
        const Tet tet = complex.tets[t];
        Vec3 middle{};
        for (const int c : tet) middle += complex.points[c] / 4;
        const int added = editor.add_vertex(complex.points[vertex] + 0.1 * (middle - complex.points[vertex]));
        std::array<Tet, 4> pieces{tet, tet, tet, tet};
        for (std::size_t k = 0; k < 4; ++k) pieces[k][k] = added;
        editor.replace(std::array{t}, pieces);
    }
    return static_cast<int>(star.size());
}

}  // namespace

TEST_CASE("points that stand close together are taken out, the rest stays as it is") {
    TetComplex box = box_of_tets(4, 0.1, 5);
    const TetComplex before = box;
    CHECK(collapse_close_points(box, uniform(1)) == 0);
    CHECK(box.tets == before.tets);

    const int centre = 62;  // of 5 x 5 x 5
    const int added = add_close_points(box, centre);
    REQUIRE(find_flaws(box).empty());
    const double worst = worst_flatness(box);
    const auto outside = outside_of(box);
    CHECK(collapse_close_points(box, uniform(1)) == static_cast<std::size_t>(added));
    CHECK(find_flaws(box).empty());
    CHECK(outside_of(box) == outside);
    CHECK(worst_flatness(box) <= worst);
    CHECK(total_volume(box) == Approx(64));
    CHECK(worst_flatness(box) == Approx(worst_flatness(before)));
}

TEST_CASE("points as close as the sizes ask for stay, and those that must") {
    TetComplex box = box_of_tets(4, 0.1, 5);
    add_close_points(box, 62);
    const TetComplex before = box;
    CHECK(collapse_close_points(box, uniform(0.05)) == 0);
    CHECK(box.tets == before.tets);
    box.mobility.assign(box.points.size(), Mobility::kept);
    CHECK(collapse_close_points(box, uniform(1)) == 0);
    CHECK(box.tets == before.tets);
}

TEST_CASE("no worst angle gets worse where points are taken out") {
    std::size_t gone = 0;
    for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
        TetComplex box = box_of_tets(5, 0.2, seed);
        for (Vec3& p : box.points) p.z *= 0.1;
        const double worst = worst_flatness(box), volume = total_volume(box);
        gone += collapse_close_points(box, uniform(3));  // they are all too close for that
        CHECK(find_flaws(box).empty());
        CHECK(worst_flatness(box) <= worst);
        CHECK(total_volume(box) == Approx(volume));
    }
    CHECK(gone > 0);
}

TEST_CASE("points beside needles stay") {
    TetComplex box = box_of_tets(2, 0, 1);
    box.points[1] = {0.001, 0, 0};  // on the edge from corner 0, which is fixed as well
    const int added = add_close_points(box, 13);
    REQUIRE(find_flaws(box).empty());
    std::vector<Tet> needles;
    for (const Tet& tet : box.tets)
        if (tet[0] >= 0 && objective_for(target_deg).is_excused(box, tet)) needles.push_back(tet);
    REQUIRE(!needles.empty());
    const std::size_t gone = collapse_close_points(box, uniform(1));
    CHECK(gone > 0);
    CHECK(gone < static_cast<std::size_t>(added));
    for (const Tet& tet : needles) CHECK(std::find(box.tets.begin(), box.tets.end(), tet) != box.tets.end());
}

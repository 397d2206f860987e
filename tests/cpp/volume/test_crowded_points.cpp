// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/crowded_points.h"

#include <numeric>

#include "catch.h"
#include "volume/box_of_tets.h"
#include "volume/cavity_editor.h"
#include "volume/edge_removal.h"
#include "volume/needles.h"

using namespace featuremesh;

namespace {

constexpr double target_deg = 30;

WantedSize uniform(double size) {
    return {[size](const Vec3&) { return size; }, size, true};
}

std::vector<int> all_of(const TetComplex& complex) {
    std::vector<int> vertices(complex.points.size());
    std::iota(vertices.begin(), vertices.end(), 0);
    return vertices;
}

double smallest_volume(const TetComplex& complex) {
    double smallest = 1e300;
    for (const Tet& tet : complex.tets)
        if (tet[0] >= 0) smallest = std::min(smallest, volume_of(complex, tet));
    return smallest;
}

/// Splits the vertex's tets by points of their own, a tenth of the way to the other corners' middle.
int crowd(TetComplex& complex, int vertex) {
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
    RunContext context;
    CHECK(remove_crowded(box, all_of(box), uniform(1), target_deg, context) == 0);
    CHECK(box.tets == before.tets);

    const int centre = 62;  // of 5 x 5 x 5
    const int added = crowd(box, centre);
    REQUIRE(find_flaws(box).empty());
    const double worst = worst_flatness(box);
    const auto outside = outside_of(box);
    CHECK(remove_crowded(box, all_of(box), uniform(1), target_deg, context) == static_cast<std::size_t>(added));
    CHECK(find_flaws(box).empty());
    CHECK(outside_of(box) == outside);
    CHECK(worst_flatness(box) <= worst);
    CHECK(total_volume(box) == Approx(64));
    CHECK(worst_flatness(box) == Approx(worst_flatness(before)));
}

TEST_CASE("points as close as the sizes ask for stay, and those that must") {
    TetComplex box = box_of_tets(4, 0.1, 5);
    crowd(box, 62);
    const TetComplex before = box;
    RunContext context;
    CHECK(remove_crowded(box, all_of(box), uniform(0.05), target_deg, context) == 0);
    CHECK(box.tets == before.tets);
    CHECK(remove_crowded(box, {}, uniform(1), target_deg, context) == 0);
    box.is_fixed.assign(box.points.size(), 2);
    CHECK(remove_crowded(box, all_of(box), uniform(1), target_deg, context) == 0);
    CHECK(box.tets == before.tets);
}

TEST_CASE("no worst angle and no smallest tet gets worse where points are taken out") {
    std::size_t gone = 0;
    for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
        TetComplex box = box_of_tets(5, 0.2, seed);
        for (Vec3& p : box.points) p.z *= 0.1;
        const double worst = worst_flatness(box), volume = total_volume(box), smallest = smallest_volume(box);
        RunContext context;
        gone += remove_crowded(box, all_of(box), uniform(3), target_deg, context);  // they are all too close for that
        CHECK(find_flaws(box).empty());
        CHECK(worst_flatness(box) <= worst);
        CHECK(smallest_volume(box) >= smallest);
        CHECK(total_volume(box) == Approx(volume));
    }
    CHECK(gone > 0);
}

TEST_CASE("points beside needles stay") {
    TetComplex box = box_of_tets(2, 0, 1);
    box.points[1] = {0.001, 0, 0};  // on the edge from corner 0, which is fixed as well
    const int added = crowd(box, 13);
    REQUIRE(find_flaws(box).empty());
    std::vector<Tet> needles;
    for (const Tet& tet : box.tets)
        if (tet[0] >= 0 && is_excused(box, tet)) needles.push_back(tet);
    REQUIRE(!needles.empty());
    RunContext context;
    const std::size_t gone = remove_crowded(box, all_of(box), uniform(1), target_deg, context);
    CHECK(gone > 0);
    CHECK(gone < static_cast<std::size_t>(added));
    for (const Tet& tet : needles) CHECK(std::find(box.tets.begin(), box.tets.end(), tet) != box.tets.end());
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "catch.h"
#include "volume/improvement/cone_cavity.h"
#include "volume/improvement/improved.h"

using namespace featuremesh;

namespace {

/// Does what a grown cavity stands for and checks that nothing else changed.
void commit_and_check(TetComplex& complex, CavityEditor& editor, ConeCavity& cavity) {
    const double volume = total_volume(complex);
    const auto outside = outside_of(complex);
    double removed_volume = 0, added_volume = 0;
    for (int tet : cavity.removed()) removed_volume += volume_of(complex, complex.tets[tet]);
    const int apex = cavity.apex() < 0 ? editor.add_vertex(cavity.point()) : cavity.apex();
    const auto cones = cavity.cones(apex);
    double worst = 0;
    for (const Tet& v : cones) {
        added_volume += volume_of(complex, v);
        worst = std::max(
            worst, flatness(complex.points[v[0]], complex.points[v[1]], complex.points[v[2]], complex.points[v[3]]));
    }
    CHECK(added_volume == Approx(removed_volume));
    CHECK(worst == Approx(cavity.worst_after()));
    CHECK(cavity.worst_after() < cavity.worst_before());
    editor.replace(cavity.removed(), cones);
    CHECK(find_flaws(complex).empty());
    CHECK(total_volume(complex) == Approx(volume).epsilon(1e-12));
    CHECK(outside_of(complex) == outside);
    for (std::size_t v = 0; v < complex.points.size(); ++v)
        if (!complex.is_free(static_cast<int>(v))) REQUIRE(complex.tet_of_vertex[v] >= 0);
}

}  // namespace

TEST_CASE("cones over the outside of a grown cavity fill it exactly") {
    int insertions = 0, refills = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        TetComplex box = box_of_tets(4, 0.24, seed);
        // kept vertices deep inside may not get lost
        for (std::size_t v = 0; v < box.points.size(); v += 3) box.mobility[v] = Mobility::fixed;
        CavityEditor editor(box);
        const Objective objective = objective_for(30);
        ConeCavity cavity(box, objective);
        for (int t = 0; t < 60; ++t) {
            if (box.tets[t][0] < 0) continue;
            const Tet v = box.tets[t];
            const Vec3 center = (box.points[v[0]] + box.points[v[1]] + box.points[v[2]] + box.points[v[3]]) / 4;
            const bool is_new = t % 3 == 0;
            if (!cavity.grow(std::array{t}, is_new ? -1 : v[t % 4], is_new ? center : box.points[v[t % 4]])) continue;
            ++(is_new ? insertions : refills);
            if (is_new) cavity.climb(0);
            commit_and_check(box, editor, cavity);
        }
    }
    CHECK(insertions > 20);
    CHECK(refills > 20);
}

TEST_CASE("what a cavity was worth is looked at again when the tets may have changed") {
    TetComplex box = box_of_tets(4, 0.1, 3);
    const Objective objective = objective_for(30);
    ConeCavity cavity(box, objective);
    const int centre = 62;
    std::vector<int> star;
    gather_star(box, centre, star);
    const auto worst = [&] { return objective.value(box, star).worst; };
    const Vec3 place = box.points[centre];
    cavity.open(star, place);
    CHECK(cavity.worst_before() == worst());
    box.points[centre] += Vec3{0.1, 0.05, 0.15};
    cavity.open(star, place);
    CHECK(cavity.worst_before() == worst());
}

TEST_CASE("planning a refill changes nothing") {
    TetComplex box = box_of_tets(4, 0.24, 5);
    const TetComplex before = box;
    const Objective objective = objective_for(60);
    LocalMesh mesh(box);
    const auto refill = cone_refill(mesh, objective);
    int plans = 0;
    for (int t = 0; t < static_cast<int>(box.tets.size()); ++t) {
        Change change;
        Footprint footprint;
        if (!refill->plan(t, change, footprint)) continue;
        ++plans;
        REQUIRE(change.was_dear);
        REQUIRE(change.before.worst == Approx(objective.value(box, change.removed).worst));
        REQUIRE(objective.is_better(change.before, change.after, change.price));
        REQUIRE(std::find(change.removed.begin(), change.removed.end(), t) != change.removed.end());
    }
    CHECK(plans > 10);
    CHECK(are_same_bytes(before, box));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "catch.h"
#include "core/errors.h"
#include "volume/improvement/improved.h"

using namespace featuremesh;

namespace {

/// A square of four nearly coplanar points makes a flat tet between two apexes: three tets of space, one of them a
/// sliver.
TetComplex square_with_sliver(double lift) {
    TetComplex complex;
    complex.points = {{1, 0, lift}, {0, 1, -lift}, {-1, 0, lift}, {0, -1, -lift}, {0, 0, 1.2}, {0, 0, -1.2}};
    complex.mobility.assign(6, Mobility::fixed);
    // the sliver's upper side is split along the edge 0-2, its lower side along 1-3
    complex.tets = {{0, 1, 2, 4}, {0, 2, 3, 4}, {1, 0, 3, 5}, {1, 3, 2, 5}, {0, 3, 1, 2}};
    for (Tet& tet : complex.tets)
        if (volume_of(complex, tet) < 0) std::swap(tet[0], tet[1]);
    complex.regions.assign(5, 7);
    connect(complex);
    return complex;
}

}  // namespace

TEST_CASE("a sliver between four nearly coplanar points goes") {
    TetComplex complex = square_with_sliver(0.01);
    REQUIRE(find_flaws(complex).empty());
    REQUIRE(angle_of_flatness(worst_flatness(complex)) < 3);
    const double volume = total_volume(complex);
    const auto outside = outside_of(complex);
    const Improvement report = improve_inside(complex, 30);
    CHECK(report.before == 1);
    CHECK(report.left == 0);
    CHECK(find_flaws(complex).empty());
    CHECK(angle_of_flatness(worst_flatness(complex)) > 40);
    CHECK(total_volume(complex) == Approx(volume));
    CHECK(outside_of(complex) == outside);
    CHECK(std::count_if(complex.tets.begin(), complex.tets.end(), [](const Tet& t) { return t[0] >= 0; }) == 4);
    for (std::size_t t = 0; t < complex.tets.size(); ++t)
        if (complex.tets[t][0] >= 0) CHECK(complex.regions[t] == 7);
}

TEST_CASE("improvement only makes the worst angle better and keeps what has to stay") {
    for (unsigned seed : {1u, 2u, 3u, 4u}) {
        TetComplex box = box_of_tets(6, 0.24, seed);
        for (Vec3& p : box.points) p.z *= 0.8;
        const TetComplex start = box;
        const auto outside = outside_of(box);
        const Improvement report = improve_inside(box, 35);
        CHECK(report.before > 0);
        CHECK(report.left < report.before);
        CHECK(worst_flatness(box) < worst_flatness(start));
        CHECK(find_flaws(box).empty());
        CHECK(total_volume(box) == Approx(total_volume(start)).epsilon(1e-12));
        CHECK(outside_of(box) == outside);
        CHECK(are_fixed_kept(start, box));
    }
}

TEST_CASE("a new vertex helps where all vertices are fixed") {
    TetComplex box = box_of_tets(4, 0.2, 31);
    fix_all(box);
    for (Vec3& p : box.points) p.z *= 0.7;
    const TetComplex start = box;
    const Improvement report = improve_inside(box, 35);
    CHECK(made(report, "cone refill") > 0);
    CHECK(box.points.size() > start.points.size());
    CHECK(worst_flatness(box) < worst_flatness(start));
    CHECK(find_flaws(box).empty());
    CHECK(are_fixed_kept(start, box));
    for (std::size_t v = 0; v < box.points.size(); ++v)
        if (!box.is_free(static_cast<int>(v))) REQUIRE(box.tet_of_vertex[v] >= 0);
}

TEST_CASE("what is dear is planned as often as allowed at most, and more often where that gains") {
    TetComplex start = box_of_tets(4, 0.2, 31);
    fix_all(start);
    for (Vec3& p : start.points) p.z *= 0.7;
    const auto refills = [&](const Budget& budget) {
        TetComplex box = start;
        const Improvement report = improve_inside(box, 35, budget);
        CHECK(find_flaws(box).empty());
        return report;
    };
    CHECK(planned(refills({}), "cone refill") > 7);
    CHECK(planned(refills({.dear_plans = 7}), "cone refill") == 7);
    CHECK(planned(refills({.dear_plans = 0}), "cone refill") == 0);
    const Improvement earned = refills({.dear_plans = 7, .dear_plans_per_gain = 2});
    CHECK(made(earned, "cone refill") > 0);
    CHECK(planned(earned, "cone refill") > 7);
    CHECK(planned(earned, "cone refill") <= 7 + 2 * made(earned, "cone refill"));
}

TEST_CASE("it says why it stopped") {
    TetComplex box = box_of_tets(6, 0.24, 1);
    CHECK(improve_inside(box, 5).why == Stop::all_good);
    TetComplex again = box;
    CHECK(improve_inside(box, 55).why != Stop::all_good);
    CHECK(improve_inside(again, 55, {.passes = 1}).why == Stop::out_of_passes);
    TetComplex lonely = square_with_sliver(0.01);
    const Improvement done = improve_inside(lonely, 80);
    CHECK(done.why == Stop::nothing_gains);
    CHECK(done.left > 0);
}

TEST_CASE("a second call finds nothing more to do") {
    TetComplex box = box_of_tets(5, 0.24, 3);
    while (improve_inside(box, 40).why == Stop::out_of_passes) {
    }
    const TetComplex settled = box;
    CHECK(improve_inside(box, 40).changes == 0);
    CHECK(are_same_bytes(box, settled));
}

TEST_CASE("a free vertex that spoils its star is moved or collapsed") {
    TetComplex box = box_of_tets(2, 0, 1);
    box.points[13] = box.points[14] + Vec3{-0.02, 0.001, 0.001};
    REQUIRE(find_flaws(box).empty());
    REQUIRE(angle_of_flatness(worst_flatness(box)) < 2);
    const Improvement report = improve_inside(box, 30);
    CHECK(report.changes > 0);
    CHECK(report.left == 0);
    CHECK(find_flaws(box).empty());
}

TEST_CASE("where the target is out of reach the penalty of all tets falls with the worst angle") {
    // a wall a twelfth of an element thick
    TetComplex wall = bar_of_tets({8, 8, 1}, 0, 1);
    for (Vec3& p : wall.points) p.z *= 1.0 / 12;
    const TetComplex start = wall;
    const Improvement report = improve_inside(wall, 30);
    CHECK(report.left > 0);
    CHECK(find_flaws(wall).empty());
    const Objective objective = objective_for(30);
    const auto penalty_of_all = [&](const TetComplex& complex) {
        std::vector<Tet> tets = complex.tets;
        std::erase_if(tets, [](const Tet& t) { return t[0] < 0; });
        return objective.value(complex, tets).penalty;
    };
    CHECK(penalty_of_all(wall) <= penalty_of_all(start) * (1 + 1e-12));
    CHECK(worst_flatness(wall) <= worst_flatness(start));
}

TEST_CASE("an angle between two boundary triangles counts as forced") {
    TetComplex wedge;
    wedge.points = {{0, 0, 0}, {0, 1, 0}, {2, 0.5, 0.1}, {2, 0.5, -0.1}};
    wedge.mobility.assign(4, Mobility::fixed);
    wedge.tets = {{0, 1, 2, 3}};
    if (volume_of(wedge, wedge.tets[0]) < 0) std::swap(wedge.tets[0][0], wedge.tets[0][1]);
    connect(wedge);
    const Improvement report = improve_inside(wedge, 30);
    CHECK(report.left == 1);
    CHECK(report.forced == 1);
}

TEST_CASE("the report counts the tets that miss the target") {
    TetComplex box = box_of_tets(5, 0.19, 21);
    const auto missing = [&] {
        const auto& p = box.points;
        return static_cast<std::size_t>(std::count_if(box.tets.begin(), box.tets.end(), [&](const Tet& v) {
            return v[0] >= 0 && flatness(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) > flatness_of_angle(45);
        }));
    };
    const std::size_t before = missing();
    const Improvement report = improve_inside(box, 45);
    CHECK(report.before == before);
    CHECK(report.left == missing());
}

TEST_CASE("where nothing helps or nothing is wrong not a byte changes") {
    TetComplex lonely;
    lonely.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.4, 0.4, 0.01}};
    lonely.mobility.assign(4, Mobility::fixed);
    lonely.tets = {{0, 1, 2, 3}};
    connect(lonely);
    TetComplex box = box_of_tets(4, 0.02, 22);
    const TetComplex lonely_before = lonely, box_before = box;
    CHECK(improve_inside(lonely, 30).left == 1);
    CHECK(improve_inside(box, 20).before == 0);
    CHECK(are_same_bytes(lonely, lonely_before));
    CHECK(are_same_bytes(box, box_before));
}

TEST_CASE("improvement gives the same bytes and counts for any number of threads") {
    const TetComplex start = box_of_tets(12, 0.24, 23);
    // a budget that lasts, one that runs out now and then, and none
    for (const Budget& budget :
         {Budget{}, Budget{.dear_plans = 40, .dear_plans_per_gain = 2}, Budget{.dear_plans = 0}}) {
        TetComplex one = start;
        const Improvement alone = improve_inside(one, 40, budget, 1);
        REQUIRE(alone.changes > 1000);
        CHECK(alone.planned_ahead == 0);
        for (const int threads : {2, 4}) {
            TetComplex many = start;
            const Improvement together = improve_inside(many, 40, budget, threads);
            CHECK(are_same_bytes(one, many));
            CHECK(find_flaws(many).empty());
            CHECK(together.left == alone.left);
            for (std::size_t i = 0; i < alone.counts.size(); ++i) {
                CHECK(together.counts[i].planned == alone.counts[i].planned);
                CHECK(together.counts[i].made == alone.counts[i].made);
            }
            CHECK(together.planned_ahead > together.changes);
            CHECK(together.outdated > 0);
            CHECK(2 * together.outdated < together.planned_ahead);
        }
    }
}

TEST_CASE("improvement can be cancelled") {
    TetComplex complex = square_with_sliver(0.01);
    RunContext context;
    context.on_progress = [](std::string_view, double) { return false; };
    const Objective objective = objective_for(30);
    LocalMesh mesh(complex);
    CHECK_THROWS_AS(improve(mesh, objective, list_of(edge_ring(mesh, objective)), {}, {}, context), Cancelled);
}

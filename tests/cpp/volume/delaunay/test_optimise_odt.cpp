// SPDX-License-Identifier: GPL-3.0-or-later
#include "catch.h"
#include "core/errors.h"
#include "volume/delaunay/optimise_odt.h"
#include "volume/tets/box_of_tets.h"

using namespace featuremesh;

namespace {

/// Uniform sizing is never asked, so it needs no data.
OdtReport optimise(TetComplex& complex, int sweeps, int threads = 1) {
    RunContext context;
    context.threads = threads;
    OdtOptions options;
    options.sweeps = sweeps;
    return optimise_odt(complex, SizingField(nullptr), options, context);
}

}  // namespace

TEST_CASE("ODT never raises the energy and keeps what has to stay") {
    for (unsigned seed : {1u, 2u, 3u}) {
        TetComplex box = box_of_tets(6, 0.19, seed);
        const TetComplex start = box;
        const auto outside = outside_of(box);
        double energy = total_energy(box);
        for (int round = 0; round < 6; ++round) {
            const OdtReport report = optimise(box, 1);
            CHECK(report.energy_before == Approx(energy));
            energy = total_energy(box);
            CHECK(report.energy_after == Approx(energy));
            CHECK(energy <= report.energy_before * (1 + 1e-12));
            CHECK(find_flaws(box).empty());
        }
        CHECK(energy < 0.95 * total_energy(start));
        CHECK(total_volume(box) == Approx(216).epsilon(1e-12));
        CHECK(outside_of(box) == outside);
        CHECK(are_fixed_kept(start, box));
    }
}

TEST_CASE("a free vertex ends where the energy is lowest") {
    TetComplex box = box_of_tets(2, 0.19, 9);
    CHECK(optimise(box, 50).moves > 0);
    const int center = 13;
    REQUIRE(box.is_free(static_cast<int>(center)));
    const Vec3 place = box.points[center];
    const double energy = total_energy(box);
    for (const Vec3& step : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        for (double sign : {-1.0, 1.0}) {
            // beyond the 1 % of the star's size at which a vertex is left alone
            box.points[center] = place + (0.05 * sign) * step;
            CHECK(total_energy(box) > energy);
        }
}

TEST_CASE("the connectivity after ODT is locally Delaunay where a 2-3 flip could be made") {
    TetComplex box = box_of_tets(5, 0.19, 10);
    optimise(box, 5);
    const auto& p = box.points;
    for (std::size_t t = 0; t < box.tets.size(); ++t) {
        if (box.tets[t][0] < 0) continue;
        for (int face = 0; face < 4; ++face) {
            const int next = box.neighbours[t][face];
            if (next < 0) continue;
            const Tet& v = box.tets[t];
            const Tet& w = box.tets[next];
            const int apex =
                *std::find_if(w.begin(), w.end(), [&](int x) { return std::find(v.begin(), v.end(), x) == v.end(); });
            double after = 0;
            bool is_possible = true;
            for (int i = 0; i < 3; ++i) {
                const double part = odt_energy(p[v[face]], p[v[opposite_face[face][i]]],
                                               p[v[opposite_face[face][(i + 1) % 3]]], p[apex]);
                is_possible = is_possible && part > 1e-4;
                after += part;
            }
            const double before =
                odt_energy(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) + odt_energy(p[w[0]], p[w[1]], p[w[2]], p[w[3]]);
            if (is_possible) REQUIRE(after >= before * (1 - 1e-6));
        }
    }
}

TEST_CASE("ODT leaves an optimum alone, bit for bit") {
    TetComplex box = box_of_tets(4, 0.15, 11);
    optimise(box, 100);
    TetComplex again = box;
    CHECK(optimise(again, 3).moves == 0);
    CHECK(are_same_bytes(box, again));
}

TEST_CASE("ODT gives the same bytes for any number of threads") {
    // long enough for several blocks that are worked on at the same time
    TetComplex one = bar_of_tets({80, 6, 6}, 0.19, 12), many = one;
    const OdtReport report = optimise(one, 3, 1);
    optimise(many, 3, 4);
    CHECK(report.moves > 1000);
    CHECK(report.flips > 100);
    CHECK(report.energy_after < report.energy_before);
    CHECK(are_same_bytes(one, many));
}

TEST_CASE("ODT can be cancelled") {
    TetComplex box = box_of_tets(4, 0.19, 13);
    RunContext context;
    context.on_progress = [](std::string_view, double) { return false; };
    CHECK_THROWS_AS(optimise_odt(box, SizingField(nullptr), {}, context), Cancelled);
}

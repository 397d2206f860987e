// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "catch.h"
#include "mesh/quality.h"
#include "volume/filled_parts.h"
#include "volume/improvement/improved.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

constexpr std::array<bool, 4> none_on_boundary{};

struct ThinTets {
    int needles = 0, others = 0;
};

/// Tets with an angle below this, by whether a side of theirs is far shorter than another.
ThinTets thin_tets(const Mesh& mesh, double angle_deg) {
    ThinTets thin;
    for (const auto& [a, b, c, d] : mesh.tets) {
        const std::array<Vec3, 4> p{mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(d)};
        if (dihedral_range(p[0], p[1], p[2], p[3]).smallest_deg >= angle_deg) continue;
        double least = 1e300, most = 0;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < i; ++j)
                least = std::min(least, distance(p[i], p[j])), most = std::max(most, distance(p[i], p[j]));
        ++(least < 0.01 * most ? thin.needles : thin.others);
    }
    return thin;
}

}  // namespace

TEST_CASE("a tet that is too thin is worse than any angle, and the worse the thinner") {
    const Objective objective = objective_for(30, 1e-3);
    const auto flaw_of_height = [&](double h) {
        return objective.flaw({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, h}}}, none_on_boundary);
    };
    CHECK(flaw_of_height(1) < 1);
    CHECK(flaw_of_height(7e-3) <= 1);  // a volume of 1e-3 takes a height of 6e-3
    CHECK(flaw_of_height(5e-3) > 1);
    CHECK(flaw_of_height(4e-3) > flaw_of_height(5e-3));
    CHECK(flaw_of_height(-1) == inverted_flatness);
    CHECK(thickness({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 3e-3}}}, 1e-3) == Approx(0.5));
}

TEST_CASE("values are compared level by level") {
    const Objective objective = objective_for(30);
    const double bad = flatness_of_angle(10), worse = flatness_of_angle(5), fair = flatness_of_angle(25);
    const auto value = [&](std::vector<double> flaws, double mean_shape = 0.5) {
        Value sum{.shape = mean_shape * double(flaws.size()), .count = double(flaws.size())};
        for (const double flaw : flaws) sum.worst = std::max(sum.worst, flaw), sum.penalty += objective.penalty(flaw);
        return sum;
    };
    CHECK(objective.is_better(value({worse, fair}), value({bad, fair}), {}));
    CHECK_FALSE(objective.is_better(value({bad, fair}), value({worse, 0.1}), {}));
    // a better worst tet is not worth many more bad ones, unless all reach the target
    CHECK_FALSE(objective.is_better(value({worse}), value({bad, bad, bad}), {}));
    CHECK(objective.is_better(value({worse}), value({0.1, 0.1, 0.1, 0.1}), {}));
    // the worst as it is, and the others better
    CHECK(objective.is_better(value({worse, bad}), value({worse, fair}), {}));
    // neither any worse, and rounder
    CHECK(objective.is_better(value({0.1, 0.1}, 0.5), value({0.2, 0.2}, 0.51), {}));
    CHECK_FALSE(objective.is_better(value({0.1, 0.1}, 0.5), value({0.2, 0.2}, 0.502), {}));
    // an angle is not worth all shapes, a volume is
    CHECK_FALSE(objective.is_better(value({worse}, 0.5), value({fair}, 0.2), {}));
    CHECK(objective.is_better(value({1.5}, 0.5), value({fair}, 0.2), {}));
    // a new vertex has to reach the target unless the need is urgent
    CHECK_FALSE(
        objective.is_better(value({flatness_of_angle(26)}), value({flatness_of_angle(28)}), price_of_new_vertex));
    CHECK(objective.is_better(value({worse}), value({flatness_of_angle(28)}), price_of_new_vertex));
    CHECK_FALSE(objective.is_better(value({bad}), value({flatness_of_angle(10.05)}), price_of_surface_move));
}

TEST_CASE("a tet that is barred is the worst there is, and is split") {
    TetComplex box = box_of_tets(3, 0.1, 2);
    const Tet barred = box.tets[5];
    const auto is_barred = [&](const Tet& tet) { return tet == barred; };
    const Objective objective({.target_dihedral_deg = 1, .is_barred = is_barred});
    CHECK(objective.flaw(box, barred) > 1.9);
    // nothing makes up for a tet without volume
    CHECK_FALSE(objective.is_better({inverted_flatness, 1e9, 1, 2}, {inverted_flatness, 1e8, 1, 2}, {}));
    RunContext context;
    LocalMesh mesh(box);
    const std::size_t points = box.points.size();
    const Improvement done = improve(mesh, objective, list_of(tet_split(mesh, objective)), {}, {}, context);
    CHECK(done.before == 1);
    CHECK(done.left == 0);
    REQUIRE(box.points.size() == points + 1);
    CHECK(box.mobility.back() == Mobility::kept);
    CHECK(find_flaws(box).empty());
    CHECK(total_volume(box) == Approx(27));
}

TEST_CASE("beside needles that the part forces hardly any other tet is thin") {
    ThinTets all;
    for (const double width : {1e-4, 2e-4, 5e-4})
        for (const double size : {4.0, 3.0, 2.0}) {
            INFO(width << " " << size);
            const Part part = prepare(cut_corner(width), size);
            const VolumeResult result = fill(part);
            CHECK(findings(part.brep, result.mesh).empty());
            const ThinTets thin = thin_tets(result.mesh, 5);
            all.needles += thin.needles, all.others += thin.others;
        }
    CHECK(all.needles > 50);
    CHECK(5 * all.others < all.needles);
}

TEST_CASE("so it is in an engraving of a few millionths of the part") {
    const Part part = prepare(engraved_block(24, 0.5, 1e-4), 2);
    const VolumeResult result = fill(part);
    CHECK(findings(part.brep, result.mesh).empty());
    const ThinTets thin = thin_tets(result.mesh, 5);
    CHECK(thin.needles > 50);
    CHECK(5 * thin.others < thin.needles);
}

TEST_CASE("a needle does not hold the angles of the tets beside it") {
    const auto [width, size] = GENERATE(table<double, double>({{5e-3, 2}, {1e-3, 1}, {1e-4, 1}}));
    const Part part = prepare(cut_corner(width), size);
    const Mesh mesh = fill(part).mesh;
    CHECK(findings(part.brep, mesh).empty());
    CHECK(thin_tets(mesh, 25).others == 0);
}

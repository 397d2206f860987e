// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/needle_neighbours.h"

#include <algorithm>

#include "catch.h"
#include "filled_parts.h"
#include "mesh/quality.h"
#include "volume/box_of_tets.h"
#include "volume/needles.h"
#include "volume/tet_measures.h"
#include "volume/thicken.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

constexpr std::array<bool, 4> all_on_boundary{true, true, true, true}, none_on_boundary{};

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

double unforced(const std::array<Vec3, 4>& tet, const std::array<bool, 4>& is_on_boundary) {
    return unforced_flatness(flatness(tet[0], tet[1], tet[2], tet[3]), tet, is_on_boundary);
}

double smallest_angle(const TetComplex& complex) {
    double worst = 0;
    for (const auto& [a, b, c, d] : complex.tets)
        if (a >= 0)
            worst =
                std::max(worst, flatness(complex.points[a], complex.points[b], complex.points[c], complex.points[d]));
    return angle_of_flatness(worst);
}

}  // namespace

TEST_CASE("the angle opposite a needle's short side does not count") {
    const std::array<Vec3, 4> needle{{{0, 0, 0}, {1e-4, 0, 0}, {0.3, 1, -0.6}, {-0.2, 0.8, 0.7}}};
    const double all = flatness(needle[0], needle[1], needle[2], needle[3]);
    REQUIRE(angle_of_flatness(all) < 0.01);
    CHECK(angle_of_flatness(unforced(needle, all_on_boundary)) > 20);
    CHECK(unforced(needle, none_on_boundary) == all);
    CHECK(unforced(needle, {true, false, true, true}) == all);
}

TEST_CASE("a needle without volume stays the worst there is") {
    const std::array<Vec3, 4> flat{{{0, 0, 0}, {1e-4, 0, 0}, {0.3, 1, 0}, {-0.2, 0.8, 0}}};
    CHECK(unforced(flat, all_on_boundary) == inverted_flatness);
}

TEST_CASE("without needles nothing changes") {
    TetComplex box = box_of_tets(5, 0.19, 3);
    const auto tets = box.tets;
    RunContext context;
    CHECK(improve_beside_needles(box, {}, 30, 0, context) == 0);
    CHECK(box.tets == tets);
}

TEST_CASE("tets that were made for their volume get angles, too") {
    int better = 0;
    for (unsigned seed = 1; seed <= 30; ++seed) {
        TetComplex box = box_of_tets(4, 0.19, seed);
        const int vertex = 2 + 5 * 2 + 25 * 2;
        box.points[vertex] = box.points[vertex + 1] - Vec3{1e-7, 0, 0};
        RunContext context;
        const Thickened thickened = thicken(box, 1e-3, context);
        REQUIRE(thickened.left.empty());
        REQUIRE(!thickened.changed.empty());
        const double before = smallest_angle(box);
        improve_beside_needles(box, thickened.changed, 30, 1e-3, context);
        CHECK(find_flaws(box).empty());
        CHECK(smallest_angle(box) >= before);
        better += before < 10 && smallest_angle(box) > 15;
    }
    CHECK(better > 5);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "catch.h"
#include "core/errors.h"
#include "mesh/quality.h"
#include "volume/improvement/improved.h"
#include "volume/improvement/star_shape.h"

using namespace featuremesh;

namespace {

const Objective angles = objective_for(30);

Improvement round_shapes(TetComplex& complex, Region region, RunContext& context) {
    const Objective shapes = objective_for(30, 0, 1);
    LocalMesh mesh(complex);
    return improve(mesh, shapes, list_of(vertex_move(mesh, shapes)), std::move(region), {.passes = 3}, context);
}

std::vector<int> star_of(const TetComplex& complex, int vertex) {
    std::vector<int> star;
    gather_star(complex, vertex, star);
    return star;
}

double mean_ratio(const TetComplex& complex) {
    const auto& p = complex.points;
    double sum = 0;
    for (const Tet& v : complex.tets) sum += radius_ratio(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
    return sum / static_cast<double>(complex.tets.size());
}

std::size_t count_bad(const TetComplex& complex) {
    const auto& p = complex.points;
    return static_cast<std::size_t>(std::count_if(complex.tets.begin(), complex.tets.end(), [&](const Tet& v) {
        return flatness(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) > flatness_of_angle(30);
    }));
}

}  // namespace

TEST_CASE("what a star is worth is what its tets are worth") {
    TetComplex box = box_of_tets(4, 0.19, 4);
    const int centre = 62;
    const std::vector<int> tets = star_of(box, centre);
    StarShape star(angles);
    star.gather(box, tets, centre);
    const Value here = star.value(box.points[centre]), expected = angles.value(box, tets);
    CHECK(here.worst == Approx(expected.worst));
    CHECK(here.penalty == Approx(expected.penalty));
    CHECK(here.shape == Approx(expected.shape));
    CHECK(here.count == expected.count);
    Vec3 place = box.points[centre] + Vec3{0.15, 0.1, -0.1};
    const double before = star.worst(place);
    CHECK(star.climb(place, 0) < before);
}

TEST_CASE("shapes get better, and neither the worst angle nor the bad tets get worse") {
    for (unsigned seed : {1u, 2u, 3u}) {
        TetComplex box = box_of_tets(6, 0.19, seed);
        const TetComplex start = box;
        RunContext context;
        CHECK(round_shapes(box, {}, context).changes > 0);
        CHECK(mean_ratio(box) > mean_ratio(start) + 0.02);
        CHECK(worst_flatness(box) <= worst_flatness(start));
        CHECK(count_bad(box) <= count_bad(start));
        CHECK(find_flaws(box).empty());
        CHECK(are_fixed_kept(start, box));
        CHECK(box.tets == start.tets);
    }
}

TEST_CASE("shapes are looked after in the region alone") {
    TetComplex box = box_of_tets(6, 0.1, 4);
    const TetComplex start = box;
    const int centre = 3 + 7 * 3 + 49 * 3;
    const std::vector<int> star = star_of(box, centre);
    RunContext context;
    CHECK(round_shapes(box, star, context).changes > 0);
    for (int v = 0; v < static_cast<int>(box.points.size()); ++v)
        if (box.points[v] != start.points[v])
            CHECK(std::any_of(star.begin(), star.end(), [&](int t) {
                return std::find(box.tets[t].begin(), box.tets[t].end(), v) != box.tets[t].end();
            }));
}

TEST_CASE("a kept vertex is moved for shape only where that gains much") {
    TetComplex box = box_of_tets(4, 0.05, 4);
    const int centre = 62;
    fix_all(box);
    box.mobility[centre] = Mobility::kept;
    const TetComplex good = box;
    RunContext context;
    CHECK(round_shapes(box, {}, context).changes == 0);
    CHECK(are_same_bytes(box, good));
    box.points[centre] += {0.3, 0.2, 0.1};
    const TetComplex poor = box;
    CHECK(round_shapes(box, {}, context).changes > 0);
    CHECK(mean_ratio(box) >= mean_ratio(poor) + 0.3 / double(box.tets.size()));
    CHECK(worst_flatness(box) <= worst_flatness(poor));
}

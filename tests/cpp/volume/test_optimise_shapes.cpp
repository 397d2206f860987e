// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "catch.h"
#include "core/errors.h"
#include "mesh/quality.h"
#include "volume/box_of_tets.h"
#include "volume/optimise.h"
#include "volume/vertex_move.h"

using namespace featuremesh;

namespace {

ShapeReport optimise(TetComplex& complex, std::vector<int> among) {
    RunContext context;
    ShapeOptions options;
    options.among = std::move(among);
    return optimise_shapes(complex, options, context);
}

std::vector<int> all_vertices(const TetComplex& complex) {
    std::vector<int> all(complex.points.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
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

TEST_CASE("a star's radius ratios and the way in which they grow") {
    StarShape star;
    star.add({1, 0, 0}, {0.1, 1.2, 0}, {0, 0.1, 0.9});
    star.add({0, 1, 0.2}, {-1, 0.1, 0}, {0.1, 0, 1.1});
    const Vec3 p{-0.1, 0.05, -0.2};
    const StarShape::Ratios ratios = star.radius_ratios(p);
    CHECK(ratios.sum == Approx(radius_ratio(p, {1, 0, 0}, {0.1, 1.2, 0}, {0, 0.1, 0.9}) +
                               radius_ratio(p, {0, 1, 0.2}, {-1, 0.1, 0}, {0.1, 0, 1.1})));
    CHECK(star.sum_of_radius_ratios(p) == Approx(ratios.sum));
    const double h = 1e-5;
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        CHECK(dot(ratios.gradient, axis) ==
              Approx((star.sum_of_radius_ratios(p + h * axis) - star.sum_of_radius_ratios(p - h * axis)) / (2 * h))
                  .margin(1e-6));
    CHECK(star.sum_of_radius_ratios({5, 5, 5}) == 0);
}

TEST_CASE("each tet of a star counts once, and by itself, whether their number is odd or even") {
    const Vec3 p{-0.1, 0.05, -0.2};
    const std::vector<std::array<Vec3, 3>> faces{{{{1, 0, 0}, {0.1, 1.2, 0}, {0, 0.1, 0.9}}},
                                                 {{{0, 1, 0.2}, {-1, 0.1, 0}, {0.1, 0, 1.1}}},
                                                 {{{0.1, 1.2, 0}, {1, 0, 0}, {0, 0.1, 0.9}}},  // turned: no volume
                                                 {{{0.9, 0.1, 0}, {0.2, 1.3, 0}, {0, 0.2, 0.8}}},
                                                 {{{0, 1.1, 0.1}, {-1, 0.2, 0}, {0.2, 0, 1.2}}}};
    StarShape star;
    StarShape::Ratios sum;
    for (const auto& [a, b, c] : faces) {
        StarShape alone;
        alone.add(a, b, c), star.add(a, b, c);
        sum.sum += alone.radius_ratios(p).sum;
        sum.gradient += alone.radius_ratios(p).gradient;
        const StarShape::Ratios together = star.radius_ratios(p);
        CHECK(together.sum == sum.sum);  // to the last bit
        CHECK(together.gradient == sum.gradient);
        CHECK(star.sum_of_radius_ratios(p) == sum.sum);
    }
}

TEST_CASE("shapes get better, and neither the worst angle nor the bad tets get worse") {
    for (unsigned seed : {1u, 2u, 3u}) {
        TetComplex box = box_of_tets(6, 0.19, seed);
        const TetComplex start = box;
        CHECK(optimise(box, all_vertices(box)).moves > 0);
        CHECK(mean_ratio(box) > mean_ratio(start) + 0.02);
        CHECK(worst_flatness(box) <= worst_flatness(start));
        CHECK(count_bad(box) <= count_bad(start));
        CHECK(find_flaws(box).empty());
        CHECK(are_fixed_kept(start, box));
        CHECK(box.tets == start.tets);
    }
}

TEST_CASE("only the vertices given are moved") {
    TetComplex box = box_of_tets(4, 0.19, 4);
    const TetComplex start = box;
    const int center = 62;
    REQUIRE(!box.is_fixed[center]);
    CHECK(optimise(box, {center}).moves > 0);
    for (int v = 0; v < static_cast<int>(box.points.size()); ++v)
        CHECK((box.points[v] == start.points[v]) == (v != center));
    CHECK(optimise(box, {}).moves == 0);
}

TEST_CASE("a kept vertex is moved only where that is asked for and gains enough") {
    TetComplex box = box_of_tets(4, 0.19, 4);
    const int center = 62;
    box.is_fixed[center] = 2;
    const TetComplex start = box;
    CHECK(optimise(box, {center}).moves == 0);
    RunContext context;
    ShapeOptions options;
    options.among = {center};
    options.least_gain_of_kept = 10;
    CHECK(optimise_shapes(box, options, context).moves == 0);
    CHECK(box.points == start.points);
    options.least_gain_of_kept = 0.05;
    CHECK(optimise_shapes(box, options, context).moves > 0);
    CHECK(mean_ratio(box) >= mean_ratio(start) + 0.05 / double(box.tets.size()));
    CHECK(worst_flatness(box) <= worst_flatness(start));
}

TEST_CASE("shape optimisation can be cancelled") {
    TetComplex box = box_of_tets(4, 0.19, 4);
    RunContext context;
    context.on_progress = [](std::string_view, double) { return false; };
    ShapeOptions options;
    options.among = all_vertices(box);
    CHECK_THROWS_AS(optimise_shapes(box, options, context), Cancelled);
}

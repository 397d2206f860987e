// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <random>

#include "catch.h"
#include "volume/tets/box_of_tets.h"
#include "volume/tets/edge_removal.h"

using namespace featuremesh;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A closed ring round the edge from (0,0,-1) to (0,0,1), which is the whole complex.
TetComplex random_ring(int size, std::mt19937& random) {
    std::uniform_real_distribution<double> radius(0.5, 1.5), height(-0.4, 0.4), shift(-0.3, 0.3);
    TetComplex complex;
    complex.points = {{0, 0, -1}, {0, 0, 1}};
    for (int i = 0; i < size; ++i) {
        const double angle = 2 * 3.14159265358979 * (i + shift(random)) / size, r = radius(random);
        complex.points.push_back({r * std::cos(angle), r * std::sin(angle), height(random)});
        complex.tets.push_back({0, 1, 2 + i, 2 + (i + 1) % size});
    }
    fix_all(complex);
    connect(complex);
    return complex;
}

/// The triangulation whose worst tet is the least flat.
RingTriangulation<> least_flat_triangulation(const TetComplex& complex, const EdgeRing& ring, double limit) {
    const auto flatness_of = [&](int a, int b, int c, int d) {
        return flatness(complex.points[a], complex.points[b], complex.points[c], complex.points[d]);
    };
    return triangulate_ring<WorstOf>(ring.size, limit, [&](int i, int j, int k) {
        const int a = ring.vertices[i], b = ring.vertices[j], c = ring.vertices[k];
        return std::max(flatness_of(a, b, c, ring.to), flatness_of(b, a, c, ring.from));
    });
}

/// Every triangulation of the polygon i..j, one after the other.
template <class Combine, class Cost>
double best_of_all(int i, int j, const Combine& combine, const Cost& cost) {
    if (j - i < 2) return 0;
    double best = infinity;
    for (int k = i + 1; k < j; ++k)
        best = std::min(
            best, combine(cost(i, k, j), combine(best_of_all(i, k, combine, cost), best_of_all(k, j, combine, cost))));
    return best;
}

}  // namespace

TEST_CASE("the best triangulation of a ring is the best of all") {
    std::mt19937 random(11);
    int removable = 0;
    for (int round = 0; round < 300; ++round) {
        const int size = 3 + round % (EdgeRing::max_size - 2);
        const TetComplex complex = random_ring(size, random);
        EdgeRing ring;
        REQUIRE(find_ring(complex, 0, 0, 1, ring));
        REQUIRE(ring.size == size);
        const auto& p = complex.points;
        const auto at = [&](int i) { return p[ring.vertices[i]]; };
        const double flattest = best_of_all(
            0, size - 1, [](double a, double b) { return std::max(a, b); },
            [&](int i, int j, int k) {
                return std::max(flatness(at(i), at(j), at(k), p[1]), flatness(at(j), at(i), at(k), p[0]));
            });
        const double lowest = best_of_all(
            0, size - 1, [](double a, double b) { return a + b; },
            [&](int i, int j, int k) {
                const double upper = odt_energy(at(i), at(j), at(k), p[1]),
                             lower = odt_energy(at(j), at(i), at(k), p[0]);
                return upper > 0 && lower > 0 ? upper + lower : infinity;
            });
        const double found = least_flat_triangulation(complex, ring, inverted_flatness).cost;
        REQUIRE((flattest < inverted_flatness ? found == flattest : std::isinf(found)));
        const double energy = lowest_energy_triangulation(complex, ring, 0, infinity).cost;
        REQUIRE((std::isinf(lowest) ? std::isinf(energy) : energy == Approx(lowest)));
        removable += flattest < inverted_flatness;
    }
    CHECK(removable > 50);
}

TEST_CASE("no flat tet comes of an edge's removal, whatever the sign of its rounding") {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> share(0.3, 1.2);
    int found = 0;
    for (int round = 0; round < 300; ++round) {
        TetComplex complex = random_ring(4 + round % (EdgeRing::max_size - 3), random);
        EdgeRing ring;
        REQUIRE(find_ring(complex, 0, 0, 1, ring));
        auto& p = complex.points;
        const Vec3 &from = p[ring.from], &a = p[ring.vertices[0]], &c = p[ring.vertices[2]];
        p[ring.vertices[1]] = from + share(random) * (a - from) + share(random) * (c - from);  // in one plane
        const auto best = lowest_energy_triangulation(complex, ring, 1e-9, infinity);
        if (std::isinf(best.cost)) continue;
        ++found;
        std::array<Tet, 2 * EdgeRing::max_size> fresh;
        const int count = tets_of_triangulation(ring, best, fresh);
        for (int i = 0; i < count; ++i) REQUIRE(volume_of(complex, fresh[i]) > 1e-12);
    }
    CHECK(found > 20);
}

TEST_CASE("removing an edge fills the same space") {
    std::mt19937 random(12);
    for (int round = 0; round < 100; ++round) {
        TetComplex complex = random_ring(3 + round % 6, random);
        const double volume = total_volume(complex);
        const auto outside = outside_of(complex);
        EdgeRing ring;
        REQUIRE(find_ring(complex, 0, 0, 1, ring));
        const auto best = least_flat_triangulation(complex, ring, inverted_flatness);
        if (std::isinf(best.cost)) continue;
        std::array<Tet, 2 * EdgeRing::max_size> fresh;
        const int count = tets_of_triangulation(ring, best, fresh);
        CHECK(count == 2 * (ring.size - 2));
        CavityEditor(complex).replace(ring.all_tets(), {fresh.data(), static_cast<std::size_t>(count)});
        CHECK(find_flaws(complex).empty());
        CHECK(total_volume(complex) == Approx(volume));
        CHECK(outside_of(complex) == outside);
        CHECK(worst_flatness(complex) == Approx(best.cost));
    }
}

TEST_CASE("a limit that cannot be met gives no triangulation") {
    std::mt19937 random(13);
    const TetComplex complex = random_ring(6, random);
    EdgeRing ring;
    REQUIRE(find_ring(complex, 0, 0, 1, ring));
    const double best = least_flat_triangulation(complex, ring, inverted_flatness).cost;
    REQUIRE(best < inverted_flatness);
    CHECK(std::isinf(least_flat_triangulation(complex, ring, best).cost));
}

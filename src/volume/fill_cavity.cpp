// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/fill_cavity.h"

namespace featuremesh {

CavityFill flood_cavity(const Cavity& cavity, std::vector<Vec3> points, Triangulation triangulation) {
    CavityFill fill;
    fill.points = std::move(points);
    fill.triangulation = std::move(triangulation);
    fill.places = find_facets(fill.triangulation, fill.points.size(), cavity.facets);
    if (!fill.places.missing.empty()) return fill;
    fill.regions = flood_regions(fill.triangulation, cavity.facets, fill.places);
    fill.is_leaky = fill.regions.empty();
    return fill;
}

CavityFill fill_cavity(const Cavity& cavity, std::span<const Ball> balls, std::span<const Vec3> active,
                       const WantedSize& size, RunContext& context, bool is_main) {
    std::vector<Vec3> points = cavity.points;
    const std::vector<Vec3> seeds =
        find_seeds(cavity.points, cavity.facets, balls, active, size, SeedOptions{}, context);
    points.insert(points.end(), seeds.begin(), seeds.end());
    Triangulation triangulation = delaunay(points, context, is_main);
    return flood_cavity(cavity, std::move(points), std::move(triangulation));
}

TetComplex make_complex(const Cavity& cavity, const CavityFill& fill) {
    const Triangulation& all = fill.triangulation;
    std::vector<int> new_index(all.tets.size(), -1);
    int count = 0;
    for (std::size_t t = 0; t < all.tets.size(); ++t)
        if (fill.regions[t] >= 0) new_index[t] = count++;
    TetComplex complex;
    complex.points = fill.points;
    complex.is_fixed.assign(fill.points.size(), 0);
    std::fill_n(complex.is_fixed.begin(), cavity.points.size(), std::uint8_t{1});
    complex.tet_of_vertex.assign(fill.points.size(), -1);
    complex.tets.reserve(count), complex.neighbours.reserve(count), complex.regions.reserve(count);
    for (std::size_t t = 0; t < all.tets.size(); ++t) {
        if (new_index[t] < 0) continue;
        auto& neighbours = complex.neighbours.emplace_back();
        for (int k = 0; k < 4; ++k) {
            const bool is_facet = fill.places.facet_at[4 * t + k] >= 0;
            neighbours[k] = is_facet || all.neighbours[t][k] < 0 ? -1 : new_index[all.neighbours[t][k]];
            complex.tet_of_vertex[all.tets[t][k]] = new_index[t];
        }
        complex.tets.push_back(all.tets[t]);
        complex.regions.push_back(fill.regions[t]);
    }
    return complex;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/fill_cavity.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace featuremesh {

namespace {

/// In wanted edge lengths; the circumspheres of the lattice's tets have 0.65. At active points only wider gaps count: a
/// mesh from scratch has gaps at the boundary, too, and would have fewer tets.
constexpr double radius_of_a_gap = 0.8, radius_among_active = 0.85;
/// Beside an interface or active points, which are no lattice, a point fits in closer than the lattice's distances.
constexpr SeedOptions places_in_gaps{.clearance = 0.5, .spacing = 0.7, .spares_facets = true};

/// Corners beside which the lattice may leave gaps: those of the interface with kept tets, and active points.
class CornersOffLattice {
  public:
    CornersOffLattice(std::span<const Vec3> points, const Cavity& cavity, std::size_t active_count,
                      const WantedSize& size)
        : first_active_(static_cast<int>(cavity.points.size())), wanted_(points.size(), 0) {
        for (std::size_t f = 0; f < cavity.facets.size(); ++f)
            if (cavity.tet_of_facet[f].is_valid())
                for (const int c : cavity.facets[f].corners)
                    if (wanted_[c] == 0) wanted_[c] = size.at(points[c]);
        for (std::size_t p = cavity.points.size(); p < cavity.points.size() + active_count; ++p)
            wanted_[p] = size.at(points[p]);
    }

    /// The size wanted at one of the tet's corners, if it has such corners; else 0.
    double size_at(const std::array<int, 4>& tet) const {
        const auto corner = std::find_if(tet.begin(), tet.end(), [&](int c) { return wanted_[c] > 0; });
        return corner == tet.end() ? 0 : wanted_[*corner];
    }

    /// From which radius on the tet's circumsphere is a gap, in wanted edge lengths.
    double least_radius(const std::array<int, 4>& tet) const {
        const bool is_at_interface =
            std::any_of(tet.begin(), tet.end(), [&](int c) { return c < first_active_ && wanted_[c] > 0; });
        return is_at_interface ? radius_of_a_gap : radius_among_active;
    }

  private:
    int first_active_;
    std::vector<double> wanted_;  // by point; 0 at others
};

/// Between the lattice and an interface, or active points, there may be room for a point that neither has. Left empty,
/// the mesh would get coarser with every update. Elsewhere a mesh from scratch has such room, too.
std::vector<Vec3> points_in_gaps(const Triangulation& triangulation, std::span<const Vec3> points,
                                 const CornersOffLattice& corners, SeedSpace& space, const WantedSize& size) {
    std::vector<std::pair<double, Vec3>> gaps;
    for (const auto& tet : triangulation.tets) {
        const double wanted = corners.size_at(tet);
        if (wanted == 0) continue;
        const Ball ball = circumsphere(points[tet[0]], points[tet[1]], points[tet[2]], points[tet[3]]);
        const double least = (1 - 1e-9) * (wanted - size.slope * ball.radius);  // wanted at its middle
        const double radius = corners.least_radius(tet);
        if (ball.radius < radius * least) continue;
        if (!(ball.radius > radius * size.at(ball.center) && ball.radius < 2 * size.largest)) continue;
        gaps.emplace_back(-ball.radius, ball.center);
    }
    std::sort(gaps.begin(), gaps.end(), [](const auto& a, const auto& b) {
        return std::tie(a.first, a.second.x, a.second.y, a.second.z) <
               std::tie(b.first, b.second.x, b.second.y, b.second.z);
    });
    std::vector<Vec3> centers;
    for (const auto& [radius, center] : gaps) centers.push_back(center);
    return space.with_room(centers, places_in_gaps);
}

void label(const Cavity& cavity, CavityFill& fill, RunContext& context) {
    if (!fill.places.missing.empty()) return;
    fill.regions = label_regions(fill.triangulation, cavity.facets, fill.places, context);
    fill.is_leaky = fill.regions.empty();
}

}  // namespace

std::vector<Ball> interface_balls(const Mesh& mesh, const Cavity& cavity, const WantedSize& size) {
    std::vector<Ball> balls;
    for (const TetId tet : cavity.tet_of_facet) {
        if (!tet.is_valid()) continue;
        const auto& n = mesh.tets[tet.index()];
        const Ball ball = circumsphere(mesh.point(n[0]), mesh.point(n[1]), mesh.point(n[2]), mesh.point(n[3]));
        if (ball.radius < radius_of_a_gap * size.at(ball.center))
            balls.push_back({ball.center, ball.radius * (1 + 1e-9)});
    }
    return balls;
}

bool has_inverted_tet(const CavityFill& fill) {
    for (std::size_t t = 0; t < fill.regions.size(); ++t) {
        if (fill.regions[t] < 0) continue;
        const auto& tet = fill.triangulation.tets[t];
        const Vec3 &a = fill.points[tet[0]], &b = fill.points[tet[1]], &c = fill.points[tet[2]],
                   &d = fill.points[tet[3]];
        const double edge = std::sqrt(std::max({squared_length(b - a), squared_length(c - a), squared_length(d - a)}));
        if (signed_volume(a, b, c, d) < -1e-12 * edge * edge * edge) return true;
    }
    return false;
}

CavityFill label_cavity(const Cavity& cavity, std::vector<Vec3> points, Triangulation triangulation,
                        RunContext& context) {
    CavityFill fill;
    fill.points = std::move(points);
    fill.triangulation = std::move(triangulation);
    fill.places = find_facets(fill.triangulation, fill.points.size(), cavity.facets, context);
    label(cavity, fill, context);
    return fill;
}

void label_turned(const Cavity& cavity, CavityFill& fill, RunContext& context) {
    place_missing(fill.triangulation, fill.points.size(), cavity.facets, fill.places, context);
    label(cavity, fill, context);
}

CavityFill fill_cavity(const Cavity& cavity, std::span<const Ball> balls, std::span<const Vec3> active,
                       const WantedSize& size, RunContext& context) {
    std::vector<Vec3> points = cavity.points;
    SeedSpace space(cavity.points, cavity.facets, balls, size, SeedOptions{}, context);
    const Seeds seeds = space.seeds(active);
    points.insert(points.end(), seeds.points.begin(), seeds.points.end());
    if (balls.empty() && seeds.active_count == 0) {
        Triangulation triangulation = delaunay(points, context);
        return label_cavity(cavity, std::move(points), std::move(triangulation), context);
    }
    const auto growing = std::make_shared<GrowingDelaunay>();
    growing->insert(points, context);
    Triangulation triangulation = growing->tets(context);
    const CornersOffLattice corners(points, cavity, seeds.active_count, size);
    const std::vector<Vec3> more = points_in_gaps(triangulation, points, corners, space, size);
    if (!more.empty()) {
        growing->insert(more, context);
        points.insert(points.end(), more.begin(), more.end());
        triangulation = growing->tets(context);
    }
    CavityFill fill = label_cavity(cavity, std::move(points), std::move(triangulation), context);
    if (fill.is_complete()) return fill;
    fill.delaunay = growing;
    fill.point_of.resize(fill.points.size());
    std::iota(fill.point_of.begin(), fill.point_of.end(), 0);
    return fill;
}

CavityFill grow_fill(const Cavity& cavity, std::span<const NodeId> old_nodes, const CavityFill& old,
                     RunContext& context) {
    std::vector<int> new_place(old.points.size(), -1);  // by point of the old fill
    std::vector<Vec3> points = cavity.points, added;
    std::vector<int> place_of_added;
    for (std::size_t n = 0; n < cavity.nodes.size(); ++n) {
        const auto known = std::lower_bound(old_nodes.begin(), old_nodes.end(), cavity.nodes[n]);
        if (known != old_nodes.end() && *known == cavity.nodes[n]) {
            new_place[static_cast<std::size_t>(known - old_nodes.begin())] = static_cast<int>(n);
        } else {
            place_of_added.push_back(static_cast<int>(n));
            added.push_back(cavity.points[n]);
        }
    }
    for (std::size_t p = 0; p < old.points.size(); ++p) {
        if (new_place[p] >= 0) continue;
        new_place[p] = static_cast<int>(points.size());
        points.push_back(old.points[p]);
    }
    if (!added.empty()) old.delaunay->insert(added, context);
    std::vector<int> point_of;
    for (const int p : old.point_of) point_of.push_back(new_place[static_cast<std::size_t>(p)]);
    point_of.insert(point_of.end(), place_of_added.begin(), place_of_added.end());
    CavityFill fill = label_cavity(cavity, std::move(points), old.delaunay->tets(context, point_of), context);
    fill.delaunay = old.delaunay;
    fill.point_of = std::move(point_of);
    return fill;
}

std::vector<Vec3> seeds_of(const Cavity& cavity, const CavityFill& fill) {
    return {fill.points.begin() + static_cast<std::ptrdiff_t>(cavity.points.size()), fill.points.end()};
}

std::vector<Vec3> seeds_among(std::span<const Vec3> active, const Cavity& cavity, const CavityFill& fill) {
    const auto before = [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
    std::vector<Vec3> sorted(active.begin(), active.end());
    std::sort(sorted.begin(), sorted.end(), before);
    std::vector<Vec3> seeds = seeds_of(cavity, fill);
    std::erase_if(seeds, [&](const Vec3& p) { return !std::binary_search(sorted.begin(), sorted.end(), p, before); });
    return seeds;
}

TetComplex make_complex(const Cavity& cavity, const CavityFill& fill, const RunContext& context) {
    RoundWatch watch(context);
    const Triangulation& all = fill.triangulation;
    std::vector<int> new_index(all.tets.size(), -1);
    int count = 0;
    for (std::size_t t = 0; t < all.tets.size(); ++t)
        if (fill.regions[t] >= 0) new_index[t] = count++;
    TetComplex complex;
    complex.points = fill.points;
    complex.mobility.assign(fill.points.size(), Mobility::free);
    std::fill_n(complex.mobility.begin(), cavity.points.size(), Mobility::fixed);
    complex.tet_of_vertex.assign(fill.points.size(), -1);
    complex.tets.reserve(count), complex.neighbours.reserve(count), complex.regions.reserve(count);
    for (std::size_t t = 0; t < all.tets.size(); ++t) {
        watch();
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

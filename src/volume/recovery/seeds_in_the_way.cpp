// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/seeds_in_the_way.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/geometry.h"
#include "core/sort_once.h"
#include "volume/recovery/neighbourhood.h"

namespace featuremesh {

namespace {

/// For one facet: a room without more than so many seeds stays empty in the mesh.
constexpr std::size_t most_seeds = 3;
/// How far the middles of balls go from the facet, in radii of its circle. Larger balls have more seeds.
constexpr double reach_of_middles = 1;

/// Points by one coordinate, to be found in boxes.
class SortedPoints {
  public:
    explicit SortedPoints(std::span<const Vec3> points) : points_(points), order_(points.size()) {
        std::iota(order_.begin(), order_.end(), 0);
        std::sort(order_.begin(), order_.end(),
                  [&](int a, int b) { return std::pair(points_[a].x, a) < std::pair(points_[b].x, b); });
    }

    std::vector<int> within(const Vec3& middle, double reach) const {
        std::vector<int> found;
        auto at = std::lower_bound(order_.begin(), order_.end(), middle.x - reach,
                                   [&](int i, double x) { return points_[i].x < x; });
        for (; at != order_.end() && points_[*at].x <= middle.x + reach; ++at)
            if (squared_length(points_[*at] - middle) < reach * reach) found.push_back(*at);
        return found;
    }

  private:
    std::span<const Vec3> points_;
    std::vector<int> order_;
};

/// The balls with the three corners of a facet on the sphere, by how far the middle is along the normal. Each point is
/// inside of those beyond a bound, at one side or the other.
class BallsOfFacet {
  public:
    BallsOfFacet(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 u = b - a, v = c - a, n = cross(u, v);
        const Vec3 to_center =
            (cross(n, u) * squared_length(v) + cross(v, n) * squared_length(u)) / (2 * squared_length(n));
        center_ = a + to_center, normal_ = normalized(n), squared_ = squared_length(to_center);
        high_ = reach_of_middles * std::sqrt(squared_), low_ = -high_;
    }

    const Vec3& center() const { return center_; }
    double reach() const { return 3 * std::sqrt(squared_); }
    bool is_any_left() const { return low_ < high_; }

    /// No ball with this point.
    void leave_out(const Vec3& p) {
        const auto [bound, is_above] = bound_of(p);
        if (is_above)
            high_ = std::min(high_, bound);
        else
            low_ = std::max(low_, bound);
    }
    void count(int seed, const Vec3& p) {
        const auto [bound, is_above] = bound_of(p);
        bounds_.push_back({seed, bound, is_above});
    }

    /// The seeds in a ball with the fewest; of several such balls the one with the most play.
    std::vector<int> fewest() const {
        std::vector<double> stops{low_, high_};
        for (const Bound& b : bounds_)
            if (b.at > low_ && b.at < high_) stops.push_back(b.at);
        std::sort(stops.begin(), stops.end());
        std::vector<int> best;
        double play = -1;
        for (std::size_t i = 1; i < stops.size(); ++i) {
            std::vector<int> inside = seeds_in(0.5 * (stops[i - 1] + stops[i]));
            const double width = stops[i] - stops[i - 1];
            if (play >= 0 && std::pair(inside.size(), -width) >= std::pair(best.size(), -play)) continue;
            best = std::move(inside), play = width;
        }
        return best;
    }

  private:
    struct Bound {
        int seed;
        double at;
        bool is_above;  ///< inside of the balls whose middle is further along the normal
    };

    /// |p - center - s n|^2 < r^2 + s^2, solved for s.
    std::pair<double, bool> bound_of(const Vec3& p) const {
        const Vec3 way = p - center_;
        const double height = dot(way, normal_), outside = squared_length(way) - squared_;
        if (height == 0) return {outside < 0 ? low_ : high_, true};
        return {outside / (2 * height), height > 0};
    }
    std::vector<int> seeds_in(double middle) const {
        std::vector<int> seeds;
        for (const Bound& b : bounds_)
            if (b.is_above ? middle > b.at : middle < b.at) seeds.push_back(b.seed);
        return seeds;
    }

    Vec3 center_, normal_;
    double squared_ = 0, low_ = 0, high_ = 0;
    std::vector<Bound> bounds_;
};

/// None where the facet cannot be had so.
std::vector<int> in_the_way_of(const std::array<int, 3>& corners, const Cavity& cavity, const CavityFill& fill,
                               const SortedPoints& sorted) {
    const auto& p = fill.points;
    BallsOfFacet balls(p[corners[0]], p[corners[1]], p[corners[2]]);
    for (const int i : sorted.within(balls.center(), balls.reach())) {
        if (std::find(corners.begin(), corners.end(), i) != corners.end()) continue;
        if (i < static_cast<int>(cavity.points.size()))
            balls.leave_out(p[i]);
        else
            balls.count(i, p[i]);
    }
    if (!balls.is_any_left()) return {};
    std::vector<int> seeds = balls.fewest();
    if (seeds.size() > most_seeds) seeds.clear();
    return seeds;
}

}  // namespace

std::vector<int> seeds_in_the_way(const Cavity& cavity, const CavityFill& fill, std::span<const int> facets) {
    const SortedPoints sorted(fill.points);
    std::vector<int> all;
    for (const int facet : facets) {
        const std::vector<int> seeds = in_the_way_of(cavity.facets[facet].corners, cavity, fill, sorted);
        if (seeds.empty()) return {};
        all.insert(all.end(), seeds.begin(), seeds.end());
    }
    sort_once(all);
    return all;
}

std::optional<Triangulation> triangulation_without(std::span<const int> dropped, const Cavity& cavity,
                                                   const CavityFill& fill, RunContext& context) {
    std::vector<std::uint8_t> is_dropped(fill.points.size(), 0), is_inner;
    for (const int point : dropped) is_dropped[point] = 1;
    is_inner.reserve(fill.triangulation.tets.size());
    for (const auto& tet : fill.triangulation.tets)
        is_inner.push_back(std::any_of(tet.begin(), tet.end(), [&](int c) { return is_dropped[c] != 0; }));
    const Neighbourhood around(cavity, fill, std::move(is_inner), dropped);
    return around.merge(delaunay(around.cavity().points, context), 0);
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/lattice_seeds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_set>

#include "volume/distance_to_triangle.h"
#include "volume/region_locator.h"

namespace featuremesh {

namespace {

/// A cube of the octree: its lowest corner and edge in units of the finest half cell.
struct Cube {
    std::array<std::int64_t, 3> low;
    std::int64_t edge;
};

/// Facets and balls that may be near a cube.
struct Neighbours {
    std::vector<int> facets, balls;
    bool is_empty() const { return facets.empty() && balls.empty(); }
};

constexpr int finest_level = 12;  ///< below the root cells
constexpr std::int64_t root_edge = std::int64_t{2} << finest_level;

using LatticePoint = std::array<std::int64_t, 3>;

std::uint64_t hash_of(const LatticePoint& at) {
    std::uint64_t state = 0x9e3779b97f4a7c15ull;
    for (const std::int64_t x : at)
        state = (state ^ static_cast<std::uint64_t>(x)) * 0xbf58476d1ce4e5b9ull, state ^= state >> 29;
    return state;
}
struct HashPoint {
    std::size_t operator()(const LatticePoint& at) const { return hash_of(at); }
};

class SeedOctree {
  public:
    SeedOctree(std::span<const Vec3> points, std::span<const Facet> facets, std::span<const Ball> balls,
               const WantedSize& size, const SeedOptions& options, const RunContext& context)
        : points_(points),
          facets_(facets),
          balls_(balls),
          size_(size),
          options_(options),
          context_(context),
          locator_(points, facets),
          unit_(lattice_constant(size.largest) / root_edge) {
        boxes_.resize(facets.size());
        for (std::size_t i = 0; i < facets.size(); ++i)
            for (const int c : facets[i].corners) boxes_[i].add(points[c]);
    }

    std::vector<Vec3> lattice_points() {
        if (!facets_.empty()) split_root(root_cube(), all_neighbours());
        std::vector<Vec3> seeds;
        seeds.reserve(lattice_.size());
        for (const LatticePoint& at : lattice_) seeds.push_back(nudged(at));
        return seeds;
    }

    /// Those of the candidates that are inside and clear of facets and balls, in their order.
    std::vector<Vec3> clear_points(std::span<const Vec3> candidates) const {
        std::vector<std::uint8_t> is_good(candidates.size(), 0);
        std::vector<int> all(candidates.size());
        std::iota(all.begin(), all.end(), 0);
        if (!facets_.empty()) mark_clear(root_cube(), all_neighbours(), candidates, all, is_good);
        std::vector<Vec3> good;
        for (std::size_t i = 0; i < candidates.size(); ++i)
            if (is_good[i]) good.push_back(candidates[i]);
        return good;
    }

  private:
    Neighbours all_neighbours() const {
        Neighbours all;
        all.facets.resize(facets_.size());
        all.balls.resize(balls_.size());
        std::iota(all.facets.begin(), all.facets.end(), 0);
        std::iota(all.balls.begin(), all.balls.end(), 0);
        return all;
    }
    static bool holds(const Box& box, const Vec3& p) {
        return p.x >= box.low.x && p.y >= box.low.y && p.z >= box.low.z && p.x < box.high.x && p.y < box.high.y &&
               p.z < box.high.z;
    }

    void mark_clear(const Cube& cube, const Neighbours& candidates, std::span<const Vec3> points,
                    const std::vector<int>& among, std::vector<std::uint8_t>& is_good) const {
        const Box box = box_of(cube);
        std::vector<int> here;
        for (const int i : among)
            if (holds(box, points[i])) here.push_back(i);
        if (here.empty()) return;
        const Neighbours close = near(cube, wanted(box.center()), candidates);
        if (here.size() > 2 && !close.is_empty() && cube.edge > 2)
            return visit_children(cube, [&](const Cube& child) { mark_clear(child, close, points, here, is_good); });
        for (const int i : here) is_good[i] = is_clear(points[i], wanted(points[i]), close);
    }

    Vec3 place(const LatticePoint& at) const {
        return {static_cast<double>(at[0]) * unit_, static_cast<double>(at[1]) * unit_,
                static_cast<double>(at[2]) * unit_};
    }
    Box box_of(const Cube& cube) const {
        Box box;
        box.add(place(cube.low));
        box.add(place({cube.low[0] + cube.edge, cube.low[1] + cube.edge, cube.low[2] + cube.edge}));
        return box;
    }
    double wanted(const Vec3& p) const { return size_.is_uniform ? size_.largest : size_.at(p); }

    /// The smallest cube of 2^k root cells that holds all facets.
    Cube root_cube() const {
        Box box;
        for (const Box& b : boxes_) box.add(b);
        Cube cube{{}, root_edge};
        const double cell = unit_ * root_edge;
        std::int64_t cells = 1;
        for (int k = 0; k < 3; ++k) {
            const auto first = static_cast<std::int64_t>(std::floor(box.low[k] / cell)) - 1;
            const auto last = static_cast<std::int64_t>(std::floor(box.high[k] / cell)) + 1;
            cube.low[k] = first * root_edge;
            cells = std::max(cells, last - first + 1);
        }
        while (cube.edge < cells * root_edge) cube.edge *= 2;
        return cube;
    }

    /// What may be nearer to a point of the cube than the clearance; `size` is wanted at the cube's center.
    Neighbours near(const Cube& cube, double size, const Neighbours& candidates) const {
        const Box box = box_of(cube);
        const double reach = size_.is_uniform ? size : std::min(size_.largest, size + 0.5 * box.diagonal());
        const Box grown = box.grown(options_.clearance * reach);
        Neighbours found;
        for (const int i : candidates.facets)
            if (grown.overlaps(boxes_[i])) found.facets.push_back(i);
        for (const int i : candidates.balls) {
            const double r = balls_[i].radius;
            if (squared_distance_to_box(balls_[i].center, box) < r * r) found.balls.push_back(i);
        }
        return found;
    }

    static double squared_distance_to_box(const Vec3& p, const Box& b) {
        const Vec3 off{std::max({b.low.x - p.x, 0.0, p.x - b.high.x}), std::max({b.low.y - p.y, 0.0, p.y - b.high.y}),
                       std::max({b.low.z - p.z, 0.0, p.z - b.high.z})};
        return squared_length(off);
    }

    template <class Visit>
    static void visit_children(const Cube& cube, Visit visit) {
        const std::int64_t half = cube.edge / 2;
        for (int k = 0; k < 8; ++k)
            visit(Cube{
                {cube.low[0] + (k & 1 ? half : 0), cube.low[1] + (k & 2 ? half : 0), cube.low[2] + (k & 4 ? half : 0)},
                half});
    }

    double wanted_in(const Cube& cube) const { return wanted(box_of(cube).center()); }

    void split_root(const Cube& cube, const Neighbours& candidates) {
        context_.check_cancelled();
        const double size = wanted_in(cube);
        const Neighbours close = near(cube, size, candidates);
        if (close.is_empty()) {
            if (is_free_cube_inside(cube, size)) fill_free(cube);
        } else if (cube.edge > root_edge) {
            visit_children(cube, [&](const Cube& child) { split_root(child, close); });
        } else {
            refine(cube, size, close);
        }
    }

    /// No facet is near the cube, so it is inside one region as a whole, or outside.
    bool is_free_cube_inside(const Cube& cube, double size) const {
        return locator_.region_at(box_of(cube).center(), 0.5 * options_.clearance * size) >= 0;
    }

    void fill_free(const Cube& cube) {
        if (!is_cell(cube, wanted_in(cube))) return visit_children(cube, [&](const Cube& child) { fill_free(child); });
        visit_points(cube, [&](const LatticePoint& at) { lattice_.push_back(at); });
    }

    void refine(const Cube& cube, double size, const Neighbours& close) {
        if (close.is_empty()) {
            if (is_free_cube_inside(cube, size)) fill_free(cube);
            return;
        }
        if (!is_cell(cube, size))
            return visit_children(cube, [&](const Cube& child) {
                const double child_size = wanted_in(child);
                refine(child, child_size, near(child, child_size, close));
            });
        visit_points(cube, [&](const LatticePoint& at) {
            if (is_clear(place(at), size, close)) lattice_.push_back(at);
        });
    }

    bool is_cell(const Cube& cube, double size) const {
        if (cube.edge > root_edge) return false;
        if (size_.is_uniform || cube.edge <= 2) return true;
        return static_cast<double>(cube.edge) * unit_ <= std::sqrt(2.0) * lattice_constant(size);
    }

    /// The middle and the corners that no cell before had. Cells of one size need only their first corner: the others
    /// are their neighbours' first.
    template <class Visit>
    void visit_points(const Cube& cube, Visit visit) {
        const std::int64_t half = cube.edge / 2;
        visit(LatticePoint{cube.low[0] + half, cube.low[1] + half, cube.low[2] + half});
        if (size_.is_uniform) return visit(cube.low);
        for (int k = 0; k < 8; ++k) {
            const LatticePoint corner{cube.low[0] + (k & 1 ? cube.edge : 0), cube.low[1] + (k & 2 ? cube.edge : 0),
                                      cube.low[2] + (k & 4 ? cube.edge : 0)};
            if (seen_corners_.insert(corner).second) visit(corner);
        }
    }

    bool is_clear(const Vec3& p, double size, const Neighbours& close) const {
        const double clearance = options_.clearance * size, squared = clearance * clearance;
        for (const int i : close.balls)
            if (squared_length(p - balls_[i].center) < balls_[i].radius * balls_[i].radius) return false;
        for (const int i : close.facets) {
            const auto& c = facets_[i].corners;
            if (squared_distance_to_box(p, boxes_[i]) < squared &&
                squared_distance_to_triangle(p, points_[c[0]], points_[c[1]], points_[c[2]]) < squared)
                return false;
        }
        return locator_.region_at(p, 0.5 * clearance) >= 0;
    }

    Vec3 nudged(const LatticePoint& at) const {
        const std::uint64_t state = hash_of(at);
        const auto offset = [&](int shift) {
            return (static_cast<double>((state >> shift) & 0xfffff) / 0x100000 - 0.5) * 1e-6 * unit_ * root_edge;
        };
        return place(at) + Vec3{offset(0), offset(20), offset(40)};
    }

    std::span<const Vec3> points_;
    std::span<const Facet> facets_;
    std::span<const Ball> balls_;
    const WantedSize& size_;
    const SeedOptions& options_;
    const RunContext& context_;
    RegionLocator locator_;
    double unit_;
    std::vector<Box> boxes_;
    std::unordered_set<LatticePoint, HashPoint> seen_corners_;
    std::vector<LatticePoint> lattice_;
};

/// Leaves out points nearer than the spacing to one before them.
std::vector<Vec3> thinned(const std::vector<Vec3>& points, const WantedSize& size, double spacing) {
    using Key = std::array<std::int64_t, 3>;
    const double width = spacing * size.largest;
    std::map<Key, std::vector<Vec3>> grid;
    std::vector<Vec3> apart;
    for (const Vec3& p : points) {
        const double squared = std::pow(spacing * size.at(p), 2);
        const Key at{static_cast<std::int64_t>(std::floor(p.x / width)),
                     static_cast<std::int64_t>(std::floor(p.y / width)),
                     static_cast<std::int64_t>(std::floor(p.z / width))};
        bool has_room = true;
        for (int k = 0; k < 27 && has_room; ++k) {
            const auto cell = grid.find({at[0] + k % 3 - 1, at[1] + k / 3 % 3 - 1, at[2] + k / 9 - 1});
            if (cell == grid.end()) continue;
            has_room = std::none_of(cell->second.begin(), cell->second.end(),
                                    [&](const Vec3& q) { return squared_length(p - q) < squared; });
        }
        if (!has_room) continue;
        grid[at].push_back(p);
        apart.push_back(p);
    }
    return apart;
}

}  // namespace

std::vector<Vec3> find_seeds(std::span<const Vec3> points, std::span<const Facet> facets, std::span<const Ball> balls,
                             std::span<const Vec3> active, const WantedSize& size, const SeedOptions& options,
                             const RunContext& context) {
    std::vector<Vec3> seeds;
    std::vector<Ball> occupied(balls.begin(), balls.end());
    if (!active.empty()) {
        seeds = seeds_with_room(active, points, facets, balls, size, options, context);
        for (const Vec3& p : seeds) occupied.push_back({p, options.spacing * size.at(p)});
    }
    const std::vector<Vec3> lattice = SeedOctree(points, facets, occupied, size, options, context).lattice_points();
    seeds.insert(seeds.end(), lattice.begin(), lattice.end());
    return seeds;
}

std::vector<Vec3> seeds_with_room(std::span<const Vec3> candidates, std::span<const Vec3> points,
                                  std::span<const Facet> facets, std::span<const Ball> balls, const WantedSize& size,
                                  const SeedOptions& options, const RunContext& context) {
    return thinned(SeedOctree(points, facets, balls, size, options, context).clear_points(candidates), size,
                   options.spacing);
}

}  // namespace featuremesh

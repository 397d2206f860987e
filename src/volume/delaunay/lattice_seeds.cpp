// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/delaunay/lattice_seeds.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_set>

#include "core/distances.h"
#include "volume/delaunay/region_locator.h"

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

/// Active points were nodes of a good mesh, which the lattice's distances would leave out where sizes are graded.
constexpr SeedOptions proven_places{.clearance = 0.5, .spacing = 0.6};

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

/// Cubes are split where somebody looks, once: candidates, active points and the lattice are held against the same.
class SeedOctree {
  public:
    SeedOctree(std::span<const Vec3> points, std::span<const Facet> facets, std::span<const Ball> balls,
               const WantedSize& size, const SeedOptions& options, const RunContext& context)
        : points_(points),
          facets_(facets),
          boxes_(boxes_of(points, facets)),
          locator_(points, facets),
          balls_(balls.begin(), balls.end()),
          ball_count_(balls.size()),
          size_(size),
          options_(options),
          context_(context),
          unit_(lattice_constant(size.root) / root_edge) {
        if (!facets_.empty()) places_.push_back(whole());
    }

    std::vector<Vec3> lattice_points() {
        is_kept_ = !balls_.empty() || places_.size() > 1;  // candidates have split some, in their own order
        lattice_.clear(), seen_corners_.clear();
        if (!places_.empty()) collect(0);
        if (!is_kept_ && !places_.empty()) places_.assign(1, whole());
        std::vector<Vec3> seeds;
        seeds.reserve(lattice_.size());
        for (const LatticePoint& at : lattice_) seeds.push_back(nudged(at));
        return seeds;
    }

    /// The candidates that lie inside, and clear of the facets and of the first `ball_count` balls, in their order. The
    /// options may not ask for a larger clearance than the lattice keeps.
    std::vector<Vec3> clear_points(std::span<const Vec3> candidates, const SeedOptions& options) {
        std::vector<Vec3> good;
        for (const Vec3& p : candidates) {
            const int place = place_at(p);
            if (place < 0) continue;
            const Place& around = places_[static_cast<std::size_t>(place)];
            if (is_clear(p, options.clearance * wanted(p), around, ball_count_) &&
                !(options.spares_facets && would_break_a_facet(p, around)))
                good.push_back(p);
        }
        return good;
    }

    /// The lattice keeps clear of the point from now on.
    void add_point(const Vec3& p, double clearance) {
        balls_.push_back({p, clearance});
        if (!places_.empty()) add_ball(0, static_cast<int>(balls_.size()) - 1);
    }

  private:
    /// A cube, the size wanted at its center, and what may be nearer to a point of it than the clearance; once it is
    /// split that is asked of its octants.
    struct Place {
        Cube cube;
        double size = 0;
        Neighbours close;
        int octants = -1;                              ///< the first of eight in a row
        bool is_looked_at = false, is_inside = false;  ///< inside a region as a whole, where no facet is near
    };

    static std::vector<Box> boxes_of(std::span<const Vec3> points, std::span<const Facet> facets) {
        std::vector<Box> boxes(facets.size());
        for (std::size_t i = 0; i < facets.size(); ++i)
            for (const int c : facets[i].corners) boxes[i].add(points[c]);
        return boxes;
    }

    /// Splits the place where that is of use.
    void look_at(int i) {
        Place& place = places_[static_cast<std::size_t>(i)];
        if (place.is_looked_at) return;
        place.is_looked_at = true;
        if (place.close.is_empty() || is_cell(place.cube, place.size)) return;
        const bool is_free = place.close.facets.empty();
        if (is_free && !place.is_inside) return;
        context_.check_cancelled();
        std::array<Place, 8> parts = octants(place);
        place.octants = static_cast<int>(places_.size());
        place.close = {};
        for (Place& part : parts) {
            if (part.close.facets.empty()) part.is_inside = is_free || is_free_cube_inside(part.cube, part.size);
            places_.push_back(std::move(part));
        }
    }

    /// The undivided place that holds p, -1 outside of all.
    int place_at(const Vec3& p) {
        if (places_.empty() || !holds(box_of(places_[0].cube), p)) return -1;
        int at = 0;
        for (look_at(at); places_[static_cast<std::size_t>(at)].octants >= 0; look_at(at)) {
            const Place& place = places_[static_cast<std::size_t>(at)];
            const Vec3 middle = this->place(octant(place.cube, 7).low);
            at = place.octants + (p.x >= middle.x) + 2 * (p.y >= middle.y) + 4 * (p.z >= middle.z);
        }
        return at;
    }

    void add_ball(int i, int ball) {
        Place& place = places_[static_cast<std::size_t>(i)];
        if (place.octants < 0) {
            place.close.balls.push_back(ball);
            place.is_looked_at = false;
            return;
        }
        const Box first = box_of(octant(place.cube, 0)), last = box_of(octant(place.cube, 7));
        const unsigned near = octants_overlapped(first, last, box_of(balls_[static_cast<std::size_t>(ball)]));
        for (int k = 0, octants = place.octants; k < 8; ++k)
            if (near >> k & 1) add_ball(octants + k, ball);
    }

    static Box box_of(const Ball& ball) {
        const Vec3 reach{ball.radius, ball.radius, ball.radius};
        return {ball.center - reach, ball.center + reach};
    }

    static bool holds(const Box& box, const Vec3& p) {
        return p.x >= box.low.x && p.y >= box.low.y && p.z >= box.low.z && p.x < box.high.x && p.y < box.high.y &&
               p.z < box.high.z;
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

    Place whole() const {
        Place root{root_cube(), 0, {}};
        root.size = wanted_in(root.cube);
        root.close.facets.resize(facets_.size());
        root.close.balls.resize(balls_.size());
        std::iota(root.close.facets.begin(), root.close.facets.end(), 0);
        std::iota(root.close.balls.begin(), root.close.balls.end(), 0);
        return root;
    }

    double reach(const Cube& cube, double size) const {
        return options_.clearance *
               (size_.is_uniform ? size : std::min(size_.largest, size + 0.5 * box_of(cube).diagonal()));
    }

    /// The eight octants of a cube, with what of its neighbours may be near to each: each neighbour is looked at once.
    std::array<Place, 8> octants(const Place& parent) const {
        std::array<Place, 8> places;
        double widest = 0;
        for (int k = 0; k < 8; ++k) {
            places[k].cube = octant(parent.cube, k);
            places[k].size = wanted_in(places[k].cube);
            widest = std::max(widest, reach(places[k].cube, places[k].size));
        }
        const Box first = box_of(places[0].cube), last = box_of(places[7].cube);
        const Box first_grown = first.grown(widest), last_grown = last.grown(widest);
        deal_out(
            parent.close.facets, [&](int i) { return octants_overlapped(first_grown, last_grown, boxes_[i]); }, places,
            &Neighbours::facets);
        deal_out(
            parent.close.balls, [&](int i) { return octants_overlapped(first, last, box_of(balls_[i])); }, places,
            &Neighbours::balls);
        return places;
    }

    template <class OctantsOf>
    static void deal_out(const std::vector<int>& items, OctantsOf octants_of, std::array<Place, 8>& places,
                         std::vector<int> Neighbours::*list) {
        std::vector<std::uint8_t> near(items.size());
        std::array<std::size_t, 8> counts{};
        for (std::size_t i = 0; i < items.size(); ++i) {
            near[i] = static_cast<std::uint8_t>(octants_of(items[i]));
            for (int k = 0; k < 8; ++k) counts[k] += near[i] >> k & 1;
        }
        std::array<int*, 8> next;
        for (int k = 0; k < 8; ++k) {
            std::vector<int>& own = places[k].close.*list;
            own.resize(counts[k]);
            next[k] = own.data();
        }
        for (std::size_t i = 0; i < items.size(); ++i)
            for (unsigned left = near[i]; left != 0; left &= left - 1) *next[std::countr_zero(left)]++ = items[i];
    }

    /// Bit k for octant k; `first` and `last` are the octants of the lowest and the highest corner.
    static unsigned octants_overlapped(const Box& first, const Box& last, const Box& box) {
        constexpr unsigned low[3] = {0x55, 0x33, 0x0f};
        unsigned octants = 0xff;
        for (int axis = 0; axis < 3; ++axis) {
            const bool in_first = (box.low[axis] <= first.high[axis]) & (box.high[axis] >= first.low[axis]);
            const bool in_last = (box.low[axis] <= last.high[axis]) & (box.high[axis] >= last.low[axis]);
            octants &= (in_first ? low[axis] : 0) | (in_last ? ~low[axis] : 0);
        }
        return octants;
    }

    static Cube octant(const Cube& cube, int k) {
        const std::int64_t half = cube.edge / 2;
        return {{cube.low[0] + (k & 1 ? half : 0), cube.low[1] + (k & 2 ? half : 0), cube.low[2] + (k & 4 ? half : 0)},
                half};
    }

    double wanted_in(const Cube& cube) const { return wanted(box_of(cube).center()); }

    /// Adds the lattice's points in the place. Octants that were made for this alone are given up at once where there
    /// is no interface, because many facets make many octants.
    void collect(int i) {
        look_at(i);
        const Place& place = places_[static_cast<std::size_t>(i)];
        if (place.octants < 0) {
            collect_undivided(place);
            return;
        }
        const int first = place.octants;
        for (int k = 0; k < 8; ++k) collect(first + k);
        if (!is_kept_) places_.resize(static_cast<std::size_t>(first));
    }

    void collect_undivided(const Place& place) {
        if (place.close.is_empty()) {
            if (place.is_inside) fill_free(place.cube);
        } else if (is_cell(place.cube, place.size)) {
            visit_points(place.cube, [&](const LatticePoint& point) {
                if (is_clear(this->place(point), options_.clearance * place.size, place, balls_.size()))
                    lattice_.push_back(point);
            });
        }
    }

    /// No facet is near the cube, so it is inside one region as a whole, or outside.
    bool is_free_cube_inside(const Cube& cube, double size) const {
        return locator_.region_at(box_of(cube).center(), 0.5 * options_.clearance * size) >= 0;
    }

    void fill_free(const Cube& cube) {
        if (!is_cell(cube, wanted_in(cube))) {
            for (int k = 0; k < 8; ++k) fill_free(octant(cube, k));
            return;
        }
        visit_points(cube, [&](const LatticePoint& at) { lattice_.push_back(at); });
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

    /// Inside the ball around a facet: Delaunay would not have that facet any more.
    bool would_break_a_facet(const Vec3& p, const Place& place) const {
        return std::any_of(place.close.facets.begin(), place.close.facets.end(), [&](int i) {
            const auto& c = facets_[i].corners;
            const Vec3 &a = points_[c[0]], u = points_[c[1]] - a, v = points_[c[2]] - a, n = cross(u, v);
            const Vec3 to_center =
                (cross(n, u) * squared_length(v) + cross(v, n) * squared_length(u)) / (2 * squared_length(n));
            return squared_length(p - a - to_center) < squared_length(to_center);
        });
    }

    /// Further than `clearance` (mm) from facets, and outside of the first `ball_count` balls.
    bool is_clear(const Vec3& p, double clearance, const Place& place, std::size_t ball_count) const {
        const double squared = clearance * clearance;
        for (const int i : place.close.balls)
            if (static_cast<std::size_t>(i) < ball_count &&
                squared_length(p - balls_[i].center) < balls_[i].radius * balls_[i].radius)
                return false;
        if (place.close.facets.empty()) return place.is_inside;
        for (const int i : place.close.facets) {
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
    std::vector<Box> boxes_;  // by facet
    RegionLocator locator_;
    std::vector<Ball> balls_;
    std::size_t ball_count_;  // of those given at first
    WantedSize size_;
    SeedOptions options_;
    const RunContext& context_;
    double unit_;
    std::vector<Place> places_;
    bool is_kept_ = true;
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

struct SeedSpace::Data {
    SeedOctree octree;
    WantedSize size;
    SeedOptions options;
};

SeedSpace::SeedSpace(std::span<const Vec3> points, std::span<const Facet> facets, std::span<const Ball> balls,
                     const WantedSize& size, const SeedOptions& options, const RunContext& context)
    : data_(new Data{SeedOctree(points, facets, balls, size, options, context), size, options}) {}
SeedSpace::~SeedSpace() = default;

Seeds SeedSpace::seeds(std::span<const Vec3> active) {
    Seeds seeds{.points = with_room(active, proven_places)};
    seeds.active_count = seeds.points.size();
    for (const Vec3& p : seeds.points) data_->octree.add_point(p, data_->options.spacing * data_->size.at(p));
    const std::vector<Vec3> lattice = data_->octree.lattice_points();
    seeds.points.insert(seeds.points.end(), lattice.begin(), lattice.end());
    return seeds;
}

std::vector<Vec3> SeedSpace::with_room(std::span<const Vec3> candidates, const SeedOptions& options) {
    return thinned(data_->octree.clear_points(candidates, options), data_->size, options.spacing);
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/patch_improvement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/folded_triangles.h"

namespace featuremesh {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Stars at least this good are left alone at the start; lattice nodes are.
constexpr double good_enough = 0.97;
constexpr int smoothing_sweeps = 8;

double quality_of(const TrianglePatch& patch, int t) {
    if (patch.is_at_pole(t)) return 1;
    const auto& c = patch.corners(t);
    return triangle_quality(patch.place(c[0]), patch.place(c[1]), patch.place(c[2]));
}

Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a); }

/// Cotangent of the angle at corner i of t; 0 in a triangle at a pole.
double cotangent(const TrianglePatch& patch, int t, int i) {
    const auto& c = patch.corners(t);
    const Vec3 &a = patch.place(c[at(i)]), &b = patch.place(c[at((i + 1) % 3)]), &d = patch.place(c[at((i + 2) % 3)]);
    if (patch.is_at_pole(t)) return 0;
    const Vec3 u = b - a, v = d - a;
    const double s = length(cross(u, v)), k = dot(u, v);
    return s > 1e-12 * (squared_length(u) + squared_length(v)) ? k / s : (k > 0 ? 1e12 : -1e12);
}

/// Whether turning the side opposite corner i of t would fold the surface more than it is.
bool would_fold(const TrianglePatch& patch, int t, int i) {
    const int n = patch.neighbour(t, i), j = patch.opposite_index(n, t);
    const Vec3 &a = patch.place(patch.corners(t)[at(i)]), &b = patch.place(patch.corners(t)[at((i + 1) % 3)]);
    const Vec3 &d = patch.place(patch.corners(t)[at((i + 2) % 3)]), &e = patch.place(patch.corners(n)[at(j)]);
    const Vec3 n1 = area_vector(a, b, e), n2 = area_vector(a, e, d);
    const double after = dot(n1, n2), scale = length(n1) * length(n2);
    // Between two nodes that stay, as around a cone's apex, a fold once made is never mended.
    const auto& c = patch.corners(t);
    const bool stays = patch.is_fixed[at(c[at((i + 1) % 3)])] && patch.is_fixed[at(c[at((i + 2) % 3)])];
    if (after > (stays ? 0.3 : 0.0) * scale || scale == 0) return false;
    const Vec3 m1 = area_vector(a, b, d), m2 = area_vector(e, d, b);
    const double before_scale = length(m1) * length(m2);
    return before_scale > 0 && after / scale < dot(m1, m2) / before_scale;
}

bool is_badly_turned(const TrianglePatch& patch, int t, int i) {
    const int n = patch.neighbour(t, i);
    if (n < 0 || cotangent(patch, t, i) + cotangent(patch, n, patch.opposite_index(n, t)) > -1e-6) return false;
    return patch.can_flip(t, i) && !would_fold(patch, t, i);
}

/// Turns the sides of the queued triangles, and of those that this changes, until all are Delaunay. On the surface of
/// `geometry`, if there is one, none may fold.
void flip_from(TrianglePatch& patch, std::vector<int>& queue, std::vector<int>* touched = nullptr,
               const PatchGeometry* geometry = nullptr) {
    std::size_t budget = 64 + 24 * patch.triangles.size();
    while (!queue.empty() && budget > 0) {
        const int t = queue.back();
        queue.pop_back();
        if (patch.is_removed(t)) continue;
        for (int i = 0; i < 3; ++i) {
            if (!is_badly_turned(patch, t, i) || (geometry && folds_by_turning(patch, *geometry, t, i))) continue;
            const int n = patch.neighbour(t, i);
            patch.flip(t, i);
            --budget;
            queue.push_back(n), queue.push_back(t);
            if (touched)
                for (const int p : patch.corners(t)) touched->push_back(p);
            break;
        }
    }
    queue.clear();
}

/// The point where the star's energy is least for fixed connectivity, relative to p; false for a star at a pole.
bool variational_step(const TrianglePatch& patch, int p, const std::vector<int>& star,
                      const std::vector<double>& density, Vec3& step) {
    const Vec3& x = patch.place(p);
    Vec3 sum{};
    double total = 0;
    for (const int t : star) {
        const auto& c = patch.corners(t);
        const int i = patch.corner_index(t, p);
        const Vec3 u = patch.place(c[at((i + 1) % 3)]) - x, v = patch.place(c[at((i + 2) % 3)]) - x;
        const Vec3 n = cross(u, v);
        const double nn = squared_length(n);
        if (!(nn > 0)) continue;
        const Vec3 circumcentre = (squared_length(u) * cross(v, n) + squared_length(v) * cross(n, u)) / (2 * nn);
        double weight = std::sqrt(nn);
        if (!density.empty()) weight *= (density[at(c[0])] + density[at(c[1])] + density[at(c[2])]) / 3;
        sum += weight * circumcentre;
        total += weight;
    }
    if (!(total > 0)) return false;
    step = sum / total;
    return true;
}

struct StarMeasure {
    double smallest_quality = 1;
    double shortest_side = 1e300;
};

StarMeasure measure_star(const TrianglePatch& patch, int p, const std::vector<int>& star) {
    StarMeasure m;
    for (const int t : star) {
        m.smallest_quality = std::min(m.smallest_quality, quality_of(patch, t));
        const int i = patch.corner_index(t, p);
        m.shortest_side =
            std::min(m.shortest_side, distance(patch.place(p), patch.place(patch.corners(t)[at((i + 1) % 3)])));
    }
    return m;
}

bool is_right_way_round(const TrianglePatch& patch, const std::vector<int>& star) {
    return std::all_of(star.begin(), star.end(), [&](int t) {
        const auto& c = patch.corners(t);
        return is_counterclockwise(patch.point(c[0]), patch.point(c[1]), patch.point(c[2]));
    });
}

/// Moves p when the star stays valid and is not made worse than it may be; else puts it back.
bool try_move(TrianglePatch& patch, const PatchGeometry& geometry, int p, const std::vector<int>& star, Vec2 to,
              double least_quality) {
    const Vec2 old_point = patch.point(p);
    const Vec3 old_place = patch.place(p);
    patch.points[at(p)] = to;
    if (is_right_way_round(patch, star)) {
        patch.places[at(p)] = geometry.place(to);
        if (measure_star(patch, p, star).smallest_quality >= least_quality) return true;
    }
    patch.points[at(p)] = old_point;
    patch.places[at(p)] = old_place;
    return false;
}

/// The weight per area that makes the triangles' sides follow the wanted length: its power -4. Empty where that is the
/// same everywhere.
std::vector<double> densities(const TrianglePatch& patch) {
    const auto [smallest, largest] = std::minmax_element(patch.wanted.begin(), patch.wanted.end());
    std::vector<double> density;
    if (*smallest > 0.98 * *largest) return density;
    for (const double wanted : patch.wanted) {
        const double h = wanted / *largest;
        density.push_back(1 / (h * h * h * h));
    }
    return density;
}

void mark_ring(const TrianglePatch& patch, const std::vector<int>& star, std::vector<char>& marks) {
    for (const int t : star)
        for (const int q : patch.corners(t)) marks[at(q)] = 1;
}

/// The least height of a triangle above those of its sides that are at the boundary.
double height_above_boundary(const TrianglePatch& patch, int t) {
    double least = std::numeric_limits<double>::infinity();
    const auto& c = patch.corners(t);
    for (int i = 0; i < 3; ++i) {
        if (patch.neighbour(t, i) >= 0) continue;
        const Vec3 &a = patch.place(c[at((i + 1) % 3)]), &b = patch.place(c[at((i + 2) % 3)]);
        least = std::min(least, length(area_vector(a, b, patch.place(c[at(i)]))) / distance(a, b));
    }
    return least;
}

}  // namespace

Vec2 PatchGeometry::step(Vec2 p, const Vec3& d) const {
    if (is_flat_) return {d.x, d.y};
    const Chart::Frame f = chart_.frame(p);
    const double e = dot(f.dx, f.dx), g = dot(f.dy, f.dy), m = dot(f.dx, f.dy), det = e * g - m * m;
    if (!(det > 1e-12 * e * g)) return {};
    const double a = dot(f.dx, d), b = dot(f.dy, d);
    return {(a * g - b * m) / det, (b * e - a * m) / det};
}

double triangle_quality(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double sides = squared_length(b - a) + squared_length(c - b) + squared_length(a - c);
    return sides > 0 ? 2 * std::sqrt(3.0) * length(area_vector(a, b, c)) / sides : 0;
}

double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    // The smallest angle is the one opposite the shortest side.
    const Vec3 ab = b - a, bc = c - b, ca = a - c;
    const double l_ab = squared_length(ab), l_bc = squared_length(bc), l_ca = squared_length(ca);
    const double twice_area = length(cross(ab, ca));
    if (l_ab <= l_bc && l_ab <= l_ca) return std::atan2(twice_area, -dot(bc, ca));
    if (l_bc <= l_ca) return std::atan2(twice_area, -dot(ab, ca));
    return std::atan2(twice_area, -dot(ab, bc));
}

void make_delaunay(TrianglePatch& patch) {
    std::vector<int> queue;
    for (int t = static_cast<int>(patch.triangles.size()) - 1; t >= 0; --t)
        if (!patch.is_removed(t)) queue.push_back(t);
    flip_from(patch, queue);
}

namespace {

/// Of the point and the nearest corner of the two triangles at the side opposite corner i of t.
double distance_to_corners(const TrianglePatch& patch, int t, int i, const Vec3& point) {
    double least = std::numeric_limits<double>::infinity();
    for (const int triangle : {t, patch.neighbour(t, i)})
        for (const int corner : patch.corners(triangle)) least = std::min(least, distance(patch.place(corner), point));
    return least;
}

}  // namespace

bool split_long_sides(TrianglePatch& patch, const PatchGeometry& geometry, const Heartbeat& heart) {
    constexpr double too_long = 1.6, least_height = 0.7, least_apart = 0.3;
    const std::size_t most = 10000 + 4 * patch.triangles.size();
    std::size_t splits = 0;
    std::vector<int> queue;
    for (int round = 0; round < 12; ++round) {
        const std::size_t before = splits;
        const std::size_t count = patch.triangles.size();
        for (std::size_t t = 0; t < count; ++t) {
            if (t % 1024 == 0) heart.beat();
            int longest = -1;
            double excess = too_long;
            Vec2 its_middle;
            Vec3 its_place;
            for (int i = 0; i < 3; ++i) {
                const int n = patch.neighbours[t][at(i)];
                if (n < 0) continue;
                const int a = patch.triangles[t][at((i + 1) % 3)], b = patch.triangles[t][at((i + 2) % 3)];
                const double l = distance(patch.place(a), patch.place(b));
                const double h = 0.5 * (patch.wanted[at(a)] + patch.wanted[at(b)]);
                if (l <= excess * h) continue;
                // beside a long side that stays, nodes would come nearer to that one with each split
                const double height =
                    std::min(height_above_boundary(patch, static_cast<int>(t)), height_above_boundary(patch, n));
                if (height < least_height * h) continue;
                // round a pole, the middle of a side in the chart may be far from its middle in space
                const Vec2 middle = 0.5 * (patch.point(a) + patch.point(b));
                const Vec3 place = geometry.place(middle);
                if (distance_to_corners(patch, static_cast<int>(t), i, place) < least_apart * h) continue;
                excess = l / h, longest = i, its_middle = middle, its_place = place;
            }
            if (longest < 0) continue;
            const int p = patch.split_side(static_cast<int>(t), longest, its_middle, its_place);
            if (++splits > most) return false;
            std::vector<int> star;
            patch.star(p, star);
            queue = star;
            flip_from(patch, queue);
        }
        if (splits == before) break;
    }
    return true;
}

namespace {

/// The longest side that is not at the boundary; -1 for none.
int longest_inner_side(const TrianglePatch& patch, int t) {
    int longest = -1;
    double most = 0;
    for (int i = 0; i < 3; ++i) {
        const auto& c = patch.corners(t);
        const double l = distance(patch.place(c[at((i + 1) % 3)]), patch.place(c[at((i + 2) % 3)]));
        if (patch.neighbour(t, i) >= 0 && l > most) most = l, longest = i;
    }
    return longest;
}

/// Splits a side in the middle, or the triangle itself when it has none that may be split.
int split_triangle_or_side(TrianglePatch& patch, const PatchGeometry& geometry, int t, int i) {
    const auto c = patch.corners(t);
    if (i >= 0) {
        const Vec2 middle = 0.5 * (patch.point(c[at((i + 1) % 3)]) + patch.point(c[at((i + 2) % 3)]));
        return patch.split_side(t, i, middle, geometry.place(middle));
    }
    const Vec2 centre = (1.0 / 3) * (patch.point(c[0]) + patch.point(c[1]) + patch.point(c[2]));
    return patch.split_triangle(t, centre, geometry.place(centre));
}

}  // namespace

std::size_t split_folded(TrianglePatch& patch, const PatchGeometry& geometry, const Heartbeat& heart) {
    if (geometry.chart().is_plane()) return 0;
    constexpr int rounds = 6;
    std::size_t splits = 0;
    std::vector<int> star;
    for (int round = 0; round < rounds; ++round) {
        const std::size_t before = splits, count = patch.triangles.size();
        for (std::size_t t = 0; t < count; ++t) {
            if (t % 1024 == 0) heart.beat();
            if (patch.is_removed(static_cast<int>(t)) || !is_folded(patch, geometry, static_cast<int>(t))) continue;
            if (unfold(patch, geometry, static_cast<int>(t))) continue;
            const int p = split_triangle_or_side(patch, geometry, static_cast<int>(t),
                                                 longest_inner_side(patch, static_cast<int>(t)));
            ++splits;
            patch.star(p, star);
            flip_from(patch, star, nullptr, &geometry);
        }
        if (splits == before) break;
    }
    return splits;
}

void smooth(TrianglePatch& patch, const PatchGeometry& geometry, const Heartbeat& heart) {
    const std::vector<double> density = densities(patch);
    std::vector<char> is_active(patch.points.size(), 0), next(patch.points.size(), 0);
    for (std::size_t t = 0; t < patch.triangles.size(); ++t)
        if (!patch.is_removed(static_cast<int>(t)) && quality_of(patch, static_cast<int>(t)) < good_enough)
            for (const int p : patch.triangles[t]) is_active[at(p)] = 1;
    std::vector<int> star, queue, touched;
    for (int sweep = 0; sweep < smoothing_sweeps; ++sweep) {
        bool has_moved = false;
        for (int p = 0; p < static_cast<int>(patch.points.size()); ++p) {
            if (p % 1024 == 0) heart.beat();
            if (!is_active[at(p)] || patch.is_fixed[at(p)] || patch.triangle_of[at(p)] < 0) continue;
            patch.star(p, star);
            Vec3 step;
            if (!variational_step(patch, p, star, density, step)) continue;
            const StarMeasure before = measure_star(patch, p, star);
            const double least = std::min(before.smallest_quality, 0.75);
            const double wanted = length(step);
            if (wanted < 2e-3 * before.shortest_side) continue;
            Vec2 move = geometry.step(patch.point(p), step);
            bool moved = false;
            for (int halving = 0; halving < 3 && !moved; ++halving, move = 0.5 * move)
                moved = try_move(patch, geometry, p, star, patch.point(p) + move, least);
            if (!moved) continue;
            has_moved = true;
            if (wanted > 0.02 * before.shortest_side) mark_ring(patch, star, next);
            queue.insert(queue.end(), star.begin(), star.end());
        }
        flip_from(patch, queue, &touched);
        for (const int p : touched) next[at(p)] = 1;
        touched.clear();
        if (!has_moved) break;
        is_active.swap(next);
        std::fill(next.begin(), next.end(), 0);
    }
}

namespace {

/// The operations of raise_smallest_angles on one triangle.
class AngleRaiser {
  public:
    AngleRaiser(TrianglePatch& patch, const PatchGeometry& geometry, double least_length)
        : patch_(patch), geometry_(geometry), least_length_(least_length) {
        for (int t = 0; t < static_cast<int>(patch.triangles.size()) && !has_needles_; ++t)
            has_needles_ = !patch.is_removed(t) && has_tiny_side(t);
    }

    double angle_of(int t) const {
        const auto& c = patch_.corners(t);
        return patch_.is_at_pole(t) || (has_needles_ && has_tiny_side(t))
                   ? M_PI / 3
                   : smallest_angle(patch_.place(c[0]), patch_.place(c[1]), patch_.place(c[2]));
    }

    bool improve(int t) { return turn(t) || move_corners(t) || remove_corner(t) || split(t); }

  private:
    double angle_of(const std::vector<int>& list) const {
        double smallest = M_PI;
        for (const int t : list) smallest = std::min(smallest, angle_of(t));
        return smallest;
    }

    /// On a piece of an edge far shorter than wanted the angle stays small: nodes drawn near for its sake would make
    /// triangles with hardly an area, and tets with hardly a volume on them.
    bool has_tiny_side(int t) const {
        constexpr double too_short = 1e-3, far_shorter = 0.1;
        const auto& c = patch_.corners(t);
        for (int i = 0; i < 3; ++i) {
            const int a = c[at(i)], b = c[at((i + 1) % 3)];
            if (!patch_.is_fixed[at(a)] || !patch_.is_fixed[at(b)]) continue;
            const double wanted = patch_.wanted[at(a)];
            const double least = std::max(too_short * wanted, std::min(least_length_, far_shorter * wanted));
            if (distance(patch_.place(a), patch_.place(b)) < least) return true;
        }
        return false;
    }

    bool turn(int t) {
        for (int i = 0; i < 3; ++i) {
            const int n = patch_.neighbour(t, i);
            if (n < 0 || !patch_.can_flip(t, i) || would_fold(patch_, t, i)) continue;
            if (angle_after_turn(t, i) <= std::min(angle_of(t), angle_of(n)) + 1e-9) continue;
            if (folds_by_turning(patch_, geometry_, t, i)) continue;
            patch_.flip(t, i);
            return true;
        }
        return false;
    }

    double angle_after_turn(int t, int i) const {
        const int n = patch_.neighbour(t, i);
        const auto& c = patch_.corners(t);
        const int a = c[at(i)], b = c[at((i + 1) % 3)], d = c[at((i + 2) % 3)];
        const int e = patch_.corners(n)[at(patch_.opposite_index(n, t))];
        const auto angle = [&](int p, int q, int r) {
            const bool at_pole = patch_.are_one_node(p, q) || patch_.are_one_node(q, r);
            return at_pole ? M_PI / 3 : smallest_angle(patch_.place(p), patch_.place(q), patch_.place(r));
        };
        return std::min(angle(a, b, e), angle(e, d, a));
    }

    bool move_corners(int t) {
        const auto corners = patch_.corners(t);
        return std::any_of(corners.begin(), corners.end(), [&](int p) { return !patch_.is_fixed[at(p)] && climb(p); });
    }

    /// Hill climbing of one inner node by shrinking steps in eight directions.
    bool climb(int p) {
        patch_.star(p, star_);
        const double start = angle_of(star_);
        double best = start, radius = 0.25 * measure_star(patch_, p, star_).shortest_side;
        for (int round = 0; round < 6; ++round) {
            bool better = false;
            for (int k = 0; k < 8 && !better; ++k) {
                const double angle = k * M_PI / 4;
                better = try_place(p, radius * std::cos(angle), radius * std::sin(angle), best);
            }
            if (!better) radius *= 0.5;
        }
        return best > start + 1e-6;
    }

    bool try_place(int p, double dx, double dy, double& best) {
        const Vec2 old_point = patch_.point(p);
        const Vec3 old_place = patch_.place(p);
        Vec2 step{dx, dy};
        if (!geometry_.is_flat()) {
            const Chart::Frame f = geometry_.chart().frame(old_point);
            const Vec3 e1 = normalized(f.dx), normal = normalized(cross(f.dx, f.dy));
            step = geometry_.step(old_point, dx * e1 + dy * cross(normal, e1));
        }
        patch_.points[at(p)] = old_point + step;
        if (is_right_way_round(patch_, star_)) {
            patch_.places[at(p)] = geometry_.place(patch_.point(p));
            if (const double now = angle_of(star_); now > best + 1e-9) {
                best = now;
                return true;
            }
        }
        patch_.points[at(p)] = old_point;
        patch_.places[at(p)] = old_place;
        return false;
    }

    bool remove_corner(int t) {
        const auto corners = patch_.corners(t);
        return std::any_of(corners.begin(), corners.end(), [&](int p) { return !patch_.is_fixed[at(p)] && remove(p); });
    }

    /// Takes out an inner node of at most five triangles when the best fan over its ring has a larger smallest angle.
    bool remove(int p) {
        patch_.star(p, star_);
        const int count = static_cast<int>(star_.size());
        if (count < 3 || count > 5) return false;
        std::vector<int> ring;
        for (const int t : star_) ring.push_back(patch_.corners(t)[at((patch_.corner_index(t, p) + 1) % 3)]);
        double best = angle_of(star_) + 1e-3;
        int best_apex = -1;
        for (int apex = 0; apex < count; ++apex)
            if (const double angle = smallest_in_fan(ring, apex); angle > best && !folds(ring, apex))
                best = angle, best_apex = apex;
        if (best_apex < 0) return false;
        for (int k = 1; k + 2 < count; ++k) {
            const int gone = ring[at((best_apex + k) % count)];
            patch_.star(p, star_);
            for (const int t : star_)
                if (const int i = patch_.corner_index(t, p); patch_.corners(t)[at((i + 1) % 3)] == gone) {
                    patch_.flip(t, (i + 2) % 3);
                    break;
                }
        }
        patch_.remove_of_three(p);
        return true;
    }

    /// -1 when the fan from the given ring point is not one to one in the chart, or would join a node to itself or
    /// stretch a side too far.
    double smallest_in_fan(const std::vector<int>& ring, int apex) const {
        constexpr double longest = 1.8;
        const int count = static_cast<int>(ring.size()), a = ring[at(apex)];
        double smallest = M_PI;
        for (int k = 1; k + 1 < count; ++k) {
            const int b = ring[at((apex + k) % count)], c = ring[at((apex + k + 1) % count)];
            if (patch_.are_one_node(a, b) || patch_.are_one_node(b, c) || patch_.are_one_node(c, a)) return -1;
            if (!is_counterclockwise(patch_.point(a), patch_.point(b), patch_.point(c))) return -1;
            const double wanted = patch_.wanted[at(a)];
            if (k > 1 && distance(patch_.place(a), patch_.place(b)) > longest * wanted) return -1;
            smallest = std::min(smallest, smallest_angle(patch_.place(a), patch_.place(b), patch_.place(c)));
        }
        return smallest;
    }

    bool folds(const std::vector<int>& ring, int apex) const {
        const int count = static_cast<int>(ring.size());
        for (int k = 1; k + 1 < count; ++k)
            if (is_folded(patch_, geometry_,
                          {ring[at(apex)], ring[at((apex + k) % count)], ring[at((apex + k + 1) % count)]}))
                return true;
        return false;
    }

    /// Splits the longest inner side of a needle or cap when the two new nodes' surroundings gain by it.
    bool split(int t) {
        constexpr double too_small = 25 * M_PI / 180;
        if (angle_of(t) > too_small) return false;
        const auto corners = patch_.corners(t);
        int longest = -1;
        double length_of_it = 0;
        for (int i = 0; i < 3; ++i) {
            const double l = distance(patch_.place(corners[at((i + 1) % 3)]), patch_.place(corners[at((i + 2) % 3)]));
            if (l > length_of_it) length_of_it = l, longest = i;
        }
        const int n = patch_.neighbour(t, longest);
        if (n < 0 || !patch_.is_fixed[at(corners[at((longest + 1) % 3)])] ||
            !patch_.is_fixed[at(corners[at((longest + 2) % 3)])])
            return false;
        const double before = std::min(angle_of(t), angle_of(n));
        const Vec2 middle =
            0.5 * (patch_.point(corners[at((longest + 1) % 3)]) + patch_.point(corners[at((longest + 2) % 3)]));
        const int p = patch_.split_side(t, longest, middle, geometry_.place(middle));
        climb(p);
        patch_.star(p, star_);
        if (angle_of(star_) > before + 0.02) return true;
        undo_split(t, p);
        return false;
    }

    /// Undoes split_side(t, ...), whether or not the chart would allow the same turn on the way.
    void undo_split(int t, int p) {
        const int side_to_apex = 1;  // t is (apex, end of the side, p)
        patch_.flip(t, side_to_apex);
        patch_.remove_of_three(p);
    }

    TrianglePatch& patch_;
    const PatchGeometry& geometry_;
    double least_length_;
    bool has_needles_ = false;
    std::vector<int> star_;
};

}  // namespace

void raise_smallest_angles(TrianglePatch& patch, const PatchGeometry& geometry, double wanted_angle,
                           double least_length, const Heartbeat& heart) {
    AngleRaiser raiser(patch, geometry, least_length);
    for (int pass = 0; pass < 4; ++pass) {
        std::vector<std::pair<double, int>> bad;
        for (int t = 0; t < static_cast<int>(patch.triangles.size()); ++t)
            if (!patch.is_removed(t))
                if (const double angle = raiser.angle_of(t); angle < wanted_angle) bad.emplace_back(angle, t);
        std::sort(bad.begin(), bad.end());
        bool gained = false;
        for (const auto& [angle, t] : bad) {
            heart.beat();
            if (!patch.is_removed(t) && raiser.angle_of(t) < wanted_angle) gained = raiser.improve(t) || gained;
        }
        if (!gained) break;
    }
}

}  // namespace featuremesh

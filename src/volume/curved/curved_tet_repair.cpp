// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/curved/curved_tet_repair.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "core/geometry.h"
#include "core/sort_once.h"
#include "mesh/quality.h"
#include "mesh/second_order.h"
#include "volume/curved/curved_tet_descent.h"
#include "volume/curved/low_tets.h"
#include "volume/tets/needles.h"
#include "volume/tets/tet_measures.h"

namespace featuremesh {
namespace {

/// The 26 directions to the neighbours in a cubic lattice.
std::vector<Vec3> search_directions() {
    std::vector<Vec3> directions;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x || y || z) directions.push_back(normalized(Vec3(x, y, z)));
    return directions;
}

using Star = std::span<const TetId>;

class Unfolding {
  public:
    Unfolding(Mesh& mesh, const TetsAtNode& tets_at, const Projector& projector, const std::vector<bool>& is_movable,
              const CurvedTetAims& aims)
        : mesh_(mesh),
          tets_at_(tets_at),
          projector_(projector),
          is_movable_(is_movable),
          target_(aims.scaled_jacobian),
          least_volume_(aims.least_volume),
          placed_(mesh.points),
          in_vain_(mesh.points.size()),
          directions_(search_directions()) {}

    /// Bends the inner sides, and those on planes, that end on the boundary as the curved sides near them are bent.
    /// Several of them have to move at once in a thin curved wall, which moving one node at a time does not find.
    void bend_along(const std::vector<TetId>& bad) {
        std::vector<NodeId> nodes = movable_nodes(bad);
        nodes.erase(
            std::remove_if(nodes.begin(), nodes.end(), [&](NodeId n) { return n.index() < mesh_.corner_count; }),
            nodes.end());
        std::vector<Vec3> bends;
        for (NodeId n : nodes)
            bends.push_back(mesh_.entities[n.index()].dim == 1 ? Vec3{} : bend_of(n, tets_at_.of(n)));
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const Place start = place(nodes[i], {});
            if (squared_length(bends[i]) > 0) move(nodes[i], start, bends[i]);
        }
    }

    /// What a move has to raise.
    enum class Aim { smallest_bound, sum_of_shortfalls };

    /// One pass over the nodes of the bad tets; whether anything moved. The smallest bound around a node tells best
    /// which way, but stops where one tet gains what another loses; the sum of what all lack goes on from there.
    bool pass(std::span<const TetId> bad, Aim aim) {
        aim_ = aim;
        const std::vector<NodeId> nodes = movable_nodes(bad);
        bool moved = false;
        for (NodeId n : nodes) moved |= improve(n, tets_at_.of(n));
        return moved;
    }

  private:
    /// Inner mid-side nodes first, then those on faces, then inner corners, then mid-side nodes on CAD edges.
    std::vector<NodeId> movable_nodes(std::span<const TetId> bad) const {
        std::vector<NodeId> inner, on_faces, corners, on_edges;
        const std::array<std::vector<NodeId>*, 4> mids{nullptr, &on_edges, &on_faces, &inner};
        for (TetId t : bad) {
            for (NodeId n : mesh_.tet_mids[t.index()])
                if (is_movable_[n.index()]) mids[static_cast<std::size_t>(mesh_.entities[n.index()].dim)]->push_back(n);
            for (NodeId n : mesh_.tets[t.index()])
                if (is_movable_[n.index()] && mesh_.entities[n.index()].dim == 3) corners.push_back(n);
        }
        std::vector<NodeId> all;
        for (auto* list : {&inner, &on_faces, &corners, &on_edges}) {
            sort_once(*list);
            all.insert(all.end(), list->begin(), list->end());
        }
        return all;
    }

    struct BentSide {
        Vec3 along, bend;
    };
    /// From the middle of its corners to the mid-side node.
    BentSide side_of(TetId t, int s) const {
        const auto& corners = mesh_.tets[t.index()];
        const Vec3 &a = mesh_.point(corners[tet_sides[s][0]]), &b = mesh_.point(corners[tet_sides[s][1]]);
        return {b - a, mesh_.point(mesh_.tet_mids[t.index()][s]) - (a + b) * 0.5};
    }

    /// How a still straight side between two boundary nodes would be bent if it curved like the bent sides of its tets,
    /// the nearest ones above all: the bend goes with the square of the length along them. In a tet as thin as an edge
    /// of a millionth of the part, only the sides beside it count.
    Vec3 bend_of(NodeId mid, Star star) const {
        Vec3 sum, own, middle;
        double weights = 0;
        for (TetId t : star)
            for (int s = 0; s < 6; ++s)
                if (mesh_.tet_mids[t.index()][s] == mid) {
                    own = side_of(t, s).along;
                    middle = mesh_.point(mid) - side_of(t, s).bend;
                    if (squared_length(side_of(t, s).bend) > 1e-12 * squared_length(own)) return {};
                    for (int end : tet_sides[s])
                        if (mesh_.entities[mesh_.tets[t.index()][end].index()].dim == 3) return {};
                }
        for (TetId t : star)
            for (int s = 0; s < 6; ++s) {
                const BentSide side = side_of(t, s);
                const double squared = squared_length(side.along), along = dot(own, side.along);
                if (squared_length(side.bend) <= 1e-12 * squared) continue;
                const Vec3 apart = mesh_.point(mesh_.tet_mids[t.index()][s]) - side.bend - middle;
                const double share = along * along / (squared * squared),
                             weight = along * along / (squared * squared_length(own) * squared_length(apart));
                sum += weight * share * side.bend;
                weights += weight;
            }
        return weights > 0 ? sum / weights : Vec3{};
    }

    /// What a move has to raise, at most what is enough: what is good enough need not get better. Stops early, with
    /// some value no larger than `limit`, once it is down to that.
    double worst(Star star, double limit = -std::numeric_limits<double>::infinity()) const {
        const double enough = target_ + 0.1;
        if (aim_ == Aim::smallest_bound) return smallest_bound(star, enough, limit);
        double shortfalls = 0;
        for (TetId t : star) {
            const double bound = quick_bound(tet_nodes(mesh_, t));
            if (bound < enough) shortfalls += shortfall(enough, bound);
            if (enough - shortfalls <= limit) break;
        }
        return enough - shortfalls;
    }
    /// The tet that stopped the last look is the likeliest to stop the next.
    double smallest_bound(Star star, double enough, double limit) const {
        if (refusing_ >= star.size()) refusing_ = 0;
        double low = std::min(enough, quick_bound(tet_nodes(mesh_, star[refusing_]), limit));
        for (std::size_t i = 0; i < star.size() && low > limit; ++i) {
            const double bound = quick_bound(tet_nodes(mesh_, star[i]), limit);
            low = std::min(low, bound);
            if (low <= limit) refusing_ = i;
        }
        return low;
    }
    /// Grows slowly where a tet is folded many times over, as a needle is, so that it does not hide the others.
    static double shortfall(double enough, double bound) {
        return bound >= 0 ? (enough - bound) * (enough - bound) / enough : enough + 2 * std::log1p(-bound);
    }
    double worst_angle(Star star) const {
        double low = 180;
        for (const TetId t : star) low = std::min(low, worst_angle_of(t));
        return low;
    }
    /// The tet's worst angle. In a needle the angle that the CAD forces is left out: it would hide all others.
    double worst_angle_of(TetId t) const {
        const auto& n = mesh_.tets[t.index()];
        const std::array<Vec3, 4> p{mesh_.point(n[0]), mesh_.point(n[1]), mesh_.point(n[2]), mesh_.point(n[3])};
        const DihedralRange range = dihedral_range(p[0], p[1], p[2], p[3]);
        const double angle = std::min(range.smallest_deg, 180 - range.largest_deg);
        std::array<bool, 4> is_on_boundary;
        for (int k = 0; k < 4; ++k) is_on_boundary[k] = mesh_.entities[n[k].index()].dim < 3;
        const double all = flatness(p[0], p[1], p[2], p[3]);
        const double unforced = unforced_flatness(all, p, is_on_boundary);
        return unforced < all ? angle_of_flatness(unforced) : angle;
    }

    double smallest_volume(Star star) const {
        double low = std::numeric_limits<double>::infinity();
        for (TetId t : star) {
            const auto& n = mesh_.tets[t.index()];
            low = std::min(low,
                           signed_volume(mesh_.point(n[0]), mesh_.point(n[1]), mesh_.point(n[2]), mesh_.point(n[3])));
        }
        return low;
    }

    /// The side that a mid-side node belongs to.
    BentSide side_at(NodeId mid, Star star) const {
        const auto& mids = mesh_.tet_mids[star.front().index()];
        return side_of(star.front(), static_cast<int>(std::find(mids.begin(), mids.end(), mid) - mids.begin()));
    }
    /// An inner side that is bent more than this would spoil what it is to repair; a node on the boundary that slides
    /// to a quarter of its side would make the element singular.
    bool is_bent_too_much(NodeId n, Star star) const {
        constexpr double most_bend = 0.3, most_slide = 0.15;
        if (n.index() < mesh_.corner_count) return false;
        const BentSide side = side_at(n, star);
        const double squared = squared_length(side.along);
        const int dim = mesh_.entities[n.index()].dim;
        if (dim < 3 && std::abs(dot(side.bend, side.along)) > most_slide * squared) return true;
        const Vec3 off = dim == 3 ? side.bend : mesh_.point(n) - placed_[n.index()];
        return dim > 1 && squared_length(off) > most_bend * most_bend * squared;
    }

    double longest_side_at(NodeId n, Star star) const {
        double longest = 0;
        for (TetId t : star)
            for (NodeId other : mesh_.tets[t.index()])
                longest = std::max(longest, distance(mesh_.point(n), mesh_.point(other)));
        return longest;
    }

    bool improve(NodeId n, Star star) {
        const std::uint64_t now = print_of(star);
        std::uint64_t& in_vain = in_vain_[n.index()][static_cast<std::size_t>(aim_)];
        if (in_vain == now) return false;
        const double before = worst(star);
        double best = before;
        for (double step = 0.2 * longest_side_at(n, star), last = 0.02 * step; step > last && best <= target_;
             step *= 0.5)
            for (int tries = 0; tries < 4 && best <= target_ + 0.05; ++tries)
                if (!best_step(n, star, step, best)) break;
        if (best == before) in_vain = now;
        return best > before + 1e-4;
    }

    /// Of all that decides what moving its node can gain.
    std::uint64_t print_of(Star star) const {
        std::uint64_t print = 1;
        const auto add = [&](double value) {
            print = (print ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15ull;
            print ^= print >> 32;
        };
        for (const TetId t : star)
            for (const Vec3& p : tet_nodes(mesh_, t)) add(p.x), add(p.y), add(p.z);
        return print;
    }

    /// Tries all directions at one step length and takes the best one.
    bool best_step(NodeId n, Star star, double step, double& best) {
        const Place start = place(n, star);
        const bool is_corner = n.index() < mesh_.corner_count;
        const double angle = is_corner ? std::min(worst_angle(star), 20.0) : 0;
        const double volume = is_corner ? std::min(smallest_volume(star), least_volume_) : 0;
        const auto keeps_corners_good = [&] {
            return worst_angle(star) >= angle - 1e-9 && smallest_volume(star) >= volume;
        };
        Place found = start;
        double found_value = best;
        for (const Vec3& direction : directions_) {
            if (move(n, start, step * direction) && !is_bent_too_much(n, star)) {
                const double value = worst(star, found_value + 1e-6);
                if (value > found_value + 1e-6 && (!is_corner || keeps_corners_good())) {
                    found_value = value;
                    found = place(n, star);
                }
            }
            restore(n, start);
        }
        if (found_value <= best) return false;
        restore(n, found);
        best = found_value;
        return true;
    }

    /// A node's position; for a corner also those of the inner mid-side nodes of its sides, which go along.
    struct Place {
        Vec3 point;
        std::array<double, 2> parameters;
        std::vector<std::pair<NodeId, Vec3>> followers;
    };
    Place place(NodeId n, Star star) const {
        Place now{mesh_.point(n), mesh_.parameters[n.index()], {}};
        if (n.index() >= mesh_.corner_count) return now;
        for (TetId t : star)
            for (int s = 0; s < 6; ++s) {
                const auto& corners = mesh_.tets[t.index()];
                if (corners[tet_sides[s][0]] != n && corners[tet_sides[s][1]] != n) continue;
                const NodeId mid = mesh_.tet_mids[t.index()][s];
                if (mesh_.entities[mid.index()].dim == 3 && std::none_of(now.followers.begin(), now.followers.end(),
                                                                         [&](const auto& f) { return f.first == mid; }))
                    now.followers.emplace_back(mid, mesh_.point(mid));
            }
        return now;
    }
    void restore(NodeId n, const Place& to) {
        mesh_.points[n.index()] = to.point;
        mesh_.parameters[n.index()] = to.parameters;
        for (const auto& [mid, point] : to.followers) mesh_.points[mid.index()] = point;
    }
    bool move(NodeId n, const Place& from, const Vec3& by) {
        const Entity entity = mesh_.entities[n.index()];
        if (entity.dim == 3) {
            mesh_.points[n.index()] = from.point + by;
            for (const auto& [mid, point] : from.followers) mesh_.points[mid.index()] = point + by * 0.5;
            return true;
        }
        const auto on = projector_.nearest_by_steps(entity, from.point + by, from.parameters);
        // a step across the curve or surface comes back to where it began
        if (!on || distance(on->point, from.point) < 0.3 * length(by)) return false;
        restore(n, {on->point, on->parameters, {}});
        return true;
    }

    Mesh& mesh_;
    const TetsAtNode& tets_at_;
    const Projector& projector_;
    const std::vector<bool>& is_movable_;
    const double target_, least_volume_;
    Aim aim_ = Aim::smallest_bound;
    mutable std::size_t refusing_ = 0;                   ///< place in the star
    const std::vector<Vec3> placed_;                     ///< where the nodes were at first
    std::vector<std::array<std::uint64_t, 2>> in_vain_;  ///< by node and aim: around it when it was last tried so
    const std::vector<Vec3> directions_;
};

}  // namespace

std::vector<TetId> unfold_tets(Mesh& mesh, const Projector& projector, const std::vector<bool>& is_movable,
                               const CurvedTetAims& aims, RunContext& context) {
    constexpr int most_passes = 6;
    const double target = aims.scaled_jacobian;
    // with more trouble a few tets show first whether moves help
    constexpr std::size_t most_together = 500, few = 100;
    LowTets bad(mesh, target, context);
    if (bad.found().empty()) return {};
    const TetsAtNode tets_at(mesh, context);
    Unfolding unfolding(mesh, tets_at, projector, is_movable, aims);
    const std::vector<Vec3> points = mesh.points;
    const std::vector<std::array<double, 2>> parameters = mesh.parameters;
    const std::size_t bad_before = bad.found().size();
    unfolding.bend_along(bad.found());
    bad.look_again(tets_at);
    if (bad.found().size() >= bad_before) {
        mesh.points = points;
        mesh.parameters = parameters;
        bad.look_again(tets_at);
    }
    using Aim = Unfolding::Aim;
    for (const Aim aim : {Aim::smallest_bound, Aim::sum_of_shortfalls, Aim::smallest_bound}) {
        for (int pass = 0; pass < most_passes && !bad.found().empty(); ++pass) {
            context.check_cancelled();
            const std::size_t before = bad.found().size();
            if (before > most_together) {
                unfolding.pass(std::span(bad.found()).first(few), aim);
                bad.look_again(tets_at);
                if (bad.found().size() >= before) break;
            }
            if (!unfolding.pass(bad.found(), aim)) break;
            bad.look_again(tets_at);
            if (bad.found().size() > std::max(most_together, before)) break;
        }
        if (bad.found().empty() || bad.found().size() > most_together) break;
        descend(mesh, tets_at, projector, is_movable, bad.found(), {target + 0.05, aims.least_volume}, context);
        bad.look_again(tets_at);
    }
    return bad.found();
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/curved/curved_tet_descent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>

#include "core/geometry.h"
#include "core/sort_once.h"
#include "mesh/second_order.h"

namespace featuremesh {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// By corner: the others, so that the cross product of their sides is how the tet's determinant changes with it.
constexpr std::array<std::array<std::size_t, 3>, 4> opposite{{{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};

using Field = std::vector<Vec3>;  ///< by free node

double product(const Field& a, const Field& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
    return sum;
}

/// The tets around the bad ones and the nodes among theirs that may move.
class Patch {
  public:
    Patch(Mesh& mesh, const TetsAtNode& tets_at, const Projector& projector, const std::vector<bool>& is_movable,
          const std::vector<TetId>& bad, const CurvedTetAims& aims)
        : mesh_(mesh),
          projector_(projector),
          wanted_(aims.scaled_jacobian),
          least_volume_(6 * aims.least_volume),
          place_(mesh.points.size(), -1) {
        collect(tets_at, is_movable, bad);
        placed_.reserve(free_.size());
        for (const NodeId n : free_) placed_.push_back(mesh.point(n));
        measure_lengths();
    }

    std::size_t size() const { return free_.size(); }

    /// Puts the barriers below what the tets have now; whether one still lacks something.
    bool renew_barriers() {
        bool lacks = false;
        barriers_.resize(tets_.size());
        for (std::size_t i = 0; i < tets_.size(); ++i) {
            const auto nodes = tet_nodes(mesh_, tets_[i]);
            // that of the first round: moving corners may not flatten what they unfold
            if (barriers_[i].volume == 0)
                barriers_[i].volume = 6 * signed_volume(nodes[0], nodes[1], nodes[2], nodes[3]);
            const auto c = jacobian_coefficients(nodes);
            const double low = *std::min_element(c.begin(), c.end()) / barriers_[i].volume;
            barriers_[i].at = low < wanted_ ? low - 0.2 * (wanted_ - low) : 0;
            lacks |= low < wanted_;
        }
        return lacks;
    }

    /// The energy, infinite behind a barrier; with its gradient in units of the nodes' lengths, along their entities.
    double energy(Field* gradient) const {
        double sum = 0;
        if (gradient) gradient->assign(free_.size(), Vec3{});
        for (std::size_t i = 0; i < tets_.size(); ++i) {
            sum += tet_energy(i, gradient);
            if (sum == infinite) return sum;
        }
        constexpr double pull = 0.02;  // what is good should stay where it was placed
        for (std::size_t k = 0; k < free_.size(); ++k) {
            const Vec3 off = (mesh_.point(free_[k]) - placed_[k]) / lengths_[k];
            sum += pull * squared_length(off);
            if (gradient) (*gradient)[k] = along_entity(k, (*gradient)[k] * lengths_[k] + 2 * pull * off);
        }
        return sum;
    }

    struct State {
        Field points;
        std::vector<std::array<double, 2>> parameters;
    };
    State state() const {
        State now;
        for (const NodeId n : free_) {
            now.points.push_back(mesh_.point(n));
            now.parameters.push_back(mesh_.parameters[n.index()]);
        }
        return now;
    }
    void restore(const State& to) {
        for (std::size_t k = 0; k < free_.size(); ++k) {
            mesh_.points[free_[k].index()] = to.points[k];
            mesh_.parameters[free_[k].index()] = to.parameters[k];
        }
    }
    /// Steps in units of the nodes' lengths, and back onto the entities.
    void step(const State& from, const Field& by, double share) {
        for (std::size_t k = 0; k < free_.size(); ++k) {
            const std::size_t n = free_[k].index();
            const Entity entity = mesh_.entities[n];
            const Vec3 to = from.points[k] + share * lengths_[k] * by[k];
            if (entity.dim == 3) {
                mesh_.points[n] = to;
            } else {
                const auto on = projector_.nearest_by_steps(entity, to, from.parameters[k]);
                mesh_.points[n] = on ? on->point : from.points[k];
                mesh_.parameters[n] = on ? on->parameters : from.parameters[k];
            }
        }
    }
    /// From one state to the mesh's, in units of the nodes' lengths.
    Field moved_since(const State& from) const {
        Field moved(free_.size());
        for (std::size_t k = 0; k < free_.size(); ++k)
            moved[k] = (mesh_.point(free_[k]) - from.points[k]) / lengths_[k];
        return moved;
    }

  private:
    template <class Visit>
    void for_each_node(TetId t, Visit visit) const {
        for (NodeId n : mesh_.tets[t.index()]) visit(n);
        for (NodeId n : mesh_.tet_mids[t.index()]) visit(n);
    }

    void collect(const TetsAtNode& tets_at, const std::vector<bool>& is_movable, const std::vector<TetId>& bad) {
        std::vector<NodeId> corners;
        for (const TetId t : bad)
            corners.insert(corners.end(), mesh_.tets[t.index()].begin(), mesh_.tets[t.index()].end());
        sort_once(corners);
        const auto is_near = [&](NodeId n) { return std::binary_search(corners.begin(), corners.end(), n); };
        for (const TetId t : tets_at.of(corners)) {
            const auto& n = mesh_.tets[t.index()];
            if (std::count_if(n.begin(), n.end(), is_near) < 2) continue;
            for_each_node(t, [&](NodeId node) {
                const bool is_corner = node.index() < mesh_.corner_count;
                if (!is_movable[node.index()] || place_[node.index()] >= 0) return;
                if (is_corner && (mesh_.entities[node.index()].dim < 3 || !is_near(node))) return;
                place_[node.index()] = static_cast<std::int32_t>(free_.size());
                free_.push_back(node);
            });
        }
        tets_ = tets_at.of(free_);
    }

    /// Of a mid-side node its side, of a corner the shortest side there.
    void measure_lengths() {
        lengths_.assign(free_.size(), infinite);
        for (const TetId t : tets_)
            for (int s = 0; s < 6; ++s) {
                const NodeId a = mesh_.tets[t.index()][tet_sides[s][0]], b = mesh_.tets[t.index()][tet_sides[s][1]];
                for (const NodeId n : {a, b, mesh_.tet_mids[t.index()][s]})
                    if (const std::int32_t k = place_[n.index()]; k >= 0) {
                        double& length = lengths_[static_cast<std::size_t>(k)];
                        length = std::min(length, distance(mesh_.point(a), mesh_.point(b)));
                    }
            }
    }

    /// A barrier that keeps the tet's volume above a floor: the least volume or three tenths of what it had, whichever
    /// is larger, but never more than nearly all of what it had. Infinite at the floor, zero from twice the floor on.
    double volume_energy(std::size_t i, const std::array<Vec3, 10>& nodes, Field* gradient) const {
        const double volume = 6 * signed_volume(nodes[0], nodes[1], nodes[2], nodes[3]);
        // a wall right behind a tet would leave it no way round
        constexpr double spare = 0.95, flattened_share = 0.3;
        const double had = barriers_[i].volume,
                     floor = std::min(spare * had, std::max(flattened_share * had, least_volume_));
        if (!(volume > std::max(floor, 0.0))) return infinite;
        if (!(floor > 0)) return 0;
        const double way = volume / floor - 1;
        if (!(way < 1)) return 0;
        const double log = std::log(way);
        if (gradient) {
            std::array<Vec3, 10> by_node{};
            for (int c = 0; c < 4; ++c) {
                const auto& [p, q, r] = opposite[static_cast<std::size_t>(c)];
                by_node[static_cast<std::size_t>(c)] =
                    2 * log / (way * floor) * cross(nodes[q] - nodes[p], nodes[r] - nodes[p]);
            }
            add_gradient(i, by_node, *gradient);
        }
        return log * log;
    }

    /// Squared logarithms of the coefficients' way from the barrier to what is wanted (1 there, 0 at the barrier).
    double tet_energy(std::size_t i, Field* gradient) const {
        const auto nodes = tet_nodes(mesh_, tets_[i]);
        double sum = volume_energy(i, nodes, gradient);
        if (sum == infinite) return sum;
        const auto c = jacobian_coefficients(nodes);
        const auto [at, volume] = barriers_[i];
        std::array<double, 20> weights{};
        bool counts = false;
        for (std::size_t k = 0; k < c.size(); ++k) {
            const double way = (c[k] / volume - at) / (wanted_ - at);
            if (way >= 1) continue;
            if (!(way > 0)) return infinite;
            const double log = std::log(way);
            sum += log * log;
            weights[k] = 2 * log / (way * (wanted_ - at) * volume);
            counts = true;
        }
        if (gradient && counts) add_gradient(i, jacobian_gradient(nodes, weights), *gradient);
        return sum;
    }
    void add_gradient(std::size_t i, const std::array<Vec3, 10>& by_node, Field& gradient) const {
        std::size_t at = 0;
        for_each_node(tets_[i], [&](NodeId n) {
            if (const std::int32_t k = place_[n.index()]; k >= 0) gradient[static_cast<std::size_t>(k)] += by_node[at];
            ++at;
        });
    }

    Vec3 along_entity(std::size_t k, const Vec3& v) const {
        const std::size_t n = free_[k].index();
        const Entity entity = mesh_.entities[n];
        return entity.dim == 3 ? v : projector_.along(entity, mesh_.parameters[n], v);
    }

    struct Barrier {
        double at = 0, volume = 0;
    };
    Mesh& mesh_;
    const Projector& projector_;
    const double wanted_, least_volume_;  ///< the latter of the determinant, six times a tet's
    std::vector<std::int32_t> place_;     ///< by node; -1 where it stays
    std::vector<NodeId> free_;
    std::vector<TetId> tets_;
    Field placed_;
    std::vector<double> lengths_;
    std::vector<Barrier> barriers_;
};

/// Limited-memory BFGS with halved steps.
class Descent {
  public:
    explicit Descent(Patch& patch) : patch_(patch) {}

    /// One step; whether the energy fell by something to speak of.
    bool step() {
        if (gradient_.empty()) energy_ = patch_.energy(&gradient_);
        Field direction = quasi_newton();
        double slope = product(direction, gradient_);
        if (!(slope < 0)) {
            pairs_.clear();
            direction = quasi_newton();
            slope = product(direction, gradient_);
        }
        constexpr double longest = 0.1;  // of a side, for one node in one step
        double most = 0;
        for (const Vec3& d : direction) most = std::max(most, length(d));
        if (!(slope < 0) || !(most > 0)) return false;
        const Patch::State start = patch_.state();
        double share = std::min(1.0, longest / most);
        for (int halving = 0; halving < 14; ++halving, share *= 0.5) {
            patch_.step(start, direction, share);
            if (patch_.energy(nullptr) < energy_ + 1e-4 * share * slope) return accept(start);
        }
        patch_.restore(start);
        return false;
    }

  private:
    struct Pair {
        Field moved, turned;
        double curvature;
    };

    bool accept(const Patch::State& start) {
        Field gradient;
        const double energy = patch_.energy(&gradient);
        Pair pair{patch_.moved_since(start), gradient, 0};
        for (std::size_t k = 0; k < gradient.size(); ++k) pair.turned[k] -= gradient_[k];
        pair.curvature = product(pair.moved, pair.turned);
        if (pair.curvature > 1e-12 * product(pair.turned, pair.turned)) pairs_.push_back(std::move(pair));
        if (pairs_.size() > 8) pairs_.pop_front();
        const bool gains = energy < energy_ * (1 - 1e-4);
        energy_ = energy;
        gradient_ = std::move(gradient);
        return gains;
    }

    Field quasi_newton() const {
        Field d = gradient_;
        std::vector<double> shares(pairs_.size());
        for (std::size_t i = pairs_.size(); i-- > 0;) {
            shares[i] = product(pairs_[i].moved, d) / pairs_[i].curvature;
            for (std::size_t k = 0; k < d.size(); ++k) d[k] -= shares[i] * pairs_[i].turned[k];
        }
        const double scale =
            pairs_.empty() ? 1e-2 : pairs_.back().curvature / product(pairs_.back().turned, pairs_.back().turned);
        for (Vec3& v : d) v = scale * v;
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            const double share = product(pairs_[i].turned, d) / pairs_[i].curvature;
            for (std::size_t k = 0; k < d.size(); ++k) d[k] += (shares[i] - share) * pairs_[i].moved[k];
        }
        for (Vec3& v : d) v = -v;
        return d;
    }

    Patch& patch_;
    double energy_ = 0;
    Field gradient_;
    std::deque<Pair> pairs_;
};

}  // namespace

void descend(Mesh& mesh, const TetsAtNode& tets_at, const Projector& projector, const std::vector<bool>& is_movable,
             const std::vector<TetId>& bad, const CurvedTetAims& aims, RunContext& context) {
    constexpr int most_rounds = 40, most_steps = 40;
    Patch patch(mesh, tets_at, projector, is_movable, bad, aims);
    if (patch.size() == 0) return;
    for (int round = 0; round < most_rounds && patch.renew_barriers(); ++round) {
        Descent descent(patch);
        int steps = 0;
        while (steps < most_steps && descent.step()) {
            context.check_cancelled();
            ++steps;
        }
        if (steps == 0) return;
    }
}

}  // namespace featuremesh

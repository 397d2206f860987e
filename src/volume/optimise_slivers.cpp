// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "volume/cavity_editor.h"
#include "volume/cone_refill.h"
#include "volume/edge_removal.h"
#include "volume/optimise.h"
#include "volume/tet_measures.h"
#include "volume/vertex_move.h"

namespace featuremesh {

namespace {

constexpr std::size_t rounds_between_reports = 64;
/// Refilling costs a hundred times what an edge removal does. Where very many tets cannot be helped (thin walls) only
/// the worst get it.
constexpr std::size_t refills_at_least = 4000, tets_per_refill = 50;
/// Below this share of the target angle a new vertex is welcome even if the target stays out of reach.
constexpr double urgent_share = 0.85;

class SliverRemover {
  public:
    SliverRemover(TetComplex& complex, const SliverOptions& options, RunContext& context)
        : complex_(complex),
          options_(options),
          context_(context),
          target_(flatness_to_reach(options.target_dihedral_deg)),
          editor_(complex),
          refill_(editor_, target_, flatness_of_angle(urgent_share * options.target_dihedral_deg),
                  options.is_last_resort),
          refills_left_(options.most_refills.value_or(refills_at_least + complex.tets.size() / tets_per_refill)),
          changed_at_(complex.points.size(), 1),
          tried_at_(complex.tets.size(), 0) {}

    SliverReport run() {
        changed_ = options_.among;
        if (changed_.empty()) {
            changed_.resize(complex_.tets.size());
            std::iota(changed_.begin(), changed_.end(), 0);
        }
        std::vector<Candidate> worst_first = rank_changed();
        report_.before = count_missing(worst_first);
        for (int pass = 0; pass < options_.passes && !worst_first.empty(); ++pass) {
            const bool gained = work_off(worst_first, pass);
            worst_first = rank_changed();
            if (!gained) break;
        }
        report_.left = count_missing(worst_first);
        for (const Candidate& c : worst_first) report_.forced += is_forced(complex_, c.tet, c.flatness);
        return report_;
    }

  private:
    struct Candidate {
        double flatness;
        int tet;
    };

    double flatness_of(int tet) const { return worst_flatness(complex_, std::array{tet}); }

    /// The changed tets that miss the target, worst first.
    std::vector<Candidate> rank_changed() {
        std::sort(changed_.begin(), changed_.end());
        changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
        std::vector<Candidate> ranked;
        for (int tet : changed_) {
            if (complex_.tets[tet][0] < 0) continue;
            const double value = flatness_of(tet);
            if (value > target_) ranked.push_back({value, tet});
        }
        std::sort(ranked.begin(), ranked.end(), [](const Candidate& a, const Candidate& b) {
            return a.flatness != b.flatness ? a.flatness > b.flatness : a.tet < b.tet;
        });
        changed_.clear();
        return ranked;
    }

    std::size_t count_missing(const std::vector<Candidate>& ranked) const {
        const double wanted = flatness_of_angle(options_.target_dihedral_deg);
        return static_cast<std::size_t>(
            std::count_if(ranked.begin(), ranked.end(), [&](const Candidate& c) { return c.flatness > wanted; }));
    }

    bool work_off(const std::vector<Candidate>& ranked, int pass) {
        bool gained = false;
        for (std::size_t i = 0; i < ranked.size(); ++i) {
            if (i % rounds_between_reports == 0)
                context_.progress((pass + static_cast<double>(i) / static_cast<double>(ranked.size())) /
                                  options_.passes);
            const auto [value, tet] = ranked[i];
            changed_.push_back(tet);
            // an earlier operation may have changed it or used its place for another tet, whose turn is in the next
            // pass
            if (complex_.tets[tet][0] < 0 || flatness_of(tet) != value || !is_worth_trying(tet, value)) continue;
            if (improve(tet))
                gained = true;
            else
                tried_at_[tet] = ++clock_;
        }
        return gained;
    }

    /// What failed once fails again until something near it has changed.
    bool is_worth_trying(int tet, double value) const {
        const Tet& v = complex_.tets[tet];
        const bool is_new = std::any_of(v.begin(), v.end(), [&](int c) { return changed_at_[c] > tried_at_[tet]; });
        return is_new && !is_forced(complex_, tet, value);
    }

    bool improve(int tet) { return remove_edge(tet) || move_corners(tet) || refill(tet); }

    bool remove_edge(int tet) {
        EdgeRing ring;
        const RingTriangulation<> best = best_triangulation(tet, ring);
        if (std::isinf(best.cost)) return false;
        std::array<Tet, 2 * EdgeRing::max_size> added;
        const int count = tets_of_triangulation(ring, best, added);
        const std::span<const Tet> fresh{added.data(), static_cast<std::size_t>(count)};
        if (best.cost > target_ && !is_lighter(burden_of(complex_, fresh, target_), ring.all_tets())) return false;
        replace(ring.all_tets(), fresh);
        ++report_.edge_removals;
        return true;
    }

    /// Of the rings of the tet's six edges; of infinite cost where none gains.
    RingTriangulation<> best_triangulation(int tet, EdgeRing& best_ring) const {
        EdgeRing ring;
        RingTriangulation<> best;
        for (const auto& [from, to] : edge_corners) {
            if (!find_ring(complex_, tet, from, to, ring)) continue;
            const double before = worst_flatness(complex_, ring.all_tets());
            const double limit = std::min(improved_flatness(before, least_gain), best.cost);
            const RingTriangulation found = least_flat_triangulation(complex_, ring, limit);
            if (std::isinf(found.cost)) continue;
            best = found;
            best_ring = ring;
        }
        return best;
    }

    /// A better worst tet is not worth many more bad ones.
    bool is_lighter(double burden, std::span<const int> before) const {
        return burden < burden_of(complex_, before, target_);
    }

    void replace(std::span<const int> removed, std::span<const Tet> added) {
        note_changed(editor_.replace(removed, added));
        tried_at_.resize(complex_.tets.size(), 0);
    }

    void note_changed(std::span<const int> tets) {
        changed_.insert(changed_.end(), tets.begin(), tets.end());
        ++clock_;
        for (int tet : tets)
            for (int v : complex_.tets[tet]) changed_at_[v] = clock_;
    }

    bool move_corners(int tet) {
        bool gained = false;
        for (int v : complex_.tets[tet])
            if (complex_.is_fixed[v] != 1 && move(v)) gained = true;
        return gained;
    }

    bool move(int vertex) {
        if (!gather_star(complex_, vertex, star_)) return false;
        shape_.gather(complex_, star_, vertex);
        Vec3 place = complex_.points[vertex];
        const double before = shape_.worst(place, 2 * inverted_flatness);
        if (before <= target_ || shape_.climb(place, target_) >= improved_flatness(before, least_gain)) return false;
        if (!is_lighter(shape_.burden(place, target_), star_)) return false;
        complex_.points[vertex] = place;
        note_changed(star_);
        ++report_.moves;
        return true;
    }

    bool refill(int tet) {
        if (refills_left_ == 0) return false;
        --refills_left_;
        ++report_.refills;
        const ConePlan* plan = refill_.plan(tet);
        if (!plan) return false;
        if (plan->is_insertion) {
            editor_.add_vertex(plan->point);
            changed_at_.push_back(0);
        }
        corners_.clear();
        for (int t : plan->removed) corners_.insert(corners_.end(), complex_.tets[t].begin(), complex_.tets[t].end());
        replace(plan->removed, plan->added);
        const bool is_collapse =
            std::any_of(corners_.begin(), corners_.end(), [&](int v) { return complex_.tet_of_vertex[v] < 0; });
        ++(plan->is_insertion ? report_.insertions : is_collapse ? report_.collapses : report_.face_flips);
        return true;
    }

    TetComplex& complex_;
    const SliverOptions& options_;
    RunContext& context_;
    double target_;
    CavityEditor editor_;
    ConeRefill refill_;
    std::size_t refills_left_;
    SliverReport report_;
    StarShape shape_;
    std::vector<int> changed_, corners_, star_;
    // when a vertex last got another star, and when a tet was last tried in vain
    std::vector<std::uint32_t> changed_at_, tried_at_;
    std::uint32_t clock_ = 1;
};

}  // namespace

SliverReport remove_slivers(TetComplex& complex, const SliverOptions& options, RunContext& context) {
    return SliverRemover(complex, options, context).run();
}

}  // namespace featuremesh

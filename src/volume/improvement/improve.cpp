// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/improvement/improve.h"

#include <algorithm>
#include <numeric>

namespace featuremesh {

namespace {

constexpr std::size_t rounds_between_reports = 64;

/// Walls remember what they were asked for, so one thread asks.
std::size_t grain_of(std::size_t count, const Objective& objective) {
    constexpr std::size_t tets_per_chunk = 1 << 12;
    return objective.options().is_barred ? std::max<std::size_t>(count, 1) : tets_per_chunk;
}

class Improver {
  public:
    Improver(LocalMesh& mesh, const Objective& objective, const Operations& operations, Region region,
             const Budget& budget, RunContext& context)
        : mesh_(mesh),
          complex_(mesh.complex()),
          objective_(objective),
          operations_(operations),
          budget_(budget),
          context_(context),
          changed_(std::move(region)),
          tried_at_(complex_.tets.size(), 0),
          dear_plans_left_(budget.dear_plans) {
        for (const auto& operation : operations) result_.counts.push_back({operation->name()});
        if (!changed_.empty()) {
            is_in_region_.assign(complex_.tets.size(), 0);
            for (const int tet : changed_) is_in_region_[tet] = 1;
            return;
        }
        changed_.resize(complex_.tets.size());
        std::iota(changed_.begin(), changed_.end(), 0);
    }

    Improvement run() {
        std::vector<Candidate> queue = rank_changed();
        result_.before = count_missing(queue);
        result_.why = queue.empty() ? Stop::all_good : Stop::out_of_passes;
        for (int pass = 0; pass < budget_.passes && !queue.empty(); ++pass) {
            const bool gained = work_off(queue, pass);
            queue = rank_changed();
            if (!gained || queue.empty()) result_.why = queue.empty() ? Stop::all_good : Stop::nothing_gains;
            if (!gained) break;
        }
        result_.left = count_missing(queue);
        for (const Candidate& c : queue) result_.forced += is_forced_at(c);
        return std::move(result_);
    }

  private:
    struct Candidate {
        double need;
        int tet;
        bool is_bad() const { return need > 1; }
    };

    /// Those of the changed tets that are in need of work, worst first.
    std::vector<Candidate> rank_changed() {
        std::sort(changed_.begin(), changed_.end());
        changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
        std::vector<double> needs(changed_.size(), 0);
        parallel_for(context_, changed_.size(), grain_of(changed_.size(), objective_),
                     [&](std::size_t begin, std::size_t end) {
                         for (std::size_t i = begin; i < end; ++i)
                             if (const Tet& tet = complex_.tets[changed_[i]]; tet[0] >= 0)
                                 needs[i] = objective_.need(complex_, tet);
                     });
        std::vector<Candidate> ranked;
        for (std::size_t i = 0; i < changed_.size(); ++i) {
            const Candidate of{needs[i], changed_[i]};
            if (of.is_bad() || (of.need > 0 && is_in_region(of.tet))) ranked.push_back(of);
        }
        std::sort(ranked.begin(), ranked.end(), [](const Candidate& a, const Candidate& b) {
            return a.need != b.need ? a.need > b.need : a.tet < b.tet;
        });
        changed_.clear();
        return ranked;
    }

    std::size_t count_missing(const std::vector<Candidate>& queue) const {
        return static_cast<std::size_t>(std::count_if(queue.begin(), queue.end(), [&](const Candidate& c) {
            return c.is_bad() && objective_.misses(c.need - 1);
        }));
    }

    bool is_forced_at(const Candidate& c) const {
        return c.is_bad() && c.need <= 2 && is_forced(complex_, c.tet, c.need - 1);
    }

    bool is_in_region(int tet) const {
        return is_in_region_.empty() || (tet < static_cast<int>(is_in_region_.size()) && is_in_region_[tet] != 0);
    }

    bool work_off(const std::vector<Candidate>& queue, int pass) {
        bool gained = false;
        for (std::size_t i = 0; i < queue.size(); ++i) {
            if (i % rounds_between_reports == 0)
                context_.progress((pass + static_cast<double>(i) / static_cast<double>(queue.size())) / budget_.passes);
            const Candidate& of = queue[i];
            const Tet& tet = complex_.tets[of.tet];
            changed_.push_back(of.tet);
            // an earlier change may have used its place for another tet, whose turn is in the next pass
            if (tet[0] < 0 || objective_.need(complex_, tet) != of.need || !is_new(of.tet)) continue;
            if (help(of))
                gained = true;
            else
                tried_at_[of.tet] = mesh_.now();
        }
        return gained;
    }

    bool is_new(int tet) const {
        const Tet& v = complex_.tets[tet];
        return std::any_of(v.begin(), v.end(), [&](int c) { return mesh_.changed_at(c) > tried_at_[tet]; });
    }

    bool help(const Candidate& of) {
        const bool is_forced = is_forced_at(of);
        for (std::size_t i = 0; i < operations_.size(); ++i) {
            Operation& operation = *operations_[i];
            if (is_forced && !operation.moves_boundary()) continue;
            if (operation.is_dear() && dear_plans_left_ == 0) continue;
            ++result_.counts[i].planned;
            Change change;
            const bool is_found = operation.plan(of.tet, change);
            dear_plans_left_ -= change.was_dear;
            if (!is_found) continue;
            if (change.was_dear) dear_plans_left_ += budget_.dear_plans_per_gain;
            const std::span<const int> changed = mesh_.apply(change);
            changed_.insert(changed_.end(), changed.begin(), changed.end());
            tried_at_.resize(complex_.tets.size(), 0);
            ++result_.counts[i].made;
            ++result_.changes;
            return true;
        }
        return false;
    }

    LocalMesh& mesh_;
    const TetComplex& complex_;
    const Objective& objective_;
    const Operations& operations_;
    const Budget& budget_;
    RunContext& context_;
    std::vector<int> changed_;
    std::vector<char> is_in_region_;       // by tet, where not all are
    std::vector<std::uint32_t> tried_at_;  // by tet: when all was tried in vain
    std::size_t dear_plans_left_;
    Improvement result_;
};

template <class Predicate>
std::size_t count_tets(const TetComplex& complex, const Objective& objective, Predicate predicate,
                       RunContext& context) {
    const std::size_t grain = grain_of(complex.tets.size(), objective);
    std::vector<std::size_t> counts(complex.tets.size() / grain + 1, 0);
    parallel_for(context, complex.tets.size(), grain, [&](std::size_t begin, std::size_t end) {
        counts[begin / grain] =
            static_cast<std::size_t>(std::count_if(complex.tets.begin() + static_cast<std::ptrdiff_t>(begin),
                                                   complex.tets.begin() + static_cast<std::ptrdiff_t>(end),
                                                   [&](const Tet& tet) { return tet[0] >= 0 && predicate(tet); }));
    });
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

}  // namespace

Improvement improve(LocalMesh& mesh, const Objective& objective, const Operations& operations, Region region,
                    const Budget& budget, RunContext& context) {
    return Improver(mesh, objective, operations, std::move(region), budget, context).run();
}

std::size_t count_bad(const TetComplex& complex, const Objective& objective, RunContext& context) {
    return count_tets(
        complex, objective, [&](const Tet& tet) { return objective.misses(objective.flaw(complex, tet)); }, context);
}

std::size_t count_thin(const TetComplex& complex, const Objective& objective, RunContext& context) {
    return count_tets(
        complex, objective, [&](const Tet& tet) { return objective.flaw(complex, tet) > 1; }, context);
}

}  // namespace featuremesh

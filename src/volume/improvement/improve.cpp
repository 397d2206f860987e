// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/improvement/improve.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

constexpr std::size_t rounds_between_reports = 64;
constexpr std::size_t tets_per_chunk = 1 << 12;
/// For so many tets of the queue changes are planned ahead at most. With more, too many plans are outdated before their
/// turn; with fewer, the threads wait for one another.
constexpr std::size_t most_ahead = 64;

struct Candidate {
    double need;
    int tet;
    bool is_bad() const { return need > 1; }
};

struct Ranked {
    double need = 0;
    std::uint32_t at = 0;       // the change before it
    std::uint32_t ranking = 0;  // the last one it was in
};

constexpr std::size_t no_place = std::numeric_limits<std::size_t>::max();

/// What the operations would do for a tet. They are asked in their order until one of them has a change.
struct Plan {
    enum class Answer : std::uint8_t { not_asked, in_vain, found };
    struct OfOperation {
        Answer answer = Answer::not_asked;
        bool was_dear = false;
    };
    std::size_t place = no_place;  // in the queue
    std::uint32_t made_at = 0;
    std::size_t point_count = 0;  // new vertices count on from it
    std::vector<OfOperation> answers;
    bool is_cut_short = false;  // before a dear operation
    Change change;
    Footprint footprint;

    void begin(std::size_t of, std::size_t operations, bool is_ahead) {
        place = of, is_cut_short = false;
        answers.assign(operations, {});
        footprint.begin(is_ahead);
    }
    bool ask(Operation& operation, std::size_t i, int tet, std::size_t points) {
        change = {};
        point_count = points;
        const bool is_found = operation.plan(tet, change, footprint);
        answers[i] = {is_found ? Answer::found : Answer::in_vain, change.was_dear};
        return is_found;
    }
    /// Others may have got the numbers of its new vertices.
    void renumber(std::size_t points) {
        const int begin = static_cast<int>(point_count), shift = static_cast<int>(points) - begin;
        if (shift == 0) return;
        for (Tet& tet : change.added)
            for (int& v : tet)
                if (v >= begin) v += shift;
    }
};

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
          dear_plans_left_(budget.dear_plans),
          plans_(1) {
        for (const auto& operation : operations) result_.counts.push_back({operation->name()});
        if (context.threads > 1) gather_hands();
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
        result_.before = count_bad_in(queue);
        result_.why = queue.empty() ? Stop::all_good : Stop::out_of_passes;
        for (int pass = 0; pass < budget_.passes && !queue.empty(); ++pass) {
            const bool gained = work_off(queue, pass);
            queue = rank_changed();
            if (!gained || queue.empty()) result_.why = queue.empty() ? Stop::all_good : Stop::nothing_gains;
            if (!gained) break;
        }
        result_.left = count_bad_in(queue);
        for (const Candidate& c : queue) result_.forced += is_forced_at(c);
        return std::move(result_);
    }

  private:
    /// Makes a set of operations for each further thread. None if some operation's plans depend on those it made
    /// before.
    void gather_hands() {
        for (int thread = 1; thread < context_.threads; ++thread) {
            Operations& hand = other_hands_.emplace_back();
            for (const auto& operation : operations_) hand.push_back(operation->for_another_thread());
            if (std::count(hand.begin(), hand.end(), nullptr) > 0) return other_hands_.clear();
        }
        plans_.resize(std::max(most_ahead, 2 * (other_hands_.size() + 1)));
    }

    /// Those of the changed tets that are in need of work, worst first.
    std::vector<Candidate> rank_changed() {
        ranked_.resize(complex_.tets.size());
        ++rankings_;
        std::erase_if(changed_, [&](int tet) { return std::exchange(ranked_[tet].ranking, rankings_) == rankings_; });
        std::vector<std::vector<Candidate>> parts(changed_.size() / tets_per_chunk + 1);
        parallel_for(context_, changed_.size(), tets_per_chunk, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                if (const Candidate of{known_need_of(changed_[i]), changed_[i]}; is_in_need(of))
                    parts[begin / tets_per_chunk].push_back(of);
        });
        std::vector<Candidate> ranked;
        for (const std::vector<Candidate>& part : parts) ranked.insert(ranked.end(), part.begin(), part.end());
        std::sort(ranked.begin(), ranked.end(), [](const Candidate& a, const Candidate& b) {
            return a.need != b.need ? a.need > b.need : a.tet < b.tet;
        });
        changed_.clear();
        return ranked;
    }

    /// What it was when it was last ranked, unless it has changed since.
    double known_need_of(int tet) {
        Ranked& last = ranked_[tet];
        if (last.at < mesh_.tet_changed_at(tet)) last.need = need_of(tet), last.at = mesh_.now();
        return last.need;
    }
    double need_of(int tet) const {
        return complex_.tets[tet][0] >= 0 ? objective_.need(complex_, complex_.tets[tet]) : 0;
    }
    bool is_in_need(const Candidate& of) const { return of.is_bad() || (of.need > 0 && is_in_region(of.tet)); }

    std::size_t count_bad_in(const std::vector<Candidate>& queue) const {
        return static_cast<std::size_t>(std::count_if(queue.begin(), queue.end(), [&](const Candidate& c) {
            return c.is_bad() && c.need - 1 > objective_.asked();
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
        for (Plan& plan : plans_) plan.begin(no_place, operations_.size(), false);
        last_round_ = 0;
        for (std::size_t i = 0; i < queue.size(); ++i) {
            if (i % rounds_between_reports == 0)
                context_.progress((pass + static_cast<double>(i) / static_cast<double>(queue.size())) / budget_.passes);
            const Candidate& of = queue[i];
            changed_.push_back(of.tet);
            if (!is_due(of)) continue;
            if (help(of, plan_for(queue, i)))
                gained = true;
            else
                tried_at_[of.tet] = mesh_.now();
        }
        return gained;
    }

    /// An earlier change may have removed it, or used its place for another tet, whose turn is in the next pass.
    bool is_due(const Candidate& of) const {
        return (mesh_.tet_changed_at(of.tet) <= ranked_[of.tet].at || need_of(of.tet) == of.need) &&
               has_changed_since_tried(of.tet);
    }

    bool has_changed_since_tried(int tet) const {
        const Tet& v = complex_.tets[tet];
        return std::any_of(v.begin(), v.end(), [&](int c) { return mesh_.changed_at(c) > tried_at_[tet]; });
    }

    /// What was planned ahead for it, if that holds; else nothing yet.
    Plan& plan_for(const std::vector<Candidate>& queue, std::size_t i) {
        if (!other_hands_.empty()) plan_ahead(queue, i);
        Plan& plan = plans_[i % plans_.size()];
        if (!holds(plan, queue, i, i)) plan.begin(i, operations_.size(), false);
        return plan;
    }

    /// Whether the plan is the one that would be made now, at the turn of `first`: nothing that it depends on has
    /// changed, and no dear operation was left out that may be asked now.
    bool holds(const Plan& plan, const std::vector<Candidate>& queue, std::size_t i, std::size_t first) const {
        if (plan.place != i || mesh_.has_changed(plan.footprint.tets(), plan.made_at)) return false;
        if (plan.is_cut_short && may_be_dear(i, first)) return false;
        const Tet& v = complex_.tets[queue[i].tet];
        return v[0] < 0 || std::none_of(v.begin(), v.end(), [&](int c) {
                   return complex_.mobility[c] != Mobility::fixed && mesh_.changed_at(c) > plan.made_at;
               });
    }

    /// Even if each tet from `first` on costs one dear plan, the budget lasts until this one.
    bool may_be_dear(std::size_t i, std::size_t first) const { return i - first < dear_plans_left_; }

    /// If the plan for the tet `first` no longer holds, all threads make plans: for it, and for those after it that
    /// have none that holds.
    void plan_ahead(const std::vector<Candidate>& queue, std::size_t first) {
        if (holds(plans_[first % plans_.size()], queue, first, first)) return;
        // plans that were soon outdated: the cavity is small, or changes reach far, so the next round plans less far
        // ahead
        reach_ = std::clamp(2 * (first - last_round_), 2 * (other_hands_.size() + 1), plans_.size());
        last_round_ = first;
        without_plan_.clear();
        for (std::size_t i = first; i < std::min(queue.size(), first + reach_); ++i)
            if (!holds(plans_[i % plans_.size()], queue, i, first)) without_plan_.push_back(i);
        if (without_plan_.size() < 2) return;
        result_.planned_ahead += without_plan_.size();
        for (const std::size_t i : without_plan_) result_.outdated += plans_[i % plans_.size()].place == i;
        for (const auto& operation : operations_) operation->prepare();
        std::atomic<std::size_t> next = 0;
        parallel_for(context_, other_hands_.size() + 1, 1, [&](std::size_t hand, std::size_t) {
            const Operations& operations = hand == 0 ? operations_ : other_hands_[hand - 1];
            for (std::size_t k = next++; k < without_plan_.size(); k = next++) {
                const std::size_t i = without_plan_[k];
                make_plan(plans_[i % plans_.size()], operations, queue[i], i, may_be_dear(i, first));
            }
        });
    }

    void make_plan(Plan& plan, const Operations& operations, const Candidate& of, std::size_t place,
                   bool asks_dear) const {
        plan.begin(place, operations.size(), true);
        plan.made_at = mesh_.now();
        plan.footprint.add(of.tet);
        if (!is_due(of)) return;
        const bool is_forced = is_forced_at(of);
        for (std::size_t i = 0; i < operations.size(); ++i) {
            if (is_forced && !operations[i]->moves_boundary()) continue;
            // whether there is a budget for it is known when it is its turn
            if (operations[i]->is_dear() && !asks_dear) {
                plan.is_cut_short = true;
                return;
            }
            if (plan.ask(*operations[i], i, of.tet, complex_.points.size())) return;
        }
    }

    bool help(const Candidate& of, Plan& plan) {
        const bool is_forced = is_forced_at(of);
        for (std::size_t i = 0; i < operations_.size(); ++i) {
            Operation& operation = *operations_[i];
            if (is_forced && !operation.moves_boundary()) continue;
            if (operation.is_dear() && dear_plans_left_ == 0) continue;
            ++result_.counts[i].planned;
            const Plan::OfOperation& answer = plan.answers[i];
            if (answer.answer == Plan::Answer::not_asked) plan.ask(operation, i, of.tet, complex_.points.size());
            dear_plans_left_ -= answer.was_dear;
            if (answer.answer != Plan::Answer::found) continue;
            if (answer.was_dear) dear_plans_left_ += budget_.dear_plans_per_gain;
            make(plan, i);
            return true;
        }
        return false;
    }

    void make(Plan& plan, std::size_t operation) {
        plan.renumber(complex_.points.size());
        const std::span<const int> changed = mesh_.apply(plan.change);
        changed_.insert(changed_.end(), changed.begin(), changed.end());
        tried_at_.resize(complex_.tets.size(), 0);
        ++result_.counts[operation].made;
        ++result_.changes;
    }

    LocalMesh& mesh_;
    const TetComplex& complex_;
    const Objective& objective_;
    const Operations& operations_;
    const Budget& budget_;
    RunContext& context_;
    std::vector<int> changed_;
    std::vector<Ranked> ranked_;  // by tet
    std::uint32_t rankings_ = 0;
    std::vector<char> is_in_region_;       // by tet, where not all are
    std::vector<std::uint32_t> tried_at_;  // by tet: when all was tried in vain
    std::size_t dear_plans_left_;
    std::vector<Operations> other_hands_;    // the operations of each thread but the first
    std::vector<Plan> plans_;                // for the next of the queue, by place modulo their number
    std::vector<std::size_t> without_plan_;  // places in the queue
    std::size_t last_round_ = 0, reach_ = most_ahead;
    Improvement result_;
};

std::size_t count_worse(const TetComplex& complex, double than, const Objective& objective, RunContext& context) {
    std::atomic<std::size_t> count = 0;
    parallel_for(context, complex.tets.size(), tets_per_chunk, [&](std::size_t begin, std::size_t end) {
        const std::span<const Tet> tets = std::span(complex.tets).subspan(begin, end - begin);
        count += static_cast<std::size_t>(std::count_if(tets.begin(), tets.end(), [&](const Tet& tet) {
            return tet[0] >= 0 && objective.flaw(complex, tet) > than;
        }));
    });
    return count;
}

}  // namespace

Improvement improve(LocalMesh& mesh, const Objective& objective, const Operations& operations, Region region,
                    const Budget& budget, RunContext& context) {
    return Improver(mesh, objective, operations, std::move(region), budget, context).run();
}

std::size_t count_bad(const TetComplex& complex, const Objective& objective, RunContext& context) {
    return count_worse(complex, objective.asked(), objective, context);
}

std::size_t count_thin(const TetComplex& complex, const Objective& objective, RunContext& context) {
    return count_worse(complex, 1, objective, context);
}

}  // namespace featuremesh

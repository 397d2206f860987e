// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "volume/cavity_editor.h"
#include "volume/edge_removal.h"
#include "volume/optimise.h"
#include "volume/tet_measures.h"
#include "volume/vertex_move.h"

namespace featuremesh {

namespace {

/// An operation has to win at least this share of flatness, else passes would go on for nothing.
constexpr double least_gain = 1e-4;
constexpr std::size_t rounds_between_reports = 256;

/// What would happen to a cavity: planned on the untouched complex, so that a refusal needs no repair.
struct Plan {
    double flatness = inverted_flatness;
    int removed_count = 0, added_count = 0;
    std::array<int, EdgeRing::max_size> removed;
    std::array<Tet, 2 * EdgeRing::max_size> added;
};

class SliverRemover {
  public:
    SliverRemover(TetComplex& complex, const SliverOptions& options, RunContext& context)
        : complex_(complex),
          options_(options),
          context_(context),
          target_(flatness_of_angle(options.target_dihedral_deg)),
          editor_(complex) {}

    SliverReport run() {
        std::vector<int> all(complex_.tets.size());
        for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<int>(t);
        std::vector<Candidate> worst_first = rank(all);
        report_.before = worst_first.size();
        for (int pass = 0; pass < options_.passes && !worst_first.empty(); ++pass) {
            const bool gained = work_off(worst_first, pass);
            worst_first = rank(changed_);
            if (!gained) break;
        }
        report_.left = worst_first.size();
        return report_;
    }

  private:
    struct Candidate {
        double flatness;
        int tet;
    };

    double flatness_of(int tet) const { return worst_flatness(complex_, &tet, &tet + 1); }

    /// The tets that miss the target, worst first.
    std::vector<Candidate> rank(std::vector<int>& tets) const {
        std::sort(tets.begin(), tets.end());
        tets.erase(std::unique(tets.begin(), tets.end()), tets.end());
        std::vector<Candidate> ranked;
        for (int tet : tets) {
            if (complex_.tets[tet][0] < 0) continue;
            const double value = flatness_of(tet);
            if (value > target_) ranked.push_back({value, tet});
        }
        std::sort(ranked.begin(), ranked.end(), [](const Candidate& a, const Candidate& b) {
            return a.flatness != b.flatness ? a.flatness > b.flatness : a.tet < b.tet;
        });
        return ranked;
    }

    bool work_off(const std::vector<Candidate>& ranked, int pass) {
        changed_.clear();
        bool gained = false;
        for (std::size_t i = 0; i < ranked.size(); ++i) {
            if (i % rounds_between_reports == 0)
                context_.progress((pass + static_cast<double>(i) / static_cast<double>(ranked.size())) /
                                  options_.passes);
            const int tet = ranked[i].tet;
            changed_.push_back(tet);
            // an earlier operation may have improved it or used its place for another tet, whose turn is in the next
            // pass
            if (complex_.tets[tet][0] < 0 || flatness_of(tet) != ranked[i].flatness) continue;
            gained |= improve(tet);
        }
        return gained;
    }

    bool improve(int tet) {
        const bool flipped = flip(tet);
        return flipped || move_corners(tet);
    }

    bool flip(int tet) {
        Plan best;
        bool is_edge = false;
        for (const auto& [from, to] : edge_corners)
            if (plan_edge_removal(tet, from, to, best)) is_edge = true;
        for (int face = 0; face < 4; ++face)
            if (plan_face_flip(tet, face, best)) is_edge = false;
        if (best.removed_count == 0) return false;
        const auto added = editor_.replace({best.removed.data(), static_cast<std::size_t>(best.removed_count)},
                                           {best.added.data(), static_cast<std::size_t>(best.added_count)});
        changed_.insert(changed_.end(), added.begin(), added.end());
        ++(is_edge ? report_.edge_removals : report_.face_flips);
        return true;
    }

    bool plan_edge_removal(int tet, int from, int to, Plan& best) const {
        EdgeRing ring;
        if (!find_ring(complex_, tet, from, to, ring)) return false;
        const double before = worst_flatness(complex_, ring.tets.data(), ring.tets.data() + ring.size);
        const double limit = std::min(before * (1 - least_gain), best.flatness);
        const auto found = least_flat_triangulation(complex_, ring, limit);
        if (std::isinf(found.cost)) return false;
        best.flatness = found.cost;
        best.removed_count = ring.size;
        std::copy_n(ring.tets.begin(), ring.size, best.removed.begin());
        best.added_count = tets_of_triangulation(ring, found, best.added);
        return true;
    }

    bool plan_face_flip(int tet, int face, Plan& best) const {
        const int next = complex_.neighbours[tet][face];
        if (next < 0) return false;
        const std::array<int, 2> pair{tet, next};
        const double before = worst_flatness(complex_, pair.data(), pair.data() + 2);
        const double limit = std::min(before * (1 - least_gain), best.flatness);
        const Tet& v = complex_.tets[tet];
        const Tet& w = complex_.tets[next];
        const int apex = w[0] ^ w[1] ^ w[2] ^ w[3] ^ v[0] ^ v[1] ^ v[2] ^ v[3] ^ v[face];
        const auto& corner = opposite_face[face];
        std::array<Tet, 3> fresh;
        double after = 0;
        for (int i = 0; i < 3 && after < limit; ++i) {
            fresh[i] = {v[face], v[corner[i]], v[corner[(i + 1) % 3]], apex};
            const auto& p = complex_.points;
            after = std::max(after, flatness(p[fresh[i][0]], p[fresh[i][1]], p[fresh[i][2]], p[fresh[i][3]]));
        }
        if (after >= limit) return false;
        best.flatness = after;
        best.removed_count = 2;
        std::copy_n(pair.begin(), 2, best.removed.begin());
        best.added_count = 3;
        std::copy_n(fresh.begin(), 3, best.added.begin());
        return true;
    }

    bool move_corners(int tet) {
        bool gained = false;
        for (int v : complex_.tets[tet])
            if (!complex_.is_fixed[v] && move(v)) gained = true;
        return gained;
    }

    bool move(int vertex) {
        const auto star = editor_.star(vertex);
        if (star.empty()) return false;
        shape_.gather(complex_, star, vertex);
        Vec3 place = complex_.points[vertex];
        const double before = shape_.worst(place, 2 * inverted_flatness);
        if (before <= target_ || shape_.climb(place, target_) > before * (1 - least_gain)) return false;
        complex_.points[vertex] = place;
        changed_.insert(changed_.end(), star.begin(), star.end());
        ++report_.moves;
        return true;
    }

    TetComplex& complex_;
    const SliverOptions& options_;
    RunContext& context_;
    double target_;
    CavityEditor editor_;
    SliverReport report_;
    StarShape shape_;
    std::vector<int> changed_;
};

}  // namespace

SliverReport remove_slivers(TetComplex& complex, const SliverOptions& options, RunContext& context) {
    return SliverRemover(complex, options, context).run();
}

}  // namespace featuremesh

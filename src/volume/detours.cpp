// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/detours.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "volume/cavity_editor.h"
#include "volume/needles.h"
#include "volume/optimise.h"
#include "volume/tet_measures.h"
#include "volume/tet_topology.h"
#include "volume/thicken.h"

namespace featuremesh {

namespace {

/// A tet is mended together with those that share a vertex with it, and those that do with these.
constexpr int rings_of_patch = 2;
constexpr std::size_t tries_at_least = 50, tets_per_try = 2000;
/// Where so many tets meet, or so many are bad, a try would take as long as hundreds elsewhere.
constexpr std::size_t most_tets = 400, most_bad_tets = 20, looks_per_try = 4;
/// Of the burden of the tets that change: less is not worth it.
constexpr double least_gain_of_burden = 0.02;

Tet sorted(Tet tet) {
    std::sort(tet.begin(), tet.end());
    return tet;
}

/// Some tets of a complex as a complex of their own, in which nothing can change that others touch.
struct Patch {
    TetComplex complex;
    std::vector<int> tets, points;         // of the original; those of the complex begin with them
    std::vector<char> is_outer;            // by point of the original: on the boundary, or kept
    std::vector<BoundaryVertex> vertices;  // that may move
    std::vector<std::size_t> places;       // of these in the original's list
};

struct Rating {
    double worst = 0, burden = 0;
    std::size_t between_walls = 0;  // with no vertex inside
    bool is_thin = false;           // a tet hardly has a volume
};

class DetourSearch {
  public:
    DetourSearch(TetComplex& complex, std::span<BoundaryVertex> vertices, const Projector& projector,
                 const BoundaryMoveOptions& options, RunContext& context)
        : complex_(complex),
          vertices_(vertices),
          projector_(projector),
          options_(options),
          context_(context),
          target_(flatness_to_reach(options.target_dihedral_deg)),
          editor_(complex),
          place_of_(complex.points.size(), -1) {
        slivers_.target_dihedral_deg = options.target_dihedral_deg;
        slivers_.is_last_resort = true;
        for (std::size_t i = 0; i < vertices.size(); ++i) place_of_[vertices[i].vertex] = static_cast<int>(i);
    }

    std::size_t run() {
        const std::size_t most_tries = tries_at_least + complex_.tets.size() / tets_per_try;
        std::set<std::pair<double, int>> seen;
        std::size_t taken = 0, tries = 0, looks = 0;
        for (bool gained = true; std::exchange(gained, false);)
            for (const auto& candidate : rank()) {
                const auto& [value, tet] = candidate;
                if (complex_.tets[tet][0] < 0 || unforced_flatness(complex_, complex_.tets[tet]) != -value) continue;
                if (!seen.insert(candidate).second) continue;
                if (looks++ == looks_per_try * most_tries) return taken;
                const std::vector<int> around = tets_around(tet);
                if (around.size() > most_tets || count_bad(around) > most_bad_tets || has_needle(around)) continue;
                if (tries++ == most_tries) return taken;
                context_.progress(static_cast<double>(tries) / static_cast<double>(most_tries));
                if (mend(cut_out(around))) ++taken, gained = true;
            }
        return taken;
    }

  private:
    std::vector<std::pair<double, int>> rank() const {
        std::vector<std::pair<double, int>> ranked;
        for (int t = 0; t < static_cast<int>(complex_.tets.size()); ++t) {
            if (complex_.tets[t][0] < 0) continue;
            const double value = unforced_flatness(complex_, complex_.tets[t]);
            if (value > target_ && !is_forced(complex_, t, value)) ranked.emplace_back(-value, t);
        }
        std::sort(ranked.begin(), ranked.end());
        return ranked;
    }

    std::size_t count_bad(std::span<const int> tets) const {
        return static_cast<std::size_t>(std::count_if(
            tets.begin(), tets.end(), [&](int t) { return unforced_flatness(complex_, complex_.tets[t]) > target_; }));
    }

    /// What helps a needle, or a tet that hardly has a volume, harms all others.
    bool has_needle(std::span<const int> tets) const {
        return std::any_of(tets.begin(), tets.end(), [&](int t) {
            const auto& [a, b, c, d] = complex_.tets[t];
            const auto& p = complex_.points;
            return thickness(complex_, complex_.tets[t], options_.least_volume) < 1 ||
                   unforced_flatness(complex_, complex_.tets[t]) < flatness(p[a], p[b], p[c], p[d]);
        });
    }

    bool mend(const Patch& original) {
        std::optional<Patch> best;
        double least = 1 - least_gain_of_burden;
        const auto consider = [&](Patch trial) {
            settle(trial);
            const Rating before = rate_what_differs(original, trial), after = rate_what_differs(trial, original);
            if (after.worst > before.worst || after.burden >= least * before.burden || after.is_thin ||
                after.between_walls > before.between_walls)
                return;
            least = after.burden / before.burden;
            best = std::move(trial);
        };
        consider(original);
        for (const int corner : original.complex.tets[0]) {
            if (least == 0) break;
            Patch trial = original;
            if (move_for_tet(trial.complex, trial.vertices, corner, 0, projector_, options_, context_))
                consider(std::move(trial));
        }
        if (!best) return false;
        shape(best->complex);
        put_back(*best);
        return true;
    }

    void settle(Patch& patch) const {
        RunContext alone;
        alone.end_with(context_);
        remove_slivers(patch.complex, slivers_, alone);
        if (!move_on_boundary(patch.complex, patch.vertices, projector_, options_, alone).empty())
            remove_slivers(patch.complex, slivers_, alone);
    }

    /// Better angles tend to cost mean shape.
    void shape(TetComplex& complex) const {
        RunContext alone;
        alone.end_with(context_);
        ShapeOptions shapes;
        shapes.target_dihedral_deg = options_.target_dihedral_deg;
        for (std::size_t v = 0; v < complex.points.size(); ++v) shapes.among.push_back(static_cast<int>(v));
        optimise_shapes(complex, shapes, alone);
    }

    /// Of the tets of one that the other does not have.
    Rating rate_what_differs(const Patch& one, const Patch& other) const {
        const TetComplex &of = one.complex, &from = other.complex;
        std::vector<Tet> same;
        for (const Tet& tet : from.tets)
            if (tet[0] >= 0 && std::all_of(tet.begin(), tet.end(), [&](int v) {
                    return v < static_cast<int>(of.points.size()) && from.points[v] == of.points[v];
                }))
                same.push_back(sorted(tet));
        std::sort(same.begin(), same.end());
        Rating rating;
        for (const Tet& tet : of.tets) {
            if (tet[0] < 0 || std::binary_search(same.begin(), same.end(), sorted(tet))) continue;
            const double value = unforced_flatness(of, tet);
            rating.worst = std::max(rating.worst, value);
            if (value > target_) rating.burden += 1 / std::max(1e-6, 1 - value) - 1 / (1 - target_);
            rating.is_thin = rating.is_thin || thickness(of, tet, options_.least_volume) < 1;
            rating.between_walls += std::all_of(tet.begin(), tet.end(), [&](int v) {
                return v < static_cast<int>(one.is_outer.size()) && one.is_outer[static_cast<std::size_t>(v)] != 0;
            });
        }
        return rating;
    }

    /// With the tet first; all of them are marked.
    std::vector<int> tets_around(int tet) {
        std::vector<int> found{tet}, corners;
        editor_.begin_marks();
        editor_.mark(tet);
        for (int ring = 0; ring < rings_of_patch; ++ring) {
            for (const int t : found) corners.insert(corners.end(), complex_.tets[t].begin(), complex_.tets[t].end());
            std::sort(corners.begin(), corners.end());
            corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
            const auto is_near = [&](const Tet& t) {
                return std::any_of(t.begin(), t.end(),
                                   [&](int v) { return std::binary_search(corners.begin(), corners.end(), v); });
            };
            for (std::size_t i = 0; i < found.size() && found.size() <= most_tets; ++i)
                for (const int next : complex_.neighbours[found[i]]) {
                    if (next < 0 || editor_.is_marked(next) || !is_near(complex_.tets[next])) continue;
                    editor_.mark(next);
                    found.push_back(next);
                }
        }
        return found;
    }

    /// The tets that are marked.
    Patch cut_out(const std::vector<int>& tets) {
        Patch patch;
        patch.tets = tets;
        auto& points = patch.points;
        for (const int t : patch.tets) points.insert(points.end(), complex_.tets[t].begin(), complex_.tets[t].end());
        std::sort(points.begin(), points.end());
        points.erase(std::unique(points.begin(), points.end()), points.end());
        TetComplex& copy = patch.complex;
        copy.excuses_needles = complex_.excuses_needles;
        for (const int v : points) {
            copy.points.push_back(complex_.points[v]);
            copy.is_fixed.push_back(complex_.is_fixed[v]);
            patch.is_outer.push_back(complex_.is_fixed[v] == 1);
        }
        for (const int t : patch.tets) {
            Tet corners = complex_.tets[t];
            for (int& v : corners)
                v = static_cast<int>(std::lower_bound(points.begin(), points.end(), v) - points.begin());
            copy.tets.push_back(corners);
        }
        copy.regions.assign(patch.tets.size(), 0);  // there is none but the tet's: others are no neighbours
        connect(copy);
        fix_rim(patch);
        return patch;
    }

    /// What other tets touch stays; of the vertices that may move the others are listed.
    void fix_rim(Patch& patch) const {
        std::vector<char> is_rim(patch.points.size(), 0);
        for (std::size_t i = 0; i < patch.tets.size(); ++i)
            for (int face = 0; face < 4; ++face) {
                const int next = complex_.neighbours[patch.tets[i]][face];
                if (next < 0 || editor_.is_marked(next)) continue;
                for (const int k : opposite_face[face]) is_rim[patch.complex.tets[i][k]] = 1;
            }
        for (std::size_t v = 0; v < is_rim.size(); ++v) {
            const int place = place_of_[patch.points[v]];
            if (is_rim[v]) patch.complex.is_fixed[v] = 1;
            if (is_rim[v] || place < 0) continue;
            patch.places.push_back(static_cast<std::size_t>(place));
            patch.vertices.push_back(vertices_[patch.places.back()]);
            patch.vertices.back().vertex = static_cast<int>(v);
        }
    }

    /// Tets that have the corners they had stay in their places.
    void put_back(const Patch& patch) {
        std::vector<int> points = patch.points;
        for (std::size_t v = 0; v < points.size(); ++v) complex_.points[points[v]] = patch.complex.points[v];
        for (std::size_t v = points.size(); v < patch.complex.points.size(); ++v) {
            points.push_back(editor_.add_vertex(patch.complex.points[v]));
            place_of_.push_back(-1);
        }
        for (std::size_t i = 0; i < patch.places.size(); ++i)
            vertices_[patch.places[i]].parameters = patch.vertices[i].parameters;
        std::map<Tet, int> gone;
        for (const int t : patch.tets) gone.emplace(sorted(complex_.tets[t]), t);
        std::vector<Tet> added;
        for (Tet tet : patch.complex.tets) {
            if (tet[0] < 0) continue;
            for (int& v : tet) v = points[v];
            if (gone.erase(sorted(tet)) == 0) added.push_back(tet);
        }
        std::vector<int> removed;
        for (const auto& [corners, tet] : gone) removed.push_back(tet);
        if (!removed.empty()) editor_.replace(removed, added);
    }

    TetComplex& complex_;
    std::span<BoundaryVertex> vertices_;
    const Projector& projector_;
    const BoundaryMoveOptions& options_;
    RunContext& context_;
    SliverOptions slivers_;
    double target_;
    CavityEditor editor_;
    std::vector<int> place_of_;  // by vertex, in vertices_; -1 for none
};

}  // namespace

std::size_t take_detours(TetComplex& complex, std::span<BoundaryVertex> vertices, const Projector& projector,
                         const BoundaryMoveOptions& options, RunContext& context) {
    return DetourSearch(complex, vertices, projector, options, context).run();
}

}  // namespace featuremesh

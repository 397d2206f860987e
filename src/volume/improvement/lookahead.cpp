// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <optional>

#include "core/sort_once.h"
#include "volume/improvement/improve.h"
#include "volume/improvement/operations.h"
#include "volume/improvement/star_shape.h"
#include "volume/tets/tet_marks.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

/// A tet is improved together with those that share a vertex with it, and those that do with these.
constexpr int rings_of_patch = 2;
/// Where so many tets meet, or so many are bad, a try would take as long as hundreds elsewhere.
constexpr std::size_t most_tets = 400, most_bad_tets = 20, most_refills_of_patch = 3;

/// Some tets of a mesh as a complex of their own, in which nothing can change that others touch.
struct Patch {
    TetComplex complex;
    std::vector<int> tets, points;  // of the original; those of the complex begin with them
    std::vector<SurfaceVertex> surface;
};

class Lookahead : public Operation {
  public:
    Lookahead(const LocalMesh& mesh, const Objective& objective, const RunContext& context,
              std::unique_ptr<Projector> own = {})
        : mesh_(mesh),
          complex_(mesh.complex()),
          objective_(objective),
          context_(context),
          own_projector_(std::move(own)),
          projector_(own_projector_ ? own_projector_.get() : mesh.surface().projector) {}

    std::string_view name() const override { return "lookahead"; }
    bool is_dear() const override { return true; }

    std::unique_ptr<Operation> for_another_thread() const override {
        return std::make_unique<Lookahead>(mesh_, objective_, context_,
                                           projector_ ? std::make_unique<Projector>(projector_->another()) : nullptr);
    }

    bool plan(int tet, Change& change, Footprint& footprint) override {
        const std::vector<int> around = tets_around(tet, footprint);
        if (around.empty()) return false;
        change.was_dear = true;
        const Patch original = cut_out(around);
        set_objectives(original.points);
        std::optional<Patch> best;
        change.price = price_of_lookahead;
        const auto consider = [&](Patch trial) {
            improve_patch(trial);
            const Value before = value_of_what_differs(original, trial), after = value_of_what_differs(trial, original);
            if (!objective_.is_better(before, after, change.price) ||
                (best && after.penalty * change.before.penalty >= change.after.penalty * before.penalty))
                return;
            change.before = before, change.after = after;
            best = std::move(trial);
        };
        consider(original);
        for (const int corner : original.complex.tets[0]) {
            if (best && change.after.penalty == 0) break;
            Patch trial = original;
            if (move_for_tet(trial, corner)) consider(std::move(trial));
        }
        if (!best) return false;
        round_shapes(*best);
        describe(*best, change);
        return true;
    }

  private:
    bool is_bad(int tet) const { return objective_.flaw(complex_, complex_.tets[tet]) > objective_.target(); }

    /// The objective for a copy with these vertices of the mesh.
    void set_objectives(const std::vector<int>& points) {
        ObjectiveOptions options = objective_.options();
        if (options.is_barred)
            options.is_barred = [this, points](Tet tet) {
                const int count = static_cast<int>(points.size());
                if (std::any_of(tet.begin(), tet.end(), [&](int v) { return v >= count; })) return false;
                for (int& v : tet) v = points[v];
                return objective_.is_barred(tet);
            };
        in_patch_ = Objective(options);
        options.poor_shape = 1;
        shapes_in_patch_ = Objective(options);
    }

    /// Calls work(mesh, context) on the copy.
    template <class Work>
    void work_on(Patch& patch, const Work& work) const {
        RunContext alone;
        alone.end_with(context_);
        LocalMesh mesh(patch.complex, {std::move(patch.surface), projector_, mesh_.surface().is_for_curved_tets});
        work(mesh, alone);
        patch.surface = mesh.release_surface();
    }

    /// The same loop on the copy.
    void improve_patch(Patch& patch) const {
        work_on(patch, [&](LocalMesh& mesh, RunContext& context) {
            improve(mesh, in_patch_,
                    list_of(edge_ring(mesh, in_patch_), vertex_move(mesh, in_patch_),
                            cone_refill(mesh, in_patch_, {.is_last_resort = true})),
                    {}, {.dear_plans = most_refills_of_patch}, context);
        });
    }

    /// Better angles tend to cost mean shape.
    void round_shapes(Patch& patch) const {
        work_on(patch, [&](LocalMesh& mesh, RunContext& context) {
            improve(mesh, shapes_in_patch_, list_of(vertex_move(mesh, shapes_in_patch_)), {}, {.passes = 3}, context);
        });
    }

    /// Moves a corner of the patch's first tet to where this tet is good, or nearer to that, whatever it does to the
    /// angles of the others; none is turned over.
    bool move_for_tet(Patch& patch, int corner) const {
        Change change;
        work_on(patch, [&](LocalMesh& mesh, RunContext&) {
            if (plan_move_for_tet(mesh, corner, change)) mesh.apply(change);
        });
        return !change.moves.empty();
    }

    bool plan_move_for_tet(const LocalMesh& mesh, int corner, Change& change) const {
        LocalMesh::Star star;
        if (!mesh.gather(corner, star) || mesh.is_held(corner, star)) return false;
        StarShape alone(in_patch_), all(in_patch_);
        alone.gather(mesh.complex(), std::array{0}, corner);
        all.gather(mesh.complex(), star.tets, corner);
        const Vec3 start = mesh.complex().points[corner];
        const double wanted = Objective::improved(alone.worst(start), price_of_lookahead.angle);
        Vec3 aim = start;
        alone.climb(aim, in_patch_.target(), mesh.ways_from(corner, star, projector_),
                    [&](const Vec3& trial) { return mesh.keeps_triangles(star, trial); });
        for (const double share : {1.0, 0.75, 0.5, 0.25}) {
            const auto there = mesh.place_near(corner, start + share * (aim - start), projector_);
            if (!there || alone.worst(there->place) >= wanted || all.worst(there->place) >= inverted_flatness ||
                !mesh.keeps_triangles(star, there->place) || !mesh.keeps_volume(corner, star, there->place) ||
                !mesh.stays_within(*there, projector_))
                continue;
            change.moves.push_back(*there);
            return true;
        }
        return false;
    }

    /// Of the tets of one that the other does not have.
    Value value_of_what_differs(const Patch& one, const Patch& other) const {
        const TetComplex &of = one.complex, &from = other.complex;
        std::vector<Tet> same, different;
        for (const Tet& tet : from.tets)
            if (tet[0] >= 0 && std::all_of(tet.begin(), tet.end(), [&](int v) {
                    return v < static_cast<int>(of.points.size()) && from.points[v] == of.points[v];
                }))
                same.push_back(sorted(tet));
        std::sort(same.begin(), same.end());
        for (const Tet& tet : of.tets)
            if (tet[0] >= 0 && !std::binary_search(same.begin(), same.end(), sorted(tet))) different.push_back(tet);
        return in_patch_.value(of, different);
    }

    /// With the tet first; all of them are marked. None where they are too many, or too many of them are bad.
    std::vector<int> tets_around(int tet, Footprint& footprint) {
        std::vector<int> found{tet}, corners;
        std::size_t bad = is_bad(tet);
        marks_.begin(complex_.tets.size());
        marks_.mark(tet);
        footprint.add(tet);
        for (int ring = 0; ring < rings_of_patch; ++ring) {
            for (const int t : found) corners.insert(corners.end(), complex_.tets[t].begin(), complex_.tets[t].end());
            sort_once(corners);
            const auto is_near = [&](const Tet& t) {
                return std::any_of(t.begin(), t.end(),
                                   [&](int v) { return std::binary_search(corners.begin(), corners.end(), v); });
            };
            for (std::size_t i = 0; i < found.size(); ++i)
                for (const int next : complex_.neighbours[found[i]]) {
                    if (next < 0 || marks_.is_marked(next)) continue;
                    footprint.add(next);
                    if (!is_near(complex_.tets[next])) continue;
                    marks_.mark(next);
                    found.push_back(next);
                    bad += is_bad(next);
                    if (found.size() > most_tets || bad > most_bad_tets) return {};
                }
        }
        return found;
    }

    /// The tets that are marked.
    Patch cut_out(const std::vector<int>& tets) {
        Patch patch;
        patch.tets = tets;
        auto& points = patch.points;
        for (const int t : tets) points.insert(points.end(), complex_.tets[t].begin(), complex_.tets[t].end());
        sort_once(points);
        TetComplex& copy = patch.complex;
        for (const int v : points) {
            copy.points.push_back(complex_.points[v]);
            copy.mobility.push_back(complex_.mobility[v]);
        }
        for (const int t : tets) {
            Tet corners = complex_.tets[t];
            for (int& v : corners)
                v = static_cast<int>(std::lower_bound(points.begin(), points.end(), v) - points.begin());
            copy.tets.push_back(corners);
        }
        copy.regions.assign(tets.size(), 0);  // there is none but the tet's: others are no neighbours
        connect(copy);
        for (std::size_t i = 0; i < tets.size(); ++i)  // what other tets touch stays
            for (int face = 0; face < 4; ++face) {
                const int next = complex_.neighbours[tets[i]][face];
                if (next < 0 || marks_.is_marked(next)) continue;
                for (const int k : opposite_face[face]) copy.mobility[copy.tets[i][k]] = Mobility::fixed;
            }
        for (std::size_t v = 0; v < points.size(); ++v)
            if (const SurfaceVertex* of = mesh_.surface_vertex(points[v]); of && copy.mobility[v] != Mobility::fixed)
                patch.surface.push_back(
                    {static_cast<int>(v), of->on, of->parameters, of->is_kept && !mesh_.has_moved(points[v])});
        return patch;
    }

    /// Tets that have the corners they had stay in their places.
    void describe(const Patch& patch, Change& change) const {
        std::vector<int> points = patch.points;
        std::vector<char> has_moved(patch.complex.points.size(), 0);
        std::vector<std::array<double, 2>> parameters(points.size());
        for (const SurfaceVertex& of : patch.surface) parameters[of.vertex] = of.parameters;
        for (int v = 0; v < static_cast<int>(points.size()); ++v) {
            if (patch.complex.points[v] == complex_.points[points[v]]) continue;
            change.moves.push_back({points[v], patch.complex.points[v], parameters[v]});
            has_moved[v] = 1;
        }
        for (std::size_t v = points.size(); v < patch.complex.points.size(); ++v) {
            points.push_back(static_cast<int>(complex_.points.size() + change.points.size()));
            change.points.push_back(patch.complex.points[v]);
        }
        std::map<Tet, int> gone;
        for (const int t : patch.tets) gone.emplace(sorted(complex_.tets[t]), t);
        for (const Tet& corners : patch.complex.tets) {
            if (corners[0] < 0) continue;
            Tet tet = corners;
            for (int& v : tet) v = points[v];
            const auto same = gone.find(sorted(tet));
            if (same == gone.end()) {
                change.added.push_back(tet);
                continue;
            }
            if (std::any_of(corners.begin(), corners.end(), [&](int v) { return has_moved[v] != 0; }))
                change.bent.push_back(same->second);
            gone.erase(same);
        }
        for (const auto& [corners, tet] : gone) change.removed.push_back(tet);
    }

    const LocalMesh& mesh_;
    const TetComplex& complex_;
    const Objective& objective_;
    Objective in_patch_, shapes_in_patch_;
    const RunContext& context_;
    std::unique_ptr<Projector> own_projector_;  // of another thread's
    const Projector* projector_;
    TetMarks marks_;
};

}  // namespace

std::unique_ptr<Operation> lookahead(LocalMesh& mesh, const Objective& objective, const RunContext& context) {
    return std::make_unique<Lookahead>(mesh, objective, context);
}

}  // namespace featuremesh

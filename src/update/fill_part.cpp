// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/fill_part.h"

#include <optional>
#include <set>
#include <utility>

#include "core/dimension.h"
#include "core/errors.h"
#include "core/messages.h"
#include "core/sort_once.h"
#include "mesh/second_order.h"
#include "mesh/side_table.h"
#include "mesh/tets_at_nodes.h"
#include "surface/merged_entities.h"
#include "surface/turned_triangles.h"
#include "update/our_errors.h"
#include "update/shell_division.h"
#include "volume/curved/mid_side_nodes.h"
#include "volume/curved/straight_sides.h"
#include "volume/obstacle.h"

namespace featuremesh {

namespace {

/// What came of one filling: a mesh, or why there is none. A mesh, too, may ask for other lengths, to get better.
struct Attempt {
    std::optional<Filled> filled;
    std::optional<Filled> stand_in;  ///< refused as folded: the same mesh with straight sides there
    double smallest_jacobian = 1;    ///< as in Filled
    Message refusal;
    SizeRequest request;
    bool has_narrow_faces = false;  ///< whose edges may be divided in another way
    bool may_be_halved = false;     ///< in pieces half as long, too
};

/// Marks the nodes around which something is new or gone; none when nothing was kept. The tets at them are those at the
/// rim and the new ones, as long as none at the rim was released.
void mark_unproven(const Mesh& mesh, Kept kept, std::size_t first_new_tet,
                   const std::vector<std::array<NodeId, 4>>& released, Expectation& expected) {
    if (kept.is_rim.empty()) return;
    std::vector<char>& unproven = expected.is_unproven = std::move(kept.is_rim);
    unproven.resize(mesh.points.size(), 1);
    bool is_wider = mesh.order == 2 || !released.empty();
    for (std::size_t t = first_new_tet; t < mesh.tets.size(); ++t)
        for (const NodeId n : mesh.tets[t]) is_wider |= !unproven[n.index()], unproven[n.index()] = 1;
    for (const auto& tet : released)
        for (const NodeId n : tet) unproven[n.index()] = 1;
    if (is_wider) return;
    expected.unproven_tets = std::move(kept.rim_tets);
    for (std::size_t t = first_new_tet; t < mesh.tets.size(); ++t) expected.unproven_tets.emplace_back(t);
}

/// With segments that are no triangle's side.
std::vector<Entity> edges_beside_nothing(const Mesh& mesh) {
    SideTable sides(mesh.corner_count);
    for (const auto& [a, b, c] : mesh.triangles) sides.value(a, b) = sides.value(b, c) = sides.value(c, a) = 1;
    std::vector<Entity> edges;
    for (std::size_t s = 0; s < mesh.segments.size(); ++s)
        if (sides.find(mesh.segments[s][0], mesh.segments[s][1]) != 1)
            edges.push_back(entity_of(mesh.segment_edges[s]));
    sort_once(edges);
    return edges;
}

Message why_not_valid(const Mesh& mesh, const std::vector<Message>& broken) {
    if (broken.size() > 1) return say<Code::mesh_not_valid_more>(broken.front(), broken.size() - 1);
    if (broken.front().code() != Code::segment_beside_triangles) return say<Code::mesh_not_valid>(broken.front());
    return say<Code::edges_beside_nothing>(edges_beside_nothing(mesh));
}

/// Triangles that lie the wrong way round are no mesh, and ask for shorter edges.
void refuse_turned(const Brep& brep, const Mesh& mesh, const std::vector<char>& is_unproven, Attempt& attempt,
                   RunContext& context) {
    const std::vector<TriangleId> turned = turned_triangles(brep, mesh, is_unproven, context);
    if (turned.empty()) return;
    attempt.request = for_triangles(mesh, turned, SizeReason::cannot_follow);
    attempt.refusal = turned_over(mesh, turned);
}

/// Asks for other lengths where that may help; says what is wrong where the mesh is not valid.
void validate(const Mesh& mesh, const Brep& brep, Kept kept, std::size_t first_new_tet,
              const std::vector<std::array<NodeId, 4>>& released, Attempt& attempt, RunContext& context) {
    RunContext::Step step(context, "validate");
    Expectation expected = expectation_of(brep);
    mark_unproven(mesh, std::move(kept), first_new_tet, released, expected);
    const std::vector<Message> broken = broken_invariants(mesh, expected, context);
    if (broken.size() == 1)
        if (const std::vector<SolidId> off = solids_off_volume(mesh, brep, expected.volume_tolerance); !off.empty())
            attempt.request = for_volume_of(mesh, brep, off.front());
    if (!broken.empty())
        attempt.refusal = why_not_valid(mesh, broken);
    else
        refuse_turned(brep, mesh, expected.is_unproven, attempt, context);
}

/// Nodes of new triangles belong to it, too.
void widen_rim(const Mesh& mesh, std::size_t kept_triangles, Kept& kept) {
    const std::size_t kept_nodes = kept.is_rim.size();
    kept.is_rim.resize(mesh.node_count(), 1);
    bool is_wider = false;
    for (std::size_t t = kept_triangles; t < mesh.triangles.size(); ++t)
        for (const NodeId n : mesh.triangles[t]) {
            char& is_rim = kept.is_rim[n.index()];
            is_wider |= n.index() < kept_nodes && !is_rim;
            is_rim = 1;
        }
    if (is_wider) kept.rim_tets = tets_at_nodes(mesh, kept.is_rim);
}

Filled filled_of(Mesh mesh, const SurfaceReport& surface, VolumeResult volume) {
    return {.mesh = std::move(mesh),
            .surface = surface,
            .volume = std::move(volume.report),
            .released = std::move(volume.released),
            .moved = std::move(volume.moved),
            .used_active = std::move(volume.used_active)};
}

/// Better than no mesh, where that is valid; with a warning, since FreeCAD finds the nodes of a face by their distance.
std::optional<Filled> with_straight_sides(const Brep& brep, StraightSides straightened, const SurfaceReport& surface,
                                          const VolumeResult& volume, const Message& why, RunContext& context) {
    if (straightened.mesh.points.empty()) return {};
    Attempt check;
    validate(straightened.mesh, brep, {}, 0, {}, check, context);
    if (!check.refusal.empty()) return {};
    Filled filled = filled_of(std::move(straightened.mesh), surface, volume);
    filled.why_straight = why;
    filled.straight_sides = straightened.sides;
    filled.surface.warnings.push_back(
        say<Code::sides_stay_straight>(straightened.sides, straightened.places, Length{straightened.distance}));
    return filled;
}

/// Of shells that bend: asks for shorter edges at 6-node triangles that are folded or nearly so; those that are kept,
/// in front, stay. Which are folded: with any the mesh is refused.
std::vector<TriangleId> ask_for_bent_shells(const Brep& brep, const Mesh& mesh, std::size_t kept, Attempt& attempt) {
    constexpr double wanted_scaled_jacobian = 0.2;
    const std::vector<TriangleId> bent = shell_triangles_below(brep, mesh, kept, wanted_scaled_jacobian);
    if (bent.empty()) return {};
    attempt.request = for_triangles(mesh, bent, SizeReason::folded);
    std::vector<TriangleId> folded;
    for (const TriangleId t : bent) {
        const double jacobian = min_scaled_jacobian(triangle_nodes(mesh, t));
        attempt.smallest_jacobian = std::min(attempt.smallest_jacobian, jacobian);
        if (!(jacobian > 0)) folded.push_back(t);
    }
    if (!folded.empty()) attempt.refusal = say<Code::triangles_folded>(bent.size(), attempt.request.place);
    return folded;
}

/// Where 10-node tetrahedra stay folded there is no mesh, and shorter edges are asked for there.
void fill_volume(const Brep& brep, const SizingField& sizing, SurfaceResult surface, Kept kept,
                 const MeshOptions& options, Attempt& attempt, RunContext& context) {
    const std::size_t kept_tets = surface.mesh.tets.size();
    if (!kept.is_rim.empty()) widen_rim(surface.mesh, surface.kept.triangles, kept);
    VolumeOptions volume_options = options.volume;
    volume_options.is_for_curved_tets = options.order == 2;
    volume_options.splits_wall_tets |= options.sizing.elements_across_gap >= elements_that_bend;
    const bool has_shells = brep.has_free_faces() || brep.has_free_edges();
    std::vector<std::array<NodeId, 2>> segments;
    if (brep.has_free_faces()) segments = surface.mesh.segments;
    auto tried = try_fill_solids(brep, sizing, std::move(surface.mesh), kept.active, volume_options, context,
                                 {kept.is_rim, kept.rim_tets, surface.kept.nodes});
    if (auto* obstacle = std::get_if<Obstacle>(&tried)) {
        attempt.refusal = std::move(obstacle->message);
        const bool is_thin = attempt.refusal.code() == Code::thin_elements_remain;
        attempt.request = {is_thin ? SizeReason::thin : SizeReason::boundary, std::move(obstacle->place),
                           std::move(obstacle->shorter)};
        return;
    }
    VolumeResult volume = std::get<VolumeResult>(std::move(tried));
    Mesh mesh = std::move(volume.mesh);
    mesh.corner_count = mesh.node_count();
    divide_shells(brep, segments, mesh);
    if (options.order == 2) {
        SecondOrder second = try_second_order(brep, std::move(mesh), kept.curved.get(), context);
        attempt.smallest_jacobian = second.smallest;
        attempt.request = {SizeReason::folded, std::move(second.place), std::move(second.shorter)};
        if (!second.is_valid()) {
            attempt.refusal = say<Code::tets_folded>(attempt.request.lengths.size(), attempt.request.place);
            attempt.stand_in =
                with_straight_sides(brep, std::move(second.straight), surface.report, volume, attempt.refusal, context);
            return;
        }
        mesh = std::move(second.mesh);
        if (auto folded = ask_for_bent_shells(brep, mesh, surface.kept.triangles, attempt); !folded.empty()) {
            if (kept.curved) return;
            StraightSides straight = straighten(brep, std::move(mesh), {{}, std::move(folded)}, context);
            attempt.stand_in =
                with_straight_sides(brep, std::move(straight), surface.report, volume, attempt.refusal, context);
            return;
        }
    }
    if (has_shells) kept.is_rim.clear();  // everything is checked: tets tell nothing about what is beside them
    validate(mesh, brep, std::move(kept), kept_tets - volume.released.size(), volume.released_nodes, attempt, context);
    if (!attempt.refusal.empty()) return;
    attempt.filled = filled_of(std::move(mesh), surface.report, std::move(volume));
}

/// Of a part of faces or edges: here the filling ends.
void take_surface(const Brep& brep, const SizingField&, SurfaceResult surface, Kept kept, const MeshOptions& options,
                  Attempt& attempt, RunContext& context) {
    Mesh mesh = std::move(surface.mesh);
    mesh.corner_count = mesh.node_count();
    if (options.order == 2) {
        mesh = curved_without_tets(brep, std::move(mesh), kept.curved.get(), context);
        if (auto folded = ask_for_bent_shells(brep, mesh, surface.kept.triangles, attempt); !folded.empty()) {
            if (kept.curved) return;
            StraightSides straight = straighten(brep, std::move(mesh), {{}, std::move(folded)}, context);
            attempt.stand_in =
                with_straight_sides(brep, std::move(straight), surface.report, {}, attempt.refusal, context);
            return;
        }
    }
    if (brep.dimension() == Dimension::faces ? mesh.triangles.empty() : mesh.segments.empty()) {
        attempt.refusal = say<Code::all_is_ignored>();
        return;
    }
    kept.is_rim.clear();  // everything is checked: without tets that is little
    validate(mesh, brep, std::move(kept), 0, {}, attempt, context);
    if (!attempt.refusal.empty()) return;
    attempt.filled = Filled{.mesh = std::move(mesh), .surface = std::move(surface.report)};
}

/// What stages throw becomes a value: each says what, where and what to try.
template <class Function>
void note_refusal(Attempt& attempt, Function work) {
    try {
        with_our_errors(work);
    } catch (const Cancelled&) {
        throw;
    } catch (const InputError&) {
        throw;
    } catch (const Error& failure) {
        if (is_of_machine(failure)) throw;
        attempt.refusal = failure.message;
    }
}

/// Fills again with other lengths as long as that may help.
class SizeLoop {
  public:
    SizeLoop(const Brep& brep, const SizingField& sizing, Kept kept, MeshOptions options,
             std::span<const SizeSource> sources, std::vector<Round>& rounds, bool all_may_ask, RunContext& context)
        : brep_(brep),
          plain_(sizing),
          field_(sizing),
          kept_(std::move(kept)),
          options_(std::move(options)),
          sources_(sources.begin(), sources.end()),
          rounds_(rounds),
          only_folded_ask_(keeps_ && !all_may_ask),
          context_(context) {
        options_.volume.smallest_asked = std::max(options_.volume.smallest_asked, sizing.smallest());
    }

    std::variant<Filled, Message> run() {
        for (;;) {
            Attempt attempt = try_once();
            if (attempt.filled) offer(attempt);
            if (attempt.stand_in) offer_stand_in(attempt);
            if (is_good_enough(attempt) || !may_go_on() || !change_something(attempt)) return outcome(attempt);
        }
    }

  private:
    bool may_go_on() const {
        const std::size_t own = rounds_.size() - first_round_;
        return !is_spent_ && rounds_.size() < most_rounds && (!keeps_ || own < most_rounds_that_keep) &&
               rounds_in_vain_ < most_rounds_in_vain;
    }

    Attempt try_once() {
        context_.check_cancelled();
        Attempt attempt;
        note_refusal(attempt, [&] {
            // where no second filling can follow, the kept mesh is moved instead of copied
            const bool may_be_last = is_spent_ = only_folded_ask_ && options_.order == 1;
            SurfaceResult surface = fill_surface(brep_, field_, may_be_last ? std::move(kept_.mesh) : kept_.mesh,
                                                 context_, {.known = merged_.get(), .narrow = narrow_});
            attempt.has_narrow_faces = surface.report.has_opposite_nodes;
            attempt.may_be_halved = surface.report.may_be_halved;
            is_spent_ = may_be_last && !may_divide_otherwise(attempt);
            if (may_be_last && !is_spent_) kept_.mesh = taken_back(surface);
            std::vector<char> is_unproven = kept_.is_rim;
            if (!is_unproven.empty()) is_unproven.resize(surface.mesh.points.size(), 1);
            refuse_turned(brep_, surface.mesh, is_unproven, attempt, context_);  // before tets are made in vain
            if (!attempt.refusal.empty()) return;
            const auto finish = brep_.dimension() == Dimension::solids ? fill_volume : take_surface;
            finish(brep_, field_, std::move(surface), is_spent_ ? std::move(kept_) : kept_, options_, attempt,
                   context_);
        });
        return attempt;
    }

    /// Of the fillings whose 10-node tetrahedra are valid the better one counts.
    void offer(Attempt& attempt) {
        ++valid_;
        if (!best_ || attempt.smallest_jacobian > best_->smallest_jacobian) take(attempt);
    }

    void take(Attempt& attempt) {
        best_ = std::move(attempt.filled);
        best_->shorter = shorter_;
        best_->smallest_jacobian = attempt.smallest_jacobian;
        for (const std::vector<Entity>& place : places_)
            best_->surface.warnings.push_back(say<Code::finer_to_follow>(place));
        const bool has_tets = brep_.dimension() == Dimension::solids;
        for (const std::vector<Entity>& place : folded_places_)
            best_->surface.warnings.push_back(has_tets ? say<Code::finer_for_curved_tets>(place)
                                                       : say<Code::finer_for_curved_triangles>(place));
        if (const KeptStraightSides& kept = kept_.straight; kept.sides > 0) {
            best_->why_straight = say<Code::sides_stay_straight>(kept.sides, kept.places, Length{kept.distance});
            best_->surface.warnings.push_back(best_->why_straight);
        }
        if (!why_plain_.empty()) best_->surface.warnings.push_back(say<Code::narrow_faces_plain>(why_plain_));
    }

    /// The first filling counts, as it has the lengths that were asked for. Rounds that do not halve the straight sides
    /// are in vain, and none follows one that leaves more of them.
    void offer_stand_in(Attempt& attempt) {
        const std::size_t sides = attempt.stand_in->straight_sides;
        const bool gains = !stand_in_ || 2 * sides <= fewest_straight_, loses = stand_in_ && sides > fewest_straight_;
        rounds_in_vain_ = gains ? 0 : loses ? most_rounds_in_vain : rounds_in_vain_ + 1;
        if (gains) fewest_straight_ = sides;
        if (!stand_in_) stand_in_ = std::move(attempt.stand_in);
    }

    bool is_good_enough(const Attempt& attempt) const {
        constexpr int most_valid = 3;
        return best_ && (valid_ == most_valid || (attempt.refusal.empty() && attempt.request.is_empty()));
    }

    /// What to do about it, the first that can be done; false when nothing is left.
    bool change_something(const Attempt& attempt) {
        const bool is_refused = !attempt.refusal.empty();
        return (is_refused && divide_narrow_faces_otherwise(attempt)) || ask_for_shorter(attempt) ||
               (is_refused && !best_ && (change_last_lengths(attempt) || leave_narrow_faces_coarse(attempt)));
    }

    void note(const Attempt& attempt, std::string reason, const std::vector<Entity>& place, std::string change) {
        rounds_.push_back({std::move(reason), place, std::move(change), attempt.refusal});
    }

    /// Where tets cannot meet the triangles of a narrow face whose edges have nodes opposite one another, other chains
    /// of nodes on these edges may succeed.
    bool may_divide_otherwise(const Attempt& attempt) const {
        return attempt.has_narrow_faces && narrow_ != NarrowFaces::own_chains;
    }
    bool divide_narrow_faces_otherwise(const Attempt& attempt) {
        if (!may_divide_otherwise(attempt)) return false;
        narrow_ = attempt.may_be_halved ? NarrowFaces::shorter : NarrowFaces::own_chains;
        note(attempt, "narrow faces", {},
             attempt.may_be_halved ? "half the length along them" : "edges divided each by itself");
        return true;
    }

    /// Asks for shorter edges where the mesh is too coarse. An update does so only for folded elements at first; in all
    /// other cases it keeps less of the old mesh before, and in the end nothing.
    bool ask_for_shorter(const Attempt& attempt) {
        const SizeRequest& request = attempt.request;
        const bool is_folded = request.reason == SizeReason::folded;
        if (request.is_empty() || (only_folded_ask_ && !is_folded)) return false;
        if (request.reason == SizeReason::thin && !may_help_thin()) return false;
        first_of_last_ = shorter_.size();
        for (const SizeSource& source : request.lengths) shorter_.push_back(shorter_than_asked(field_, source));
        (is_folded ? folded_places_ : places_).insert(request.place);
        // what is best for straight tets may leave curved ones no room
        if (is_folded) options_.volume.moves_surface_nodes = !best_;
        note(attempt,
             is_folded                                ? "folded"
             : request.reason == SizeReason::boundary ? "boundary"
             : request.reason == SizeReason::thin     ? "thin elements"
                                                      : "cannot follow",
             request.place, "shorter edges there");
        make_field();
        return true;
    }

    /// May shorter edges mend thin elements? Two rounds show it. Those that came with the short edges of 10-node tets
    /// are not mended by still shorter ones.
    bool may_help_thin() {
        constexpr int most_thin_rounds = 2;
        return !stand_in_ && thin_rounds_++ < most_thin_rounds;
    }

    /// With the lengths of the last round it failed in another way.
    bool change_last_lengths(const Attempt& attempt) {
        if (shorter_.empty() || folded_places_.empty() || (stand_in_ && failures_ > 0)) return false;
        const double factor = ++failures_ % 2 == 1 ? 1.5 : 0.4;  // milder first, then stronger
        for (std::size_t i = first_of_last_; i < shorter_.size(); ++i) shorter_[i].size *= factor;
        note(attempt, "folded", *folded_places_.rbegin(),
             factor > 1 ? "less short edges there" : "still shorter edges there");
        make_field();
        return true;
    }

    /// What cannot be meshed with shorter pieces along narrow faces is meshed without them.
    bool leave_narrow_faces_coarse(const Attempt& attempt) {
        if (keeps_ || !options_.sizing.refines_narrow_faces) return false;
        options_.sizing.refines_narrow_faces = false;
        const SizingField coarse = make_sizing(brep_, options_.sizing, sources_, context_);
        if (where_different(coarse, plain_).empty()) return false;
        plain_ = coarse;
        shorter_.clear(), places_.clear(), folded_places_.clear();
        narrow_ = NarrowFaces::opposite_nodes;
        why_plain_ = attempt.refusal;
        note(attempt, "narrow faces", {}, "the plain size along them");
        field_ = plain_;
        options_.volume.smallest_asked = plain_.smallest();
        return true;
    }

    void make_field() {
        std::vector<SizeSource> all = sources_;
        all.insert(all.end(), shorter_.begin(), shorter_.end());
        field_ = with_sources(plain_, all);
    }

    std::variant<Filled, Message> outcome(const Attempt& attempt) {
        if (!best_) best_ = std::move(stand_in_);
        if (!best_) return attempt.refusal;
        best_->sizing = plain_;
        best_->refines_narrow_faces = options_.sizing.refines_narrow_faces;
        best_->merged = merged_;
        return std::move(*best_);
    }

    const Brep& brep_;
    SizingField plain_, field_;  ///< as asked, and with what was asked for since
    Kept kept_;
    const bool keeps_ = !kept_.mesh.points.empty();
    bool is_spent_ = false;  ///< what is kept went into the last filling
    MeshOptions options_;
    const std::shared_ptr<const MergedEntities> merged_ =
        kept_.merged ? kept_.merged : std::make_shared<const MergedEntities>(brep_, options_.ignored_below);
    std::vector<SizeSource> sources_, shorter_;
    std::vector<Round>& rounds_;
    const bool only_folded_ask_;
    RunContext& context_;
    const std::size_t first_round_ = rounds_.size();
    NarrowFaces narrow_ = NarrowFaces::opposite_nodes;
    std::set<std::vector<Entity>> places_, folded_places_;
    Message why_plain_;
    std::size_t first_of_last_ = 0;
    int failures_ = 0, valid_ = 0, thin_rounds_ = 0;
    std::optional<Filled> best_, stand_in_;
    std::size_t fewest_straight_ = 0;  ///< sides, of the last round that gained
    std::size_t rounds_in_vain_ = 0;
};

}  // namespace

Expectation expectation_of(const Brep& brep) {
    Expectation expected;
    expected.dimension = brep.dimension();
    for (std::size_t s = 0; s < brep.solid_count(); ++s) expected.solid_volumes.push_back(brep.volume_of(SolidId(s)));
    expected.solids_beside_face = brep.solids_beside_faces();
    if (brep.has_free_faces())
        for (std::size_t f = 0; f < brep.face_count(); ++f) expected.is_free_face.push_back(brep.is_free(FaceId(f)));
    if (brep.has_free_edges())
        for (std::size_t e = 0; e < brep.edge_count(); ++e) expected.is_free_edge.push_back(brep.is_free(EdgeId(e)));
    // Chords cut curved faces; how much is the judgement of the surface module, so only gross errors count here.
    expected.volume_tolerance = 0.3;
    return expected;
}

Kept nothing_kept(NextNumbers next) {
    Kept nothing;
    nothing.mesh.next_node_number = next.node;
    nothing.mesh.next_element_number = next.element;
    return nothing;
}

std::variant<Filled, Message> fill_part(const Brep& brep, const SizingField& sizing, Kept kept,
                                        const MeshOptions& options, std::span<const SizeSource> sources,
                                        std::vector<Round>& rounds, RunContext& context, bool all_may_ask) {
    return SizeLoop(brep, sizing, std::move(kept), options, sources, rounds, all_may_ask, context).run();
}

}  // namespace featuremesh

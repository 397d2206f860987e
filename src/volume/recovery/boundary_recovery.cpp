// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/boundary_recovery.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/errors.h"
#include "mesh/tets_at_nodes.h"
#include "volume/cavity_refusals.h"
#include "volume/recovery/flip_facets.h"
#include "volume/recovery/flip_recovery.h"
#include "volume/recovery/local_recovery.h"
#include "volume/recovery/relocate_points.h"
#include "volume/recovery/seeds_in_the_way.h"
#include "volume/recovery/tetgen.h"

namespace featuremesh {

namespace {

/// The most rounds of a full mesh and of an update. After more rounds an update that keeps less is cheaper. Those that
/// follow the last release are few: constraints bring back what is missing in each cavity once.
constexpr int most_rounds = 12, most_rounds_of_update = 9;
constexpr int most_halving_rounds = 3;
/// Of triangles that cross others. If more do once their edges are halved the shape crosses itself, whatever the size.
constexpr std::size_t many_crossing = 1000;
constexpr int most_constraining_rounds = 5;  // only around what is missing
/// Kept tets that are not Delaunay may be many: then a cavity that grows by those at its interface would not end in
/// time.
constexpr int most_releasing_rounds = 5;
/// Of the facets: where more are missing, constraints would add points by the thousand. Else they make better tets.
constexpr double many_missing = 0.1;

bool are_many(std::span<const int> missing, const Cavity& cavity) {
    return static_cast<double>(missing.size()) > many_missing * static_cast<double>(cavity.facets.size());
}

/// Flips would take a second and more for as many.
constexpr std::size_t very_many_missing = 1000;

/// All its nodes lie in one plane.
bool is_flat(const CavityFill& fill) { return fill.triangulation.tets.empty(); }

}  // namespace

const std::vector<BoundaryRecovery::Means>& BoundaryRecovery::means_in_order() {
    static const std::vector<Means> means{
        &BoundaryRecovery::keep_whole_fill,     &BoundaryRecovery::release_kept_tets,
        &BoundaryRecovery::refuse_flat_cavity,  &BoundaryRecovery::change_diagonals,
        &BoundaryRecovery::refuse_open_surface, &BoundaryRecovery::halve_crossing,
        &BoundaryRecovery::ask_tetgen_first,    &BoundaryRecovery::flip_if_many,
        &BoundaryRecovery::constrain_locally,   &BoundaryRecovery::constrain,
        &BoundaryRecovery::flip_if_few,         &BoundaryRecovery::ask_tetgen_last,
        &BoundaryRecovery::halve_stuck,
    };
    return means;
}

BoundaryRecovery::BoundaryRecovery(const Brep& brep, const Projector& projector, const WantedSize& size,
                                   std::span<const Vec3> active, const KeptRim& rim, Mesh& mesh, VolumeReport& report,
                                   RunContext& context)
    : is_released(mesh.tets.size(), 0),
      rim_tets(rim.tets.begin(), rim.tets.end()),
      may_be_open(rim.nodes.begin(), rim.nodes.end()),
      brep_(brep),
      projector_(projector),
      size_(size),
      active_(active),
      mesh_(mesh),
      report_(report),
      context_(context) {}

std::optional<Obstacle> BoundaryRecovery::run() {
    for (int round = 0;; ++round) {
        const bool is_full = fill_all(round);
        if (round == 0)
            for (const CavityFill& fill : fills) report_.recovered_triangles += fill.places.missing.size();
        if (is_full && (round >= round_limit() || !flip_flat_tets())) return {};
        if (auto obstacle = mend(round)) return obstacle;
    }
}

/// One round; true when every cavity is full.
bool BoundaryRecovery::fill_all(int round) {
    if (!may_be_open.empty()) may_be_open.resize(mesh_.node_count(), 1);
    if (std::exchange(is_rim_wider_, false)) rim_tets = tets_at_nodes(mesh_, may_be_open);
    if (!may_be_open.empty()) near_ = rim_tets;
    cavities = separate_cavities(find_cavity(mesh_, brep_.solids_beside_faces(), is_released, may_be_open, near_));
    fills.assign(cavities.size(), {});
    parallel_for(context_, cavities.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) fill(i);
    });
    known_.clear();
    finished_.clear();
    outgrown_.clear();
    for (std::size_t i = 0; i < cavities.size(); ++i) {
        if (fills[i].relocated) continue;
        drop_seeds(i, round);
        turn_missing(i, round);
    }
    return std::all_of(fills.begin(), fills.end(), [](const CavityFill& f) { return f.is_complete(); });
}

void BoundaryRecovery::fill(std::size_t i) {
    const Cavity& cavity = cavities[i];
    for (KnownFill& known : finished_)
        if (known.nodes == cavity.nodes) {
            fills[i] = std::move(known.fill);
            return;
        }
    for (KnownTriangulation& known : known_) {
        if (known.nodes != cavity.nodes) continue;
        std::vector<Vec3> points = cavity.points;
        points.insert(points.end(), known.seeds.begin(), known.seeds.end());
        fills[i] = label_cavity(cavity, std::move(points), std::move(known.triangulation), context_);
        if (known.is_best || (fills[i].is_complete() && !has_inverted_tet(fills[i]))) return;
    }
    for (KnownFill& old : outgrown_)
        if (has_grown_from(old, i)) {
            fills[i] = grow_fill(cavity, old.nodes, old.fill, context_);
            return;
        }
    try {
        fills[i] = fill_cavity(cavity, interface_balls(mesh_, cavity, size_), active_, size_, context_);
    } catch (const MeshError&) {
        require_distinct(brep_, mesh_, cavity);  // says it better
        throw;
    }
}

/// Whether the cavity has grown by few nodes since. Nodes whose kept tets are all released are inside it now.
bool BoundaryRecovery::has_grown_from(const KnownFill& old, std::size_t i) const {
    const std::vector<NodeId>& nodes = cavities[i].nodes;
    std::vector<NodeId> inside;
    std::set_difference(old.nodes.begin(), old.nodes.end(), nodes.begin(), nodes.end(), std::back_inserter(inside));
    const std::size_t most = old.fill.places.missing.size();
    return nodes.size() + inside.size() <= old.nodes.size() + most && inside.size() <= most &&
           std::none_of(inside.begin(), inside.end(), [&](NodeId n) {
               return std::any_of(cavities.begin(), cavities.end(), [&](const Cavity& other) {
                   return std::binary_search(other.nodes.begin(), other.nodes.end(), n);
               });
           });
}

/// Some missing triangles come back by turning diagonals of the surface. If seeds alone stand in the way of all others,
/// these seeds are left out.
void BoundaryRecovery::drop_seeds(std::size_t i, int round) {
    const Cavity& cavity = cavities[i];
    CavityFill& fill = fills[i];
    std::vector<int> missing = fill.places.missing;
    if (missing.empty() || are_many(missing, cavity) ||
        std::any_of(missing.begin(), missing.end(), [&](int f) { return cavity.tet_of_facet[f].is_valid(); }))
        return;
    for (const FacetSplit::Piece& piece : flip_missing(cavity, fill, mesh_).pieces) std::erase(missing, piece.facet);
    const std::vector<int> dropped = seeds_in_the_way(cavity, fill, missing);
    if (dropped.empty()) return;
    auto triangulation = triangulation_without(dropped, cavity, fill, context_);
    if (!triangulation) return;
    log("seeds are in the way of triangles", dropped.size());
    std::vector<Vec3> points = std::move(fill.points);
    for (auto seed = dropped.rbegin(); seed != dropped.rend(); ++seed) points.erase(points.begin() + *seed);
    const std::size_t before = fill.places.missing.size();
    fill = label_cavity(cavity, std::move(points), std::move(*triangulation), context_);
    if (round == 0) report_.recovered_triangles += before - std::min(before, fill.places.missing.size());
}

/// Where other diagonals on the CAD faces are all that is missing, the triangulation serves as it is.
void BoundaryRecovery::turn_missing(std::size_t i, int round) {
    Cavity& cavity = cavities[i];
    CavityFill& fill = fills[i];
    const std::vector<int>& missing = fill.places.missing;
    if (missing.empty() ||
        !std::all_of(missing.begin(), missing.end(), [&](int f) { return cavity.triangle_of_facet[f].is_valid(); }))
        return;
    const FacetSplit flips = flip_missing(cavity, fill, mesh_);
    if (flips.pieces.size() != missing.size() || !in_the_way(flips, cavity).empty()) return;
    apply_split(flips, cavity, projector_, brep_.tolerances().on_entity(), mesh_, context_);
    for (const FacetSplit::Piece& piece : flips.pieces) cavity.facets[piece.facet].corners = piece.corners;
    log("diagonals changed", flips.pieces.size() / 2);
    if (round == 0) report_.recovered_triangles += flips.pieces.size();
    label_turned(cavity, fill, context_);
}

/// Whether there was a tet without height to get rid of, so that another round is due.
bool BoundaryRecovery::flip_flat_tets() {
    bool is_changed = false;
    for (std::size_t i = 0; i < cavities.size(); ++i) {
        if (fills[i].relocated) continue;
        const FacetSplit flips = flip_flat(cavities[i], fills[i], mesh_);
        if (flips.pieces.empty()) continue;
        is_changed = true;
        apply(flips, cavities[i]);
    }
    return is_changed;
}

std::optional<Obstacle> BoundaryRecovery::mend(int round) {
    if (round >= round_limit()) return unrecovered(mesh_, cavities, fills);
    for (std::size_t i = 0; i < cavities.size(); ++i)
        if (auto obstacle = recover(i, round)) return obstacle;
    return {};
}

std::optional<Obstacle> BoundaryRecovery::recover(std::size_t i, int round) {
    Gap gap{cavities[i], fills[i], round, seeds_of(cavities[i], fills[i]), fills[i].places.missing, false,
            false,       {},       {}};
    gap.are_many = are_many(gap.stuck, gap.cavity);
    if (!gap.fill.is_complete()) log("triangles are missing", gap.stuck.size());
    for (const Means means : means_in_order())
        if ((this->*means)(gap)) break;
    return std::move(gap.obstacle);
}

bool BoundaryRecovery::keep_whole_fill(Gap& gap) {
    if (gap.fill.relocated)
        finished_.push_back({gap.cavity.nodes, std::move(gap.fill)});
    else if (gap.fill.is_complete())
        known_.push_back({gap.cavity.nodes, std::move(gap.seeds), std::move(gap.fill.triangulation), true});
    else
        return false;
    return true;
}

/// Gives up the kept tets behind interface facets that are missing.
bool BoundaryRecovery::release_kept_tets(Gap& gap) {
    if (gap.round >= most_releasing_rounds && !is_flat(gap.fill)) return false;
    bool is_changed = false;
    for (const int facet : gap.fill.places.missing)
        if (const TetId tet = gap.cavity.tet_of_facet[facet]; tet.is_valid()) release(tet), is_changed = true;
    if (!is_changed) return false;
    if (const FacetSplit flips = flip_missing(gap.cavity, gap.fill, mesh_); !flips.pieces.empty())
        apply(flips, gap.cavity);
    if (gap.fill.delaunay) outgrown_.push_back({gap.cavity.nodes, std::move(gap.fill)});
    return true;
}

bool BoundaryRecovery::refuse_flat_cavity(Gap& gap) {
    if (is_flat(gap.fill)) gap.obstacle = in_one_plane(mesh_, gap.cavity, gap.stuck);
    return gap.obstacle.has_value();
}

bool BoundaryRecovery::change_diagonals(Gap& gap) {
    const FacetSplit flips = flip_missing(gap.cavity, gap.fill, mesh_);
    if (flips.pieces.empty()) return false;
    log("diagonals to change", flips.pieces.size() / 2);
    if (apply(flips, gap.cavity))
        known_.push_back({gap.cavity.nodes, std::move(gap.seeds), std::move(gap.fill.triangulation), true});
    else if (gap.fill.delaunay)
        outgrown_.push_back({gap.cavity.nodes, std::move(gap.fill)});
    return true;
}

bool BoundaryRecovery::refuse_open_surface(Gap& gap) {
    gap.obstacle = if_open(mesh_, gap.cavity);
    return gap.obstacle.has_value();
}

bool BoundaryRecovery::halve_crossing(Gap& gap) {
    const std::vector<int> crossing = crossing_facets(gap.cavity, gap.fill.places.missing);
    if (crossing.empty()) return false;
    log("triangles that cross others", crossing.size());
    Obstacle obstacle = cut_one_another(mesh_, gap.cavity, crossing);
    if (std::exchange(last_crossing_, gap.round) != gap.round) crossing_before_ = std::exchange(crossing_, 0);
    crossing_ += crossing.size();
    if (crossing_before_ > many_crossing && crossing_ > crossing_before_) {
        obstacle.shorter.clear();
        gap.obstacle = std::move(obstacle);
        return true;
    }
    return halve(gap, crossing, std::move(obstacle));
}

bool BoundaryRecovery::flip_if_many(Gap& gap) { return gap.are_many && flip(gap); }

bool BoundaryRecovery::constrain_locally(Gap& gap) {
    if (std::exchange(last_constraining_, gap.round) != gap.round) ++constraining_rounds_;
    if (constraining_rounds_ > most_constraining_rounds) return false;
    auto constrained = recover_locally(gap.cavity, gap.fill, context_);
    return constrained && take(gap, std::move(*constrained));
}

bool BoundaryRecovery::constrain(Gap& gap) {
    return take(gap, constrained_delaunay(gap.cavity, gap.seeds, gap.fill.places.missing.size(), context_));
}

/// Not where more points were added than there were: they would never find room.
bool BoundaryRecovery::take(Gap& gap, ConstrainedTriangulation constrained) {
    constexpr std::size_t spare = 1000;
    if (!constrained.failed.empty()) gap.failed = std::move(constrained.failed);
    const std::size_t added = constrained.split.added.size();
    if (constrained.is_given_up || !gap.failed.empty() || added > gap.cavity.points.size() + spare) return false;
    log("points that constraints added", added);
    relocate(gap, std::move(constrained));
    return true;
}

bool BoundaryRecovery::ask_tetgen_first(Gap& gap) { return gap.stuck.size() > very_many_missing && ask_tetgen(gap); }
bool BoundaryRecovery::ask_tetgen_last(Gap& gap) { return !gap.is_asked && ask_tetgen(gap); }

bool BoundaryRecovery::ask_tetgen(Gap& gap) {
    gap.is_asked = true;
    std::optional<CavityFill> fill = recover_by_tetgen(gap.cavity, gap.seeds, context_);
    if (!fill) return false;
    log("points that TetGen added", fill->relocated->size());
    report_.recovery_points += fill->relocated->size();
    finished_.push_back({gap.cavity.nodes, std::move(*fill)});
    return true;
}

bool BoundaryRecovery::flip_if_few(Gap& gap) { return !gap.are_many && flip(gap); }

bool BoundaryRecovery::halve_stuck(Gap& gap) {
    const std::vector<int>& stuck = gap.failed.empty() ? gap.stuck : gap.failed;
    log("triangles that constraints did not bring back", stuck.size());
    return halve(gap, stuck, unrecovered(mesh_, cavities, fills));
}

/// Brings all missing triangles back by flips, or none. In that case gap.stuck has those that could not be recovered.
bool BoundaryRecovery::flip(Gap& gap) {
    FlippedTriangulation flipped = recover_by_flips(gap.cavity, gap.fill, context_);
    if (flipped.tets) known_.push_back({gap.cavity.nodes, gap.seeds, std::move(*flipped.tets), true});
    gap.stuck = std::move(flipped.left);
    log("triangles that flips did not bring back", gap.stuck.size());
    return gap.stuck.empty();
}

/// The points that constraints added leave the boundary; where they find no room they stay on it.
void BoundaryRecovery::relocate(Gap& gap, ConstrainedTriangulation constrained) {
    const std::size_t added_count = constrained.split.added.size();
    if (auto whole = relocate_points(gap.cavity, constrained, gap.seeds, context_)) {
        report_.recovery_points += added_count;
        finished_.push_back({gap.cavity.nodes, std::move(*whole)});
        return;
    }
    log("points that stay on the boundary", added_count);
    if (const auto added = apply(constrained.split, gap.cavity)) {
        std::vector<NodeId> nodes = gap.cavity.nodes;
        nodes.insert(nodes.end(), added->begin(), added->end());
        known_.push_back({std::move(nodes), std::move(gap.seeds), std::move(constrained.triangulation), false});
    }
}

/// Halves the longest edges of these facets. Rounds of halving are counted once for all cavities; after too many of
/// them the facets are the obstacle.
bool BoundaryRecovery::halve(Gap& gap, std::span<const int> facets, Obstacle obstacle) {
    if (std::exchange(last_halving_, gap.round) != gap.round) ++halving_rounds_;
    if (halving_rounds_ > most_halving_rounds)
        gap.obstacle = std::move(obstacle);
    else
        apply(halve_longest_edges(gap.cavity, facets), gap.cavity);
    return true;
}

std::optional<std::vector<NodeId>> BoundaryRecovery::apply(const FacetSplit& split, const Cavity& cavity) {
    const std::vector<TetId> in_its_way = in_the_way(split, cavity);
    for (const TetId tet : in_its_way) release(tet);
    if (!in_its_way.empty()) return {};
    std::vector<NodeId> added = apply_split(split, cavity, projector_, brep_.tolerances().on_entity(), mesh_, context_);
    report_.recovery_points += added.size();
    return added;
}

std::vector<TetId> BoundaryRecovery::in_the_way(const FacetSplit& split, const Cavity& cavity) const {
    return tets_in_the_way(split, cavity, mesh_, is_released, near_);
}

void BoundaryRecovery::release(TetId tet) {
    is_released[tet.index()] = 1;
    if (may_be_open.empty()) return;
    is_rim_wider_ = true;
    for (const NodeId n : mesh_.tets[tet.index()]) may_be_open[n.index()] = 1;
}

int BoundaryRecovery::round_limit() const { return may_be_open.empty() ? most_rounds : most_rounds_of_update; }

/// Every step of the recovery is long enough to look for a cancel before it.
void BoundaryRecovery::log(const char* what, std::size_t count) const {
    context_.check_cancelled();
    context_.log("boundary recovery: " + std::to_string(count) + " " + what);
}

}  // namespace featuremesh

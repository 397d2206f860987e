// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/fill_solids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/errors.h"
#include "mesh/tets_at_nodes.h"
#include "surface/projection.h"
#include "volume/boundary_moves.h"
#include "volume/cavity_refusals.h"
#include "volume/constrained_delaunay.h"
#include "volume/crowded_points.h"
#include "volume/detours.h"
#include "volume/facet_split.h"
#include "volume/fill_cavity.h"
#include "volume/flip_facets.h"
#include "volume/flip_recovery.h"
#include "volume/lean_needles.h"
#include "volume/local_recovery.h"
#include "volume/needle_neighbours.h"
#include "volume/needles.h"
#include "volume/optimise.h"
#include "volume/seam_mending.h"
#include "volume/short_edges.h"
#include "volume/thicken.h"
#include "volume/wall_tets.h"
#include "volume/withdraw_points.h"

namespace featuremesh {

namespace {

/// An update that takes more than the second costs more than one that keeps less: of thirty on real parts, those that
/// ended well had six at most.
constexpr int most_rounds = 12, most_rounds_of_update = 6;
constexpr int most_crossing_rounds = 3;
constexpr int most_local_recoveries = 5;
/// Kept tets that are not Delaunay may be many: then a cavity that grows by those at its seam would not end in time.
constexpr int most_releasing_rounds = 5;
/// What is further from the seam is filled as well as in a full mesh, or nearly so: more counts where the seam is much
/// of a small mesh, and costs nothing there.
constexpr int edges_to_seam = 1, edges_to_seam_if_small = 5;
constexpr std::size_t small_cavity = 8000;  // tets
/// Of the facets: where more are missing, constraints would add points by the thousand. Else they make better tets.
constexpr double many_missing = 0.1;
/// Of the cube of the smallest wanted length: tets below are mended, and those below are refused.
constexpr double mended_share = 1e-2, refused_share = 1e-3;

/// A filling from the round before, for a cavity of the same nodes, or for one that may have grown since.
struct KnownFill {
    std::vector<NodeId> nodes;
    CavityFill fill;
};

/// A triangulation from the round before, for a cavity of the same nodes.
struct KnownTriangulation {
    std::vector<NodeId> nodes;
    std::vector<Vec3> seeds;
    Triangulation triangulation;
    bool is_best;  ///< filling anew would give nothing better
};

/// All its nodes lie in one plane.
bool is_flat(const CavityFill& fill) { return fill.triangulation.tets.empty(); }

/// The filling of one mesh, round by round: what does not hold is released or recovered, and filled again.
class Filling {
  public:
    Filling(const Brep& brep, const SizingField& sizing, Mesh surface, std::span<const Vec3> active,
            const VolumeOptions& options, RunContext& context, const KeptRim& rim)
        : brep_(brep),
          sizing_(sizing),
          active_(active),
          options_(options),
          context_(context),
          sides_(brep.sides_of_faces()),
          is_released_(surface.tets.size(), 0),
          may_be_open_(rim.nodes.begin(), rim.nodes.end()),
          kept_nodes_(rim.kept_nodes),
          projector_(brep) {
        result_.mesh = std::move(surface);
        rim_tets_.assign(rim.tets.begin(), rim.tets.end());
        size_ = wanted_size(sizing_, result_.mesh);
    }

    VolumeResult run() {
        {
            const RunContext::Step step(context_, "volume");
            for (int round = 0; !fill_all() || flip_flat_tets(round); ++round) mend(round);
            note_used_active();
        }
        {
            const RunContext::Step step(context_, "optimise");
            optimise_all();
        }
        for (std::size_t i = 0; i < cavities_.size(); ++i)
            if (!is_thick_[i]) require_thick(cavities_[i], regions_[i].complex);
        drop_released();
        for (const SeamRegion& region : regions_) move_nodes(region);
        const std::size_t kept_tets = result_.mesh.tets.size();
        for (const SeamRegion& region : regions_) append(region);
        lean(kept_tets);
        return std::move(result_);
    }

  private:
    /// One round; true when every cavity is full.
    bool fill_all() {
        if (!may_be_open_.empty()) may_be_open_.resize(result_.mesh.node_count(), 1);
        if (std::exchange(is_rim_wider_, false)) rim_tets_ = tets_at_nodes(result_.mesh, may_be_open_);
        if (!may_be_open_.empty()) near_ = rim_tets_;
        cavities_ = separate_cavities(find_cavity(result_.mesh, sides_, is_released_, may_be_open_, near_));
        fills_.assign(cavities_.size(), {});
        parallel_for(context_, cavities_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) fill(i);
        });
        known_.clear();
        finished_.clear();
        outgrown_.clear();
        for (std::size_t i = 0; i < cavities_.size(); ++i)
            if (!fills_[i].withdrawn) turn_missing(i);
        is_first_round_ = false;
        return std::all_of(fills_.begin(), fills_.end(), [](const CavityFill& f) { return f.is_complete(); });
    }

    /// Where other diagonals on the CAD faces are all that is missing, the triangulation serves as it is.
    void turn_missing(std::size_t i) {
        Cavity& cavity = cavities_[i];
        CavityFill& fill = fills_[i];
        const std::vector<int>& missing = fill.places.missing;
        if (missing.empty() ||
            !std::all_of(missing.begin(), missing.end(), [&](int f) { return cavity.triangle_of_facet[f].is_valid(); }))
            return;
        const FacetSplit flips = flip_missing(cavity, fill, result_.mesh);
        if (flips.pieces.size() != missing.size() || !in_the_way(flips, cavity).empty()) return;
        apply_split(flips, cavity, projector_, brep_.tolerances().on_entity(), result_.mesh, context_);
        for (const FacetSplit::Piece& piece : flips.pieces) cavity.facets[piece.facet].corners = piece.corners;
        log("diagonals changed", flips.pieces.size() / 2);
        if (is_first_round_) result_.report.recovered_triangles += flips.pieces.size();
        flood_turned(cavity, fill, context_);
    }

    void fill(std::size_t i) {
        const Cavity& cavity = cavities_[i];
        for (KnownFill& known : finished_)
            if (known.nodes == cavity.nodes) {
                fills_[i] = std::move(known.fill);
                return;
            }
        for (KnownTriangulation& known : known_) {
            if (known.nodes != cavity.nodes) continue;
            std::vector<Vec3> points = cavity.points;
            points.insert(points.end(), known.seeds.begin(), known.seeds.end());
            fills_[i] = flood_cavity(cavity, std::move(points), std::move(known.triangulation), context_);
            if (known.is_best || (fills_[i].is_complete() && !has_inverted_tet(fills_[i]))) return;
        }
        for (KnownFill& old : outgrown_)
            if (cavity.nodes.size() <= old.nodes.size() + old.fill.places.missing.size() &&
                std::includes(cavity.nodes.begin(), cavity.nodes.end(), old.nodes.begin(), old.nodes.end())) {
                fills_[i] = grow_fill(cavity, old.nodes, old.fill, context_);
                return;
            }
        try {
            fills_[i] = fill_cavity(cavity, seam_balls(result_.mesh, cavity, size_), active_, size_, context_);
        } catch (const MeshError&) {
            require_distinct(brep_, result_.mesh, cavity);
            throw;
        }
    }

    int round_limit() const { return may_be_open_.empty() ? most_rounds : most_rounds_of_update; }

    void mend(int round) {
        if (round >= round_limit()) throw unrecovered(result_.mesh, cavities_, fills_);
        for (std::size_t i = 0; i < cavities_.size(); ++i) {
            CavityFill& fill = fills_[i];
            if (round == 0) result_.report.recovered_triangles += fill.places.missing.size();
            if (!fill.is_complete()) log("triangles are missing", fill.places.missing.size());
            if (fill.withdrawn) {
                finished_.push_back({cavities_[i].nodes, std::move(fill)});
            } else if (fill.is_complete()) {
                known_.push_back(
                    {cavities_[i].nodes, seeds_of(cavities_[i], fill), std::move(fill.triangulation), true});
            } else if ((round < most_releasing_rounds || is_flat(fill)) && release_behind(cavities_[i], fill)) {
                if (const FacetSplit flips = flip_missing(cavities_[i], fill, result_.mesh); !flips.pieces.empty())
                    apply(flips, cavities_[i]);
                if (fill.delaunay) outgrown_.push_back({cavities_[i].nodes, std::move(fill)});
            } else {
                recover(cavities_[i], fill);
            }
        }
    }

    /// Whether there was a tet without height to get rid of, so that another round is due.
    bool flip_flat_tets(int round) {
        if (round >= round_limit()) return false;
        bool is_changed = false;
        for (std::size_t i = 0; i < cavities_.size(); ++i) {
            if (fills_[i].withdrawn) continue;
            const FacetSplit flips = flip_flat(cavities_[i], fills_[i], result_.mesh);
            if (flips.pieces.empty()) continue;
            is_changed = true;
            apply(flips, cavities_[i]);
        }
        return is_changed;
    }

    void release(TetId tet) {
        is_released_[tet.index()] = 1;
        if (may_be_open_.empty()) return;
        is_rim_wider_ = true;
        for (const NodeId n : result_.mesh.tets[tet.index()]) may_be_open_[n.index()] = 1;
    }

    /// Gives up the kept tets behind seam facets that are missing.
    bool release_behind(const Cavity& cavity, const CavityFill& fill) {
        bool is_changed = false;
        for (const int facet : fill.places.missing)
            if (const TetId tet = cavity.tet_of_facet[facet]; tet.is_valid()) release(tet), is_changed = true;
        return is_changed;
    }

    /// Changes diagonals if that is all; else flips or constrains what is missing, or cuts what stands in the way.
    void recover(const Cavity& cavity, CavityFill& fill) {
        if (is_flat(fill))
            throw MeshError("all nodes to fill between lie in one plane, at " +
                            names_of_faces(result_.mesh, cavity, fill.places.missing) + "; mesh the part finer");
        std::vector<Vec3> seeds = seeds_of(cavity, fill);
        const FacetSplit flips = flip_missing(cavity, fill, result_.mesh);
        if (!flips.pieces.empty()) {
            log("diagonals to change", flips.pieces.size() / 2);
            if (apply(flips, cavity))
                known_.push_back({cavity.nodes, std::move(seeds), std::move(fill.triangulation), true});
            else if (fill.delaunay)
                outgrown_.push_back({cavity.nodes, std::move(fill)});
            return;
        }
        require_closed(result_.mesh, cavity);
        if (const std::vector<int> crossing = crossing_facets(cavity); !crossing.empty()) {
            if (++crossing_rounds_ > most_crossing_rounds) throw cut_one_another(result_.mesh, cavity, crossing);
            log("triangles that cross others", crossing.size());
            apply(halve_longest_edges(cavity, crossing), cavity);
            return;
        }
        std::vector<int> stuck = fill.places.missing;
        const bool are_many = stuck.size() > many_missing * cavity.facets.size();
        if (are_many && flip(cavity, fill, seeds, stuck)) return;
        std::optional<ConstrainedTriangulation> local;
        if (local_recoveries_++ < most_local_recoveries) local = recover_locally(cavity, fill, context_);
        ConstrainedTriangulation constrained =
            local ? std::move(*local) : constrained_delaunay(cavity, seeds, fill.places.missing.size(), context_);
        if (constrained.is_given_up || !constrained.failed.empty()) {
            if (!are_many && flip(cavity, fill, seeds, stuck)) return;
            if (!constrained.is_given_up) stuck = constrained.failed;
            log("triangles that constraints did not bring back", stuck.size());
            if (++crossing_rounds_ > most_crossing_rounds) throw unrecovered(result_.mesh, cavities_, fills_);
            apply(halve_longest_edges(cavity, stuck), cavity);
            return;
        }
        log("points that constraints added", constrained.split.added.size());
        if (auto whole = withdraw_points(cavity, constrained, seeds, context_)) {
            result_.report.recovery_points += constrained.split.added.size();
            return finished_.push_back({cavity.nodes, std::move(*whole)});
        }
        log("points that stay on the boundary", constrained.split.added.size());
        if (const auto added = apply(constrained.split, cavity)) {
            std::vector<NodeId> nodes = cavity.nodes;
            nodes.insert(nodes.end(), added->begin(), added->end());
            known_.push_back({std::move(nodes), std::move(seeds), std::move(constrained.triangulation), false});
        }
    }

    /// All that is missing, or nothing: then `stuck` is what could not be had.
    bool flip(const Cavity& cavity, const CavityFill& fill, const std::vector<Vec3>& seeds, std::vector<int>& stuck) {
        FlippedTriangulation flipped = recover_by_flips(cavity, fill, context_);
        if (flipped.tets) known_.push_back({cavity.nodes, seeds, std::move(*flipped.tets), true});
        stuck = std::move(flipped.left);
        log("triangles that flips did not bring back", stuck.size());
        return stuck.empty();
    }

    /// Every step of the recovery is long enough to look for a cancel before it.
    void log(const char* what, std::size_t count) const {
        context_.check_cancelled();
        context_.log("boundary recovery: " + std::to_string(count) + " " + what);
    }

    /// The new nodes; none when kept tets were in the way and have been released instead.
    std::optional<std::vector<NodeId>> apply(const FacetSplit& split, const Cavity& cavity) {
        const std::vector<TetId> in_its_way = in_the_way(split, cavity);
        for (const TetId tet : in_its_way) release(tet);
        if (!in_its_way.empty()) return {};
        std::vector<NodeId> added =
            apply_split(split, cavity, projector_, brep_.tolerances().on_entity(), result_.mesh, context_);
        result_.report.recovery_points += added.size();
        return added;
    }

    std::vector<TetId> in_the_way(const FacetSplit& split, const Cavity& cavity) const {
        return tets_in_the_way(split, cavity, result_.mesh, is_released_, near_);
    }

    void optimise_all() {
        regions_.assign(cavities_.size(), {});
        is_thick_.assign(cavities_.size(), 0);
        unoptimised_.assign(cavities_.size(), {});
        VolumeReport& report = result_.report;
        report.odt_energy_before = report.odt_energy_after = 0;
        report.slivers_before = report.slivers_left = report.released_for_quality = 0;
        std::vector<std::pair<OdtReport, SliverReport>> reports(cavities_.size());
        const bool is_parallel = context_.threads > 1 && cavities_.size() > 1;
        parallel_for(context_, cavities_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                RunContext alone;
                alone.end_with(context_);
                reports[i] = optimise(i, is_parallel ? alone : context_);
            }
        });
        for (std::size_t i = 0; i < cavities_.size(); ++i) {
            report.odt_energy_before += reports[i].first.energy_before;
            report.odt_energy_after += reports[i].first.energy_after;
            report.slivers_before += reports[i].second.before;
        }
        for (std::size_t i = 0; i < cavities_.size(); ++i) refuse_hopeless(i, reports[i].second.left);
        if (std::any_of(reports.begin(), reports.end(), [](const auto& r) { return r.second.left > 0; }))
            mend_seams(regions_, result_.mesh, is_released_, options_.target_dihedral_deg, context_);
        if (options_.moves_kept_nodes)
            report.released_for_shape =
                relax_seams(regions_, result_.mesh, rim_tets_, is_released_, options_.target_dihedral_deg, context_);
        if (options_.splits_wall_tets) split_wall_tets();
        for (std::size_t i = 0; i < cavities_.size(); ++i) {
            TetComplex& complex = regions_[i].complex;
            const double least = least_volume(mended_share);
            std::size_t improved = make_thick(i, least);
            if (options_.moves_surface_nodes && (reports[i].second.left > 0 || improved > 0))
                improved += move_boundary(regions_[i], least);
            const bool is_mended = regions_[i].taken_count() > 0 || improved > 0;
            report.released_for_quality += give_back(regions_[i], result_.mesh, is_released_);
            report.slivers_left +=
                is_mended ? regions_[i].count_bad(options_.target_dihedral_deg) : reports[i].second.left;
            if (!is_thick_[i]) leave_out_flat_tets(cavities_[i], complex);
        }
        report.released_for_quality -= std::min(report.released_for_quality, report.released_for_shape);
    }

    /// Returns how many operations made angles better afterwards.
    std::size_t make_thick(std::size_t i, double least) {
        TetComplex& complex = regions_[i].complex;
        const auto mend = [&] {
            Thickened thickened = thicken(complex, least, context_, most_insertions(regions_[i]));
            is_thick_[i] = thickened.left.empty();
            return improve_beside_needles(complex, std::move(thickened.changed), options_.target_dihedral_deg, least,
                                          context_);
        };
        const auto is_refused = [&](const auto& tet) {
            return tet[0] >= 0 && is_too_thin(complex, tet, least_volume(refused_share));
        };
        const std::size_t improved = mend();
        if (is_thick_[i] || !unoptimised_[i].has_value() || regions_[i].taken_count() > 0 ||
            std::none_of(complex.tets.begin(), complex.tets.end(), is_refused))
            return improved;
        regions_[i] = std::move(*unoptimised_[i]);
        complex.excuses_needles = false;
        improve_angles(i, context_);
        return mend() + 1;
    }

    /// Where inner vertices were of no help. Returns how often something changed.
    std::size_t move_boundary(SeamRegion& region, double least) {
        std::vector<BoundaryVertex> vertices = movable_vertices(brep_, result_.mesh, region, kept_nodes_);
        const BoundaryMoveOptions options{options_.target_dihedral_deg, least, options_.is_for_curved_tets};
        std::vector<int> changed = move_on_boundary(region.complex, vertices, projector_, options, context_);
        const std::size_t count =
            changed.size() +
            (region.has_seam() ? 0 : take_detours(region.complex, vertices, projector_, options, context_));
        for (const BoundaryVertex& v : vertices) {
            const std::size_t node = region.node_of(v.vertex).index();
            result_.mesh.points[node] = region.complex.points[static_cast<std::size_t>(v.vertex)];
            result_.mesh.parameters[node] = v.parameters;
        }
        if (!changed.empty())
            improve_beside_needles(region.complex, std::move(changed), options_.target_dihedral_deg, least, context_);
        return count;
    }

    /// With fewer kept tets, or none, there is another way, which a long search here would only put off.
    static std::size_t most_insertions(const SeamRegion& region) {
        constexpr std::size_t at_least = 40, tets_per_insertion = 1000;
        return region.has_seam() ? at_least + region.complex.tets.size() / tets_per_insertion
                                 : std::numeric_limits<std::size_t>::max();
    }

    /// More tets without a volume to speak of than new vertices will be tried for.
    void refuse_hopeless(std::size_t i, std::size_t bad_tets) const {
        const TetComplex& complex = regions_[i].complex;
        if (bad_tets <= most_insertions(regions_[i])) return;
        const auto thin = std::count_if(complex.tets.begin(), complex.tets.end(), [&](const auto& tet) {
            return tet[0] >= 0 && thickness(complex, tet, least_volume(mended_share)) < 1;
        });
        if (static_cast<std::size_t>(thin) > most_insertions(regions_[i])) require_thick(cavities_[i], complex);
    }

    void split_wall_tets() {
        const OppositeWalls walls(brep_, result_.mesh, projector_);
        for (SeamRegion& region : regions_)
            result_.report.split_wall_tets +=
                featuremesh::split_wall_tets(region, walls, options_.target_dihedral_deg, context_);
    }

    std::pair<OdtReport, SliverReport> optimise(std::size_t i, RunContext& context) {
        regions_[i] = SeamRegion(cavities_[i], make_complex(cavities_[i], fills_[i], context_));
        if (fills_[i].withdrawn) {
            const std::size_t gone =
                remove_crowded(regions_[i].complex, *fills_[i].withdrawn, size_, options_.target_dihedral_deg, context);
            context.log("boundary recovery: " + std::to_string(gone) + " points inside taken out again");
        }
        fills_[i] = {};
        if (has_needle(regions_[i].complex)) unoptimised_[i] = regions_[i];
        return improve_angles(i, context);
    }

    std::pair<OdtReport, SliverReport> improve_angles(std::size_t i, RunContext& context) {
        TetComplex& complex = regions_[i].complex;
        const OdtReport odt = optimise_odt(complex, sizing_, {options_.odt_sweeps, !sizing_.is_uniform()}, context);
        SliverOptions sliver_options;
        sliver_options.target_dihedral_deg = options_.target_dihedral_deg;
        SliverReport slivers = remove_slivers(complex, sliver_options, context);
        const ShapeOptions shape_options{
            .target_dihedral_deg = options_.target_dihedral_deg,
            .among = regions_[i].vertices_near_seam(complex.tets.size() < small_cavity ? edges_to_seam_if_small
                                                                                       : edges_to_seam)};
        const ShapeReport shapes = optimise_shapes(complex, shape_options, context);  // makes no good tet bad
        if (shapes.moves > 0 && slivers.left > 0) slivers.left = regions_[i].count_bad(options_.target_dihedral_deg);
        return {odt, slivers};
    }

    /// The optimiser may have moved a tet without height to where it lies under two triangles of a face.
    void leave_out_flat_tets(const Cavity& cavity, TetComplex& complex) {
        CavityFill fill;
        fill.points = complex.points;
        std::vector<std::size_t> live;
        for (std::size_t t = 0; t < complex.tets.size(); ++t)
            if (complex.tets[t][0] >= 0) live.push_back(t), fill.triangulation.tets.push_back(complex.tets[t]);
        fill.regions.assign(live.size(), 0);
        fill.places = find_facets(fill.triangulation, fill.points.size(), cavity.facets, context_);
        const FacetSplit flips = flip_flat(cavity, fill, result_.mesh, least_volume(refused_share));
        if (flips.pieces.empty() || !in_the_way(flips, cavity).empty()) return;
        std::map<int, std::array<int, 3>> new_corners;
        for (const auto& piece : flips.pieces) new_corners[piece.facet] = piece.corners;
        for (std::size_t t = 0; t < live.size(); ++t) {
            const auto& tet = fill.triangulation.tets[t];
            int count = 0;  // of new triangles that are sides of this tet, in place of old ones that are
            for (int k = 0; k < 4; ++k) {
                const auto flipped = new_corners.find(fill.places.facet_at[4 * t + k]);
                if (flipped == new_corners.end()) continue;
                count += std::all_of(flipped->second.begin(), flipped->second.end(),
                                     [&](int c) { return std::find(tet.begin(), tet.end(), c) != tet.end(); });
            }
            if (count == 2) complex.tets[live[t]][0] = -1;
        }
        apply(flips, cavity);
    }

    void note_used_active() {
        result_.used_active.clear();
        if (active_.empty()) return;
        for (std::size_t i = 0; i < cavities_.size(); ++i) {
            const std::vector<Vec3> used = seeds_among(active_, cavities_[i], fills_[i]);
            result_.used_active.insert(result_.used_active.end(), used.begin(), used.end());
        }
    }

    /// Elements that the sizes themselves ask for are not too small: a share of the smallest wanted length's cube.
    double least_volume(double share_of_smallest) const {
        const double asked = std::max(sizing_.smallest(), options_.smallest_asked);
        return std::min(brep_.tolerances().least_volume(), share_of_smallest * asked * asked * asked);
    }

    void require_thick(const Cavity& cavity, const TetComplex& complex) const {
        std::set<FaceId> near;
        std::vector<std::array<int, 4>> thin;
        for (const auto& tet : complex.tets) {
            if (tet[0] < 0) continue;
            if (!is_too_thin(complex, tet, least_volume(refused_share))) continue;
            thin.push_back(tet);
            for (const FaceId face : nearest_faces(brep_, result_.mesh, cavity, tet)) near.insert(face);
        }
        if (thin.empty()) return;
        std::string names;
        for (int listed = 0; const FaceId face : near)
            if (listed++ < 4) names += (names.empty() ? "" : ", ") + name_of(entity_of(face));
        throw MeshError(std::to_string(thin.size()) + " tets without a volume to speak of remain " +
                        (names.empty() ? "inside the solid" : "at " + names) +
                        short_edges_among(brep_, result_.mesh, cavity.nodes, thin) +
                        "; mesh finer there, or take out what is much smaller than the rest of the part");
    }

    void drop_released() {
        Mesh& mesh = result_.mesh;
        const auto first = is_released_.begin(), last = is_released_.end();
        auto gone = std::find(first, last, 1);
        auto kept = gone - first;
        RoundWatch watch(context_);
        while (gone != last) {  // and what stays until the next that goes moves up
            watch();
            const auto begin = gone - first + 1, end = (gone = std::find(gone + 1, last, 1)) - first;
            result_.released.push_back(TetId(std::size_t(begin - 1)));
            result_.released_nodes.push_back(mesh.tets[begin - 1]);
            const auto move_up = [&](auto first_of) { std::move(first_of + begin, first_of + end, first_of + kept); };
            move_up(mesh.tets.begin()), move_up(mesh.tet_solids.begin()), move_up(mesh.tet_numbers.begin());
            kept += end - begin;
        }
        mesh.tets.resize(kept), mesh.tet_solids.resize(kept), mesh.tet_numbers.resize(kept);
        result_.report.released_tets = result_.released.size();
    }

    /// A node that has been moved is a new one in the place of the old.
    void move_nodes(const SeamRegion& region) {
        for (const auto& [node, vertex] : region.moved_nodes(result_.mesh)) {
            result_.mesh.points[node.index()] = region.complex.points[static_cast<std::size_t>(vertex)];
            result_.mesh.node_numbers[node.index()] = result_.mesh.next_node_number++;
            result_.moved.push_back(node);
        }
    }

    void append(const SeamRegion& region) {
        Mesh& mesh = result_.mesh;
        const TetComplex& complex = region.complex;
        std::vector<NodeId> node;
        for (std::size_t v = 0; v < complex.points.size(); ++v) node.push_back(region.node_of(static_cast<int>(v)));
        RoundWatch watch(context_);
        for (std::size_t t = 0; t < complex.tets.size(); ++t) {
            watch();
            const auto& tet = complex.tets[t];
            if (tet[0] < 0) continue;
            const Entity solid = entity_of(SolidId(complex.regions[t]));
            std::array<NodeId, 4> nodes;
            for (int k = 0; k < 4; ++k) {
                if (!node[tet[k]].is_valid())
                    node[tet[k]] = mesh.add_node(complex.points[tet[k]], solid), ++result_.report.new_nodes;
                nodes[k] = node[tet[k]];
            }
            mesh.add_tet(nodes, SolidId(complex.regions[t]));
            ++result_.report.new_tets;
        }
        mesh.corner_count = mesh.points.size();
    }

    void lean(std::size_t kept_tets) {
        std::vector<TriangleId> triangles;
        for (const Cavity& cavity : cavities_)
            for (const TriangleId t : cavity.triangle_of_facet)
                if (t.is_valid()) triangles.push_back(t);
        lean_needles(brep_, projector_, triangles, kept_tets, result_.mesh);
        result_.report.new_tets = result_.mesh.tets.size() - kept_tets;
    }

    const Brep& brep_;
    const SizingField& sizing_;
    std::span<const Vec3> active_;
    const VolumeOptions& options_;
    RunContext& context_;
    const std::vector<std::array<SolidId, 2>>& sides_;  ///< by face
    std::vector<std::uint8_t> is_released_;
    std::vector<char> may_be_open_;               ///< by node, or empty when it is not known
    std::size_t kept_nodes_;                      ///< the first so many
    std::vector<TetId> rim_tets_;                 ///< all with such a node
    bool is_rim_wider_ = false;                   ///< so that there may be more of them
    std::optional<std::span<const TetId>> near_;  ///< all kept tets at the cavities are among them; none: not known
    Projector projector_;
    WantedSize size_;
    std::vector<Cavity> cavities_;
    std::vector<CavityFill> fills_;
    std::vector<KnownTriangulation> known_;
    std::vector<KnownFill> finished_;  ///< by withdrawn points; nothing outside
    std::vector<KnownFill> outgrown_;
    std::vector<SeamRegion> regions_;  ///< by cavity
    /// By cavity, where there are needles: volume may be left to them only while their angles count.
    std::vector<std::optional<SeamRegion>> unoptimised_;
    std::vector<char> is_thick_;  ///< by cavity: all its tets have a volume to speak of
    int crossing_rounds_ = 0, local_recoveries_ = 0;
    bool is_first_round_ = true;
    VolumeResult result_;
};

}  // namespace

VolumeResult fill_solids(const Brep& brep, const SizingField& sizing, Mesh surface, std::span<const Vec3> active,
                         const VolumeOptions& options, RunContext& context, const KeptRim& rim) {
    if (surface.order != 1) throw InputError("solids are filled with 4-node tets; the mesh given has mid-side nodes");
    return Filling(brep, sizing, std::move(surface), active, options, context, rim).run();
}

}  // namespace featuremesh

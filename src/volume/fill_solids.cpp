// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/fill_solids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>
#include <variant>

#include "core/errors.h"
#include "core/messages.h"
#include "surface/projection.h"
#include "volume/cavity.h"
#include "volume/cavity_refusals.h"
#include "volume/delaunay/optimise_odt.h"
#include "volume/fill_cavity.h"
#include "volume/improvement/improve.h"
#include "volume/improvement/local_mesh.h"
#include "volume/improvement/objective.h"
#include "volume/improvement/operations.h"
#include "volume/interface/interface_mending.h"
#include "volume/interface/interface_region.h"
#include "volume/lean_needles.h"
#include "volume/opposite_walls.h"
#include "volume/recovery/boundary_recovery.h"
#include "volume/recovery/facet_split.h"
#include "volume/recovery/flip_facets.h"
#include "volume/short_edges.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/thin_tets.h"
#include "volume/wanted_size.h"

namespace featuremesh {

namespace {

/// How far from the interface, in edges, tets are treated as beside it. Further away they are as good as in a full
/// mesh. In a small cavity, where much is near the interface, more is taken in, at hardly any cost.
constexpr int edges_to_interface = 1, edges_to_interface_if_small = 5;
constexpr std::size_t small_cavity = 8000;   // tets
constexpr std::size_t large_cavity = 20000;  // tets: worth all threads
/// Shares of the cube of the smallest wanted length: tets with less volume than the first are mended, a mesh with less
/// than the second is refused.
constexpr double mended_share = 1e-2, refused_share = 1e-3;
/// How often the costliest operations are tried: at least so often, once more for every so many tets, and so often
/// again for each try that gains.
constexpr std::size_t refills_at_least = 200, tets_per_refill = 400, refills_per_gain = 5, refills_at_the_end = 100,
                      refills_per_thin = 10, most_for_thin = 1000;
constexpr std::size_t lookaheads_at_least = 25, tets_per_lookahead = 2500, lookaheads_per_gain = 1;
constexpr int passes_at_the_end = 12;
/// A surface node whose tets have a smaller mean radius ratio moves for their shapes, not only for their worst angle.
constexpr double poor_star = 0.6;

/// The filling of one mesh: tets that meet the boundary, and what makes them good.
class Filling {
  public:
    Filling(const Brep& brep, const SizingField& sizing, Mesh surface, std::span<const Vec3> active,
            const VolumeOptions& options, RunContext& context, const KeptRim& rim)
        : result_{.mesh = std::move(surface)},
          brep_(brep),
          sizing_(sizing),
          active_(active),
          options_(options),
          context_(context),
          kept_nodes_(rim.kept_nodes),
          projector_(brep),
          size_(wanted_size(sizing_, result_.mesh)),
          angles_({.target_dihedral_deg = options.target_dihedral_deg, .least_volume = least_volume(mended_share)}),
          shapes_({.target_dihedral_deg = options.target_dihedral_deg,
                   .least_volume = least_volume(mended_share),
                   .poor_shape = 1}),
          boundary_(brep, projector_, size_, active, rim, result_.mesh, result_.report, context) {}

    std::variant<VolumeResult, Obstacle> run() {
        {
            const RunContext::Step step(context_, "volume");
            if (auto obstacle = boundary_.run()) return std::move(*obstacle);
            note_used_active();
        }
        {
            const RunContext::Step step(context_, "optimise");
            optimise_all();
        }
        for (std::size_t i = 0; i < cavities_.size(); ++i)
            if (auto obstacle = if_thin(cavities_[i], regions_[i].complex)) {
                if (!options_.takes_thin_tets || has_flat(regions_[i].complex)) return std::move(*obstacle);
                result_.report.warnings.push_back(std::move(obstacle->message));
            }
        drop_released();
        for (const InterfaceRegion& region : regions_) move_nodes(region);
        const std::size_t kept_tets = result_.mesh.tets.size();
        const std::size_t nodes_before = result_.mesh.points.size();
        for (const InterfaceRegion& region : regions_) append(region);
        replace_unused(nodes_before, kept_tets);
        lean(kept_tets);
        return std::move(result_);
    }

  private:
    void optimise_all() {
        regions_.assign(cavities_.size(), {});
        VolumeReport& report = result_.report;
        report.odt_energy_before = report.odt_energy_after = 0;
        report.slivers_before = report.slivers_left = report.released_for_quality = 0;
        std::size_t left = 0;
        for (const Optimised& one : optimise_each()) {
            report.odt_energy_before += one.odt.energy_before;
            report.odt_energy_after += one.odt.energy_after;
            report.slivers_before += one.angles.before;
            left += one.angles.left;
        }
        if (left > 0) {
            for (std::size_t i = 0; i < cavities_.size(); ++i) refuse_hopeless(i);
            mend_interfaces(regions_, result_.mesh, is_released_, angles_, context_);
        }
        if (options_.moves_kept_nodes)
            report.released_for_shape =
                relax_interfaces(regions_, result_.mesh, rim_tets_, is_released_, shapes_, context_);
        for (std::size_t i = 0; i < cavities_.size(); ++i) {
            finish(regions_[i]);
            report.released_for_quality += give_back(regions_[i], result_.mesh, is_released_);
            report.slivers_left += count_bad(regions_[i].complex, angles_, context_);
            if (count_thin(regions_[i].complex, angles_, context_) > 0)
                leave_out_flat_tets(cavities_[i], regions_[i].complex);
        }
        renumber_moved();
        report.released_for_quality -= std::min(report.released_for_quality, report.released_for_shape);
    }

    struct Optimised {
        OdtReport odt;
        Improvement angles;
    };
    /// Small cavities at the same time, then large ones one after the other, each on all threads.
    std::vector<Optimised> optimise_each() {
        std::vector<Optimised> reports(cavities_.size());
        std::vector<std::size_t> small, large;
        for (std::size_t i = 0; i < cavities_.size(); ++i)
            (fills_[i].triangulation.tets.size() < large_cavity ? small : large).push_back(i);
        const bool is_parallel = context_.threads > 1 && small.size() > 1;
        parallel_for(context_, small.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                RunContext alone;
                alone.end_with(context_);
                reports[small[k]] = optimise(small[k], is_parallel ? alone : context_);
            }
        });
        for (const std::size_t i : large) reports[i] = optimise(i, context_);
        result_.report.large_cavities = large.size();
        return reports;
    }

    /// What needs the surface, too: its nodes move, tets without a volume to speak of get one, walls get nodes inside.
    void finish(InterfaceRegion& region) {
        ObjectiveOptions wanted = angles_.options();
        wanted.is_steep = true;
        std::optional<OppositeWalls> walls;
        if (options_.splits_wall_tets) {
            walls.emplace(brep_, result_.mesh);
            wanted.is_barred = [&](const std::array<int, 4>& tet) {
                return walls->are_spanned_by(
                    {region.node_of(tet[0]), region.node_of(tet[1]), region.node_of(tet[2]), region.node_of(tet[3])});
            };
        }
        const Objective all(wanted);
        wanted.poor_shape = poor_star;
        const Objective all_and_shapes(wanted);
        const std::size_t bad = count_bad(region.complex, all, context_);
        if (bad == 0) return;
        MovableSurface surface{{}, &projector_, options_.is_for_curved_tets};
        if (options_.moves_surface_nodes)
            surface.vertices = movable_vertices(brep_, result_.mesh, region, kept_nodes_, options_.moves_kept_nodes);
        LocalMesh mesh(region.complex, std::move(surface));
        const RefillOptions refill{.most_large_cavities = most_insertions(region)};
        const Improvement angles = improve(
            mesh, all,
            list_of(tet_split(mesh, all), edge_ring(mesh, all), vertex_move(mesh, all), cone_refill(mesh, all, refill)),
            {},
            {.passes = passes_at_the_end,
             .dear_plans = refills_at_the_end +
                           std::min(refills_per_thin * count_thin(region.complex, angles_, context_), most_for_thin),
             .dear_plans_per_gain = refills_per_gain},
            context_);
        note(angles, context_);
        result_.report.split_wall_tets += angles.counts.front().made;
        if (options_.moves_surface_nodes)
            note(improve(mesh, all_and_shapes, list_of(vertex_move(mesh, all_and_shapes)), {},
                         {.passes = passes_at_the_end}, context_),
                 context_);
        if (options_.looks_ahead_beside_kept || !region.has_interface())
            note(improve(mesh, all, list_of(lookahead(mesh, all, context_)), {}, with_lookaheads(region.complex),
                         context_),
                 context_);
        for (const SurfaceVertex& of : mesh.release_surface()) place(region, of);
    }

    /// One that was kept and has moved is a new one.
    void place(const InterfaceRegion& region, const SurfaceVertex& of) {
        const NodeId node = region.node_of(of.vertex);
        const Vec3& there = region.complex.points[static_cast<std::size_t>(of.vertex)];
        Vec3& place = result_.mesh.points[node.index()];
        if (of.is_kept && place != there) {
            result_.mesh.node_numbers[node.index()] = result_.mesh.next_node_number++;
            result_.moved.push_back(node);
        }
        place = there;
        result_.mesh.parameters[node.index()] = of.parameters;
    }

    /// Kept triangles and segments with a node that has moved are new ones.
    void renumber_moved() {
        Mesh& mesh = result_.mesh;
        if (result_.moved.empty()) return;
        std::vector<char> is_moved(mesh.node_count(), 0);
        for (const NodeId n : result_.moved) is_moved[n.index()] = 1;
        const auto renumber = [&](const auto& elements, std::vector<Number>& numbers) {
            for (std::size_t i = 0; i < elements.size(); ++i)
                if (std::any_of(elements[i].begin(), elements[i].end(), [&](NodeId n) { return is_moved[n.index()]; }))
                    numbers[i] = mesh.next_element_number++;
        };
        renumber(mesh.segments, mesh.segment_numbers);
        renumber(mesh.triangles, mesh.triangle_numbers);
    }

    static void note(const Improvement& done, const RunContext& context) {
        std::ostringstream line;
        line << "improvement: " << done.before << " bad, " << done.left << " left, " << done.forced
             << " of them forced;";
        for (const Improvement::Count& count : done.counts)
            line << " " << count.operation << " " << count.made << " of " << count.planned;
        context.log(line.str());
    }

    static Budget with_refills(const TetComplex& complex) {
        return {.dear_plans = refills_at_least + complex.tets.size() / tets_per_refill,
                .dear_plans_per_gain = refills_per_gain};
    }
    static Budget with_lookaheads(const TetComplex& complex) {
        return {.dear_plans = lookaheads_at_least + complex.tets.size() / tets_per_lookahead,
                .dear_plans_per_gain = lookaheads_per_gain};
    }

    /// The search for places of new vertices is bounded beside kept tets: keeping fewer of them, or none, is another
    /// way, which a long search would only delay.
    static std::size_t most_insertions(const InterfaceRegion& region) {
        constexpr std::size_t at_least = 40, tets_per_insertion = 1000;
        return region.has_interface() ? at_least + region.complex.tets.size() / tets_per_insertion : any_number;
    }

    /// Gives up at once when there are more tets with next to no volume than tries to mend them. The caller then asks
    /// for other lengths or ignores details.
    void refuse_hopeless(std::size_t i) const {
        const TetComplex& complex = regions_[i].complex;
        if (count_thin(complex, angles_, context_) <= std::min(most_insertions(regions_[i]), most_for_thin)) return;
        if (const auto obstacle = if_thin(cavities_[i], complex)) throw MeshError(obstacle->message);
    }

    /// What the vertices inside can do.
    Optimised optimise(std::size_t i, RunContext& context) {
        regions_[i] = InterfaceRegion(cavities_[i], make_complex(cavities_[i], fills_[i], context_));
        TetComplex& complex = regions_[i].complex;
        if (fills_[i].relocated) {
            LocalMesh mesh(complex);
            const Improvement done = improve(mesh, shapes_, list_of(close_point_collapse(mesh, shapes_, size_)),
                                             tets_at(complex, *fills_[i].relocated), {}, context);
            context.log("boundary recovery: " + std::to_string(done.changes) + " points inside taken out again");
        }
        fills_[i] = {};
        Optimised done;
        done.odt = optimise_odt(complex, sizing_, {options_.odt_sweeps, !sizing_.is_uniform()}, context);
        LocalMesh mesh(complex);
        done.angles = improve(mesh, angles_,
                              list_of(edge_ring(mesh, angles_), vertex_move(mesh, angles_), cone_refill(mesh, angles_)),
                              {}, with_refills(complex), context);
        note(done.angles, context);
        const int edges = complex.tets.size() < small_cavity ? edges_to_interface_if_small : edges_to_interface;
        if (std::vector<int> near = regions_[i].tets_near_interface(edges); !near.empty())
            improve(mesh, shapes_, list_of(vertex_move(mesh, shapes_)), std::move(near), {.passes = 3}, context);
        return done;
    }

    static std::vector<int> tets_at(const TetComplex& complex, std::span<const int> vertices) {
        std::vector<char> is_given(complex.points.size(), 0);
        for (const int v : vertices) is_given[static_cast<std::size_t>(v)] = 1;
        std::vector<int> tets;
        for (std::size_t t = 0; t < complex.tets.size(); ++t)
            if (const auto& tet = complex.tets[t];
                std::any_of(tet.begin(), tet.end(), [&](int v) { return is_given[static_cast<std::size_t>(v)] != 0; }))
                tets.push_back(static_cast<int>(t));
        return tets;
    }

    /// Leaves out flat tets: the optimiser may have moved one to where it lies flat under two triangles of a face.
    void leave_out_flat_tets(const Cavity& cavity, TetComplex& complex) {
        CavityFill fill;
        fill.points = complex.points;
        std::vector<std::size_t> live;
        for (std::size_t t = 0; t < complex.tets.size(); ++t)
            if (complex.tets[t][0] >= 0) live.push_back(t), fill.triangulation.tets.push_back(complex.tets[t]);
        fill.regions.assign(live.size(), 0);
        fill.places = find_facets(fill.triangulation, fill.points.size(), cavity.facets, context_);
        const FacetSplit flips = flip_flat(cavity, fill, result_.mesh, least_volume(refused_share));
        if (flips.pieces.empty() || !boundary_.in_the_way(flips, cavity).empty()) return;
        std::map<int, std::array<int, 3>> new_corners;
        for (const auto& piece : flips.pieces) new_corners[piece.facet] = piece.corners;
        for (std::size_t t = 0; t < live.size(); ++t) {
            const auto& tet = fill.triangulation.tets[t];
            int count = 0;  // of new triangles that are facets of this tet, in place of old ones that are
            for (int k = 0; k < 4; ++k) {
                const auto flipped = new_corners.find(fill.places.facet_at[4 * t + k]);
                if (flipped == new_corners.end()) continue;
                count += std::all_of(flipped->second.begin(), flipped->second.end(),
                                     [&](int c) { return std::find(tet.begin(), tet.end(), c) != tet.end(); });
            }
            if (count == 2) complex.tets[live[t]][0] = -1;
        }
        boundary_.apply(flips, cavity);
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

    /// Shorter sides may help where these elements are few, and no edge forces them.
    std::optional<Obstacle> if_thin(const Cavity& cavity, const TetComplex& complex) const {
        std::set<FaceId> near;
        std::vector<std::array<int, 4>> thin;
        std::vector<SizeSource> shorter;
        const double least = least_volume(refused_share);
        for (const auto& tet : complex.tets) {
            if (tet[0] < 0 || !is_too_thin(complex, tet, least)) continue;
            thin.push_back(tet);
            shorter.push_back(half_length_at(complex, tet));
            for (const FaceId face : nearest_faces(brep_, result_.mesh, cavity, tet)) near.insert(face);
        }
        if (thin.empty()) return {};
        const std::vector<Entity> place = as_parameter(near);
        const std::vector<Message> edges = short_edges_among(brep_, result_.mesh, cavity.nodes, thin);
        constexpr std::size_t few = 100;
        if (thin.size() > few) shorter.clear();
        if (edges.empty())
            return Obstacle{say<Code::thin_elements_remain>(thin.size(), near), place, std::move(shorter)};
        return Obstacle{say<Code::thin_elements_remain_beside>(thin.size(), near, edges), place};
    }

    static bool has_flat(const TetComplex& complex) {
        return std::any_of(complex.tets.begin(), complex.tets.end(),
                           [&](const auto& tet) { return tet[0] >= 0 && is_flat(complex, tet); });
    }

    /// Half of its longest side.
    static SizeSource half_length_at(const TetComplex& complex, const std::array<int, 4>& tet) {
        std::array<Vec3, 4> p;
        std::transform(tet.begin(), tet.end(), p.begin(),
                       [&](int v) { return complex.points[static_cast<std::size_t>(v)]; });
        double longest = 0;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j) longest = std::max(longest, distance(p[i], p[j]));
        return {0.25 * (p[0] + p[1] + p[2] + p[3]), 0.5 * longest};
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
    void move_nodes(const InterfaceRegion& region) {
        for (const auto& [node, vertex] : region.moved_nodes(result_.mesh)) {
            result_.mesh.points[node.index()] = region.complex.points[static_cast<std::size_t>(vertex)];
            result_.mesh.node_numbers[node.index()] = result_.mesh.next_node_number++;
            result_.moved.push_back(node);
        }
    }

    void append(const InterfaceRegion& region) {
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

    /// Inner kept nodes whose tets have all gone: the last new nodes take their places.
    void replace_unused(std::size_t nodes_before, std::size_t kept_tets) {
        if (result_.released_nodes.empty()) return;
        Mesh& mesh = result_.mesh;
        std::vector<char> is_unused(mesh.points.size(), 0);
        for (const auto& tet : result_.released_nodes)
            for (const NodeId n : tet) is_unused[n.index()] = mesh.entities[n.index()].dim == 3;
        for (const auto& tet : mesh.tets)
            for (const NodeId n : tet) is_unused[n.index()] = 0;
        std::vector<NodeId> place(mesh.points.size());
        for (std::size_t n = 0; n < nodes_before && mesh.points.size() > nodes_before; ++n) {
            if (!is_unused[n]) continue;
            const std::size_t last = mesh.points.size() - 1;
            place[last] = NodeId(n);
            mesh.points[n] = mesh.points[last], mesh.points.pop_back();
            mesh.entities[n] = mesh.entities[last], mesh.entities.pop_back();
            mesh.parameters[n] = mesh.parameters[last], mesh.parameters.pop_back();
            mesh.node_numbers[n] = mesh.node_numbers[last], mesh.node_numbers.pop_back();
            result_.moved.push_back(NodeId(n));
        }
        for (std::size_t t = kept_tets; t < mesh.tets.size(); ++t)
            for (NodeId& n : mesh.tets[t])
                if (place[n.index()].is_valid()) n = place[n.index()];
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

    VolumeResult result_;
    const Brep& brep_;
    const SizingField& sizing_;
    std::span<const Vec3> active_;
    const VolumeOptions& options_;
    RunContext& context_;
    std::size_t kept_nodes_;  ///< the first so many
    Projector projector_;
    WantedSize size_;
    Objective angles_, shapes_;
    BoundaryRecovery boundary_;
    std::vector<Cavity>& cavities_ = boundary_.cavities;
    std::vector<CavityFill>& fills_ = boundary_.fills;
    std::vector<std::uint8_t>& is_released_ = boundary_.is_released;
    std::vector<TetId>& rim_tets_ = boundary_.rim_tets;
    std::vector<InterfaceRegion> regions_;  ///< by cavity
};

}  // namespace

std::variant<VolumeResult, Obstacle> try_fill_solids(const Brep& brep, const SizingField& sizing, Mesh surface,
                                                     std::span<const Vec3> active, const VolumeOptions& options,
                                                     RunContext& context, const KeptRim& rim) {
    if (surface.order != 1) throw InputError(say<Code::solids_given_curved>());
    return Filling(brep, sizing, std::move(surface), active, options, context, rim).run();
}

VolumeResult fill_solids(const Brep& brep, const SizingField& sizing, Mesh surface, std::span<const Vec3> active,
                         const VolumeOptions& options, RunContext& context, const KeptRim& rim) {
    auto filled = try_fill_solids(brep, sizing, std::move(surface), active, options, context, rim);
    if (const auto* obstacle = std::get_if<Obstacle>(&filled)) throw MeshError(obstacle->message);
    return std::get<VolumeResult>(std::move(filled));
}

}  // namespace featuremesh

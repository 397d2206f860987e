// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/fill_surface.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "core/activity.h"
#include "core/errors.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/messages.h"
#include "surface/chart.h"
#include "surface/chart_domain.h"
#include "surface/distinct_sides.h"
#include "surface/edge_chains.h"
#include "surface/face_boundary.h"
#include "surface/fill_face.h"
#include "surface/flat_strips.h"
#include "surface/heartbeat.h"
#include "surface/opposite_nodes.h"
#include "surface/opposite_places.h"
#include "surface/surface_warnings.h"
#include "surface/triangle_crossings.h"
#include "surface/wanted_length.h"

namespace featuremesh {

namespace {

/// One face on its way; empty when nothing of it is left to fill.
struct FaceJob {
    std::unique_ptr<Chart> chart;
    FaceBoundary boundary;
    std::optional<ChartDomain> domain;
    FaceFilling filling;
};

/// Two edges whose chains cross, so that they run close beside one another, and the place of one of the crossing
/// pieces.
struct PieceBeside {
    EdgeId first, second;
    SizeSource piece;
};

class SurfaceFiller {
  public:
    /// `beside`: pairs of edges that get their nodes opposite one another; null: every edge is divided by itself.
    SurfaceFiller(const Brep& brep, const MergedEntities& merged, const WantedLength& sizing, const EdgesBeside* beside,
                  Mesh kept, RunContext& context)
        : brep_(brep),
          merged_(merged),
          sizing_(sizing),
          beside_(beside),
          mesh_(std::move(kept)),
          context_(context),
          first_new_node_(mesh_.node_count()),
          first_new_triangle_(mesh_.triangles.size()),
          chains_(brep, merged, sizing, beside ? *beside : EdgesBeside(), mesh_, context),
          jobs_(brep.face_count()) {}

    /// False when there are pieces of edges that cross and are not known to run beside one another: new_beside().
    bool bound() {
        sort_kept();
        return bound_faces();
    }
    const std::vector<PieceBeside>& new_beside() const { return new_beside_; }

    /// Edges of narrow strips of curved faces, see FaceFilling::beside.
    std::vector<std::array<EdgeId, 2>> edges_of_narrow_strips() const {
        std::vector<std::array<EdgeId, 2>> edges;
        for (const FaceJob& job : jobs_)
            edges.insert(edges.end(), job.filling.beside.begin(), job.filling.beside.end());
        return edges;
    }

    /// What was kept, and more behind it.
    Mesh take_mesh() { return std::move(mesh_); }

    /// `opposite`: places that get nodes, or nothing.
    SurfaceResult fill(const OppositePlaces* opposite) {
        fill_faces(opposite);
        chains_.add_segments(mesh_);
        separate_faces();
        for (std::size_t f = 0; f < jobs_.size(); ++f) append(FaceId(f));
        report_.new_nodes = mesh_.node_count() - first_new_node_;
        report_.new_triangles = mesh_.triangles.size() - first_new_triangle_;
        return {std::move(mesh_), std::move(report_), {}};
    }

  private:
    bool is_used(FaceId face) const { return brep_.is_meshed(face) && !merged_.is_flat[face.index()]; }

    void sort_kept() {
        kept_triangles_.resize(brep_.face_count());
        kept_nodes_.resize(brep_.face_count());
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
            kept_triangles_[mesh_.triangle_faces[t].index()].push_back(TriangleId(t));
        for (std::size_t n = 0; n < first_new_node_; ++n)
            if (mesh_.entities[n].dim == 2)
                kept_nodes_[static_cast<std::size_t>(mesh_.entities[n].index)].push_back(NodeId(n));
    }

    /// Faces whose kept triangles leave nothing to fill: the keys of their sides cancel in pairs and against those of
    /// the pieces of the face's edges.
    std::vector<char> find_complete() const {
        std::vector<std::uint64_t> sums(brep_.face_count(), 0);
        std::vector<char> is_complete(brep_.face_count(), 0);
        for (std::size_t t = 0; t < first_new_triangle_; ++t) {
            const std::size_t f = mesh_.triangle_faces[t].index();
            const auto& [a, b, c] = mesh_.triangles[t];
            sums[f] ^= node_pair_key(a, b) ^ node_pair_key(b, c) ^ node_pair_key(c, a);
        }
        for (std::size_t f = 0; f < is_complete.size(); ++f) {
            if (kept_triangles_[f].empty()) continue;
            for (const EdgeId e : brep_.edges_of(FaceId(f)))
                if (!brep_.is_degenerated(e) && !brep_.is_seam(e, FaceId(f)))
                    for (std::size_t i = 0; i < chains_[e].piece_count(); ++i)
                        sums[f] ^= node_pair_key(chains_[e].nodes[i], chains_[e].nodes[i + 1]);
            is_complete[f] = sums[f] == 0;
        }
        return is_complete;
    }

    /// Triangulates the boundary of every face. Chains of coarse pieces may cross in a face. If their edges are known
    /// to run beside one another, the pieces are halved, and all faces of these edges are triangulated again. If not,
    /// the result is false: new_beside() has these edges, to be divided with nodes opposite one another.
    bool bound_faces() {
        std::vector<FaceId> open;
        const std::vector<char> is_complete = find_complete();
        for (std::size_t f = 0; f < jobs_.size(); ++f)
            if (is_used(FaceId(f)) && !is_complete[f]) open.push_back(FaceId(f));
        constexpr int rounds = 14, rounds_of_all_pieces = 4;
        constexpr std::size_t most_crossings = 10000;  // more are chains that lie across one another all along
        std::set<EdgeId> refined;
        for (int round = 0; !open.empty(); ++round) {
            parallel_for(context_, open.size(), 1, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    const Activity activity(name_of(entity_of(open[i])));
                    bound(open[i]);
                }
            });
            if (beside_ && note_beside(open)) return false;
            std::set<FaceId> again;
            for (const FaceId f : open) {
                const FaceJob& job = jobs_[f.index()];
                if (!job.domain || job.domain->is_valid()) continue;
                const int most = job.domain->crossings().empty() ? rounds_of_all_pieces : rounds;
                if (round >= most || job.domain->crossings().size() > most_crossings || !refine(f, refined, again))
                    fail_crossing(f);
                again.insert(f);
            }
            open.assign(again.begin(), again.end());
        }
        if (!refined.empty()) report_.warnings.push_back(say<Code::finer_beside_crossing>(refined));
        return true;
    }

    /// Whether two chains cross that were not known to run beside one another.
    bool note_beside(const std::vector<FaceId>& faces) {
        for (const FaceId f : faces) {
            const FaceJob& job = jobs_[f.index()];
            if (!job.domain || job.domain->is_valid()) continue;
            for (const Crossing& c : job.domain->crossings()) {
                const BoundarySegment &a = job.boundary.segments[c.first], &b = job.boundary.segments[c.second];
                if (!a.edge.is_valid() || !b.edge.is_valid()) continue;
                const EdgeId first = merged_.edge_of[a.edge.index()], second = merged_.edge_of[b.edge.index()];
                if (first == second || beside_->has(first, second)) continue;
                const auto [p, q] = std::pair(mesh_.point(job.boundary.nodes[std::size_t(a.a)]),
                                              mesh_.point(job.boundary.nodes[std::size_t(a.b)]));
                new_beside_.push_back({first, second, {0.5 * (p + q), distance(p, q)}});
            }
        }
        return !new_beside_.empty();
    }

    void bound(FaceId face) {
        FaceJob& job = jobs_[face.index()];
        if (!job.chart) job.chart = std::make_unique<Chart>(brep_, face);
        job.boundary = find_boundary(brep_, face, *job.chart, chains_, mesh_, kept_triangles_[face.index()],
                                     kept_nodes_[face.index()]);
        job.domain.reset();
        if (!job.boundary.is_complete()) job.domain.emplace(job.boundary);
    }

    /// Halves the curved pieces that cross, or all where none does and the face lies inside out, as one beside an arc
    /// of a single piece may; false when there is nothing to halve.
    bool refine(FaceId face, std::set<EdgeId>& refined, std::set<FaceId>& again) {
        const FaceJob& job = jobs_[face.index()];
        std::set<EdgeChains::Piece, std::greater<>>
            pieces;  // the last first, so that halving does not renumber the others
        const auto add = [&](const BoundarySegment& segment) {
            if (segment.edge.is_valid() && !segment.is_pole)
                pieces.insert(chains_.owner_of({segment.edge, segment.piece}));
        };
        for (const Crossing& c : job.domain->crossings())
            for (const std::size_t s : {c.first, c.second}) add(job.boundary.segments[s]);
        if (job.domain->crossings().empty())
            for (const BoundarySegment& segment : job.boundary.segments) add(segment);
        bool halved = false;
        std::set<EdgeId> edges;
        for (const auto& [edge, piece] : pieces) {
            if (!chains_.halve(brep_, edge, piece, mesh_)) continue;
            halved = true;
            refined.insert(edge);
            edges.insert(edge);
            for (const EdgeId sharer : chains_.sharers_of(edge))
                for (const FaceId f : brep_.faces_of(sharer))
                    if (is_used(f)) again.insert(f);
        }
        for (const EdgeId edge : edges) chains_.update_sharers(brep_, edge, mesh_);
        return halved;
    }

    [[noreturn]] void fail_crossing(FaceId face) const {
        const FaceJob& job = jobs_[face.index()];
        if (!job.domain->crossings().empty()) {
            const Crossing& c = job.domain->crossings().front();
            const EdgeId a = job.boundary.segments[c.first].edge, b = job.boundary.segments[c.second].edge;
            if (a.is_valid() && b.is_valid())
                throw MeshError(say<Code::face_crosses_itself_at>(face, std::vector{a, b}));
        }
        throw MeshError(say<Code::face_crosses_itself>(face));
    }

    void fill_faces(const OppositePlaces* opposite) {
        std::vector<FaceId> open;
        for (std::size_t f = 0; f < jobs_.size(); ++f)
            if (jobs_[f].domain) open.push_back(FaceId(f));
        Heartbeat heart(context_);
        heart.set_share(0.2);
        std::atomic<std::size_t> done{0};
        const std::vector<std::array<double, 2>> none;
        parallel_for(context_, open.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Activity activity(name_of(entity_of(open[i])));
                FaceJob& job = jobs_[open[i].index()];
                const auto& places = opposite ? opposite->on_faces[open[i].index()] : none;
                job.filling =
                    fill_face(brep_, open[i], *job.chart, job.boundary, *job.domain, sizing_, mesh_, places, heart);
                job.domain.reset();
                heart.set_share(0.2 + 0.7 * static_cast<double>(++done) / static_cast<double>(open.size()));
                heart.beat();
            }
        });
    }

    void separate_faces() {
        std::vector<FilledFace> filled;
        for (FaceJob& job : jobs_)
            if (!job.filling.triangles.empty()) filled.push_back({job.chart.get(), &job.boundary, &job.filling});
        make_sides_distinct(filled, mesh_.segments, mesh_);
    }

    void append(FaceId face) {
        const FaceJob& job = jobs_[face.index()];
        const std::size_t boundary_count = job.boundary.points.size();
        const NodeId first(mesh_.node_count());
        for (std::size_t p = 0; p < job.filling.points.size(); ++p)
            mesh_.add_node(job.filling.points[p], entity_of(face), job.filling.parameters[p]);
        const auto node = [&](int c) {
            const auto i = static_cast<std::size_t>(c);
            return i < boundary_count ? job.boundary.nodes[i] : NodeId(first.index() + i - boundary_count);
        };
        for (const auto& t : job.filling.triangles) mesh_.add_triangle({node(t[0]), node(t[1]), node(t[2])}, face);
        if (!job.filling.triangles.empty())
            report_.min_angle_deg = std::min(report_.min_angle_deg, job.filling.smallest_angle * 180 / M_PI);
    }

    const Brep& brep_;
    const MergedEntities& merged_;
    const WantedLength& sizing_;
    const EdgesBeside* beside_;
    Mesh mesh_;
    RunContext& context_;
    std::size_t first_new_node_, first_new_triangle_;
    EdgeChains chains_;
    std::vector<FaceJob> jobs_;
    std::vector<std::vector<TriangleId>> kept_triangles_;
    std::vector<std::vector<NodeId>> kept_nodes_;
    SurfaceReport report_;
    std::vector<PieceBeside> new_beside_;
};

MeshExtent extent_of(const Mesh& mesh) {
    return {mesh.node_count(), mesh.segments.size(), mesh.triangles.size(), mesh.next_node_number,
            mesh.next_element_number};
}

void cut_back(Mesh& mesh, const MeshExtent& extent) {
    mesh.points.resize(extent.nodes);
    mesh.entities.resize(extent.nodes);
    mesh.parameters.resize(extent.nodes);
    mesh.node_numbers.resize(extent.nodes);
    mesh.segments.resize(extent.segments);
    mesh.segment_edges.resize(extent.segments);
    mesh.segment_numbers.resize(extent.segments);
    mesh.triangles.resize(extent.triangles);
    mesh.triangle_faces.resize(extent.triangles);
    mesh.triangle_numbers.resize(extent.triangles);
    mesh.next_node_number = extent.next_node_number;
    mesh.next_element_number = extent.next_element_number;
}

bool has_places(const OppositePlaces& opposite) {
    return std::any_of(opposite.on_faces.begin(), opposite.on_faces.end(), [](const auto& at) { return !at.empty(); });
}

/// Whether one of these was not known.
bool add_beside(const MergedEntities& merged, const std::vector<std::array<EdgeId, 2>>& edges, EdgesBeside& beside) {
    bool is_new = false;
    for (const auto& [a, b] : edges) {
        const EdgeId first = merged.edge_of[a.index()], second = merged.edge_of[b.index()];
        if (first == second || beside.has(first, second)) continue;
        beside.add(first, second);
        is_new = true;
    }
    return is_new;
}

/// Half the length of today wherever two triangles cross.
void ask_for_less(WantedLength& wanted, const Mesh& mesh, const TrianglePairs& crossings) {
    std::vector<SizeSource> shorter;
    for (const auto& pair : crossings)
        for (const TriangleId t : pair) {
            const auto& [a, b, c] = mesh.triangles[t.index()];
            const Vec3 p = mesh.point(a), q = mesh.point(b), r = mesh.point(c);
            shorter.push_back({(p + q + r) / 3, 0.5 * std::max({distance(p, q), distance(q, r), distance(r, p)})});
        }
    wanted.limit(shorter);
}

/// Whether shorter edges are worth another try. Thin walls part as the mesh gets finer; a shape that crosses itself
/// only gets more crossings.
class CrossingsWatch {
  public:
    void note(std::size_t crossings) {
        ++tries_;
        if (tries_ == 1) at_first_ = crossings;
        times_grown_ = tries_ > 1 && crossings > now_ ? times_grown_ + 1 : 0;
        in_vain_ = crossings < fewest_ ? 0 : in_vain_ + 1;
        fewest_ = std::min(fewest_, crossings);
        now_ = crossings;
    }
    /// `is_plain`: no edges have nodes opposite one another.
    bool is_worth_a_try(bool is_plain) const {
        constexpr int most = 5, most_of_few = 12;
        constexpr int most_in_vain = 4;  // in a row, without fewer than ever before
        constexpr std::size_t few = 100, many = 1000, hopeless = 20000;
        if (now_ > hopeless || (times_grown_ >= 2 && now_ > many) || in_vain_ >= most_in_vain) return false;
        return tries_ < (is_plain && now_ < std::max(at_first_, few) ? most_of_few : most);
    }

  private:
    int tries_ = 0, times_grown_ = 0, in_vain_ = 0;
    std::size_t at_first_ = 0, now_ = 0, fewest_ = std::numeric_limits<std::size_t>::max();
};

/// Fills the surface again, with other nodes or shorter edges, until none of its triangles cross.
class SurfaceLoop {
  public:
    SurfaceLoop(const Brep& brep, const SizingField& sizing, const MergedEntities& merged, const MeshExtent& before,
                NarrowFaces narrow, RunContext& context)
        : brep_(brep), merged_(merged), before_(before), narrow_(narrow), context_(context), wanted_(sizing) {}

    /// None where chains of their own may do better for edges beside one another; `kept` is given back then.
    std::optional<SurfaceResult> run(Mesh& kept) {
        for (;;) {
            SurfaceResult result = fill(std::move(kept));
            const Crossings found = crossing_triangles(brep_, result.mesh, before_.triangles, context_);
            if (found.within.empty() && (opposite_ || !find_opposite(result)))
                return finished(std::move(result), found.between);
            const bool goes_on = found.within.empty() || refine(result.mesh, found.within);
            kept = taken_back(std::move(result));
            if (!goes_on) return std::nullopt;
        }
    }

  private:
    bool may_lie_beside() const { return narrow_ != NarrowFaces::own_chains; }

    SurfaceResult fill(Mesh kept) {
        std::optional<SurfaceFiller> filler;
        while (
            !filler.emplace(brep_, merged_, wanted_, may_lie_beside() ? &beside_ : nullptr, std::move(kept), context_)
                 .bound()) {
            std::vector<SizeSource> shorter;
            for (const auto& [first, second, piece] : filler->new_beside()) {
                beside_.add(first, second);
                may_be_halved_ = narrow_ == NarrowFaces::opposite_nodes;
                if (narrow_ == NarrowFaces::shorter) shorter.push_back({piece.point, 0.5 * piece.size});
            }
            wanted_.limit(shorter);
            kept = filler->take_mesh();
            cut_back(kept, before_);
        }
        SurfaceResult result = filler->fill(opposite_ ? &*opposite_ : nullptr);
        narrow_strips_ = filler->edges_of_narrow_strips();
        result.kept = before_;
        result.report.has_opposite_nodes = !beside_.is_empty();
        result.report.may_be_halved = may_be_halved_;
        result.report.fillings = ++fillings_;
        return result;
    }

    /// Whether there are edges, or places across thin walls, that are to get nodes opposite one another. In a fan of
    /// needles each pair may make the next one a strip, so that looking for them ends.
    bool find_opposite(const SurfaceResult& result) {
        constexpr int most_looks = 6;
        opposite_ = find_opposite_places(brep_, result.mesh, before_.triangles, context_);
        if (may_lie_beside() && looks_++ < most_looks) {
            std::vector<std::array<EdgeId, 2>> edges = edges_of_flat_strips(result.mesh, before_.triangles);
            edges.insert(edges.end(), opposite_->edges.begin(), opposite_->edges.end());
            edges.insert(edges.end(), narrow_strips_.begin(), narrow_strips_.end());
            if (add_beside(merged_, edges, beside_)) opposite_.reset();
        }
        return !opposite_ || has_places(*opposite_);
    }

    /// Asks for shorter edges where triangles cross; false where only other nodes may help.
    bool refine(const Mesh& mesh, const TrianglePairs& crossings) {
        watch_.note(crossings.size());
        if (!watch_.is_worth_a_try(beside_.is_empty())) {
            if (beside_.is_empty()) throw MeshError(say<Code::faces_cross>(places_of_crossings(mesh, crossings)));
            return false;
        }
        const std::vector<Message> names = faces_that_cross(mesh, crossings);
        if (std::find(refined_.begin(), refined_.end(), names) == refined_.end()) refined_.push_back(names);
        ask_for_less(wanted_, mesh, crossings);
        opposite_.reset();
        return true;
    }

    SurfaceResult finished(SurfaceResult result, const TrianglePairs& between) const {
        std::vector<Message>& warnings = result.report.warnings;
        const auto add = [&](const std::vector<Message>& more) {
            warnings.insert(warnings.end(), more.begin(), more.end());
        };
        add(merged_.warnings());
        add(warnings_of(brep_, result.mesh, between));
        for (const std::vector<Message>& names : refined_)
            warnings.push_back(say<Code::finer_between_near_faces>(names));
        return result;
    }

    const Brep& brep_;
    const MergedEntities& merged_;
    const MeshExtent before_;
    const NarrowFaces narrow_;
    RunContext& context_;
    WantedLength wanted_;
    EdgesBeside beside_;
    std::vector<std::array<EdgeId, 2>> narrow_strips_;  ///< of the last filling
    std::optional<OppositePlaces> opposite_;  ///< across thin walls of the last mesh; none while its edges may change
    CrossingsWatch watch_;
    std::vector<std::vector<Message>> refined_;
    bool may_be_halved_ = false;
    int looks_ = 0, fillings_ = 0;
};

}  // namespace

Mesh taken_back(SurfaceResult filled) {
    cut_back(filled.mesh, filled.kept);
    return std::move(filled.mesh);
}

SurfaceResult fill_surface(const Brep& brep, const SizingField& sizing, Mesh kept, RunContext& context,
                           const SurfaceOptions& options) {
    const RunContext::Step step(context, "surface");
    const MeshExtent before = extent_of(kept);
    const std::optional<MergedEntities> own = options.known ? std::nullopt : std::optional<MergedEntities>(brep);
    const MergedEntities& merged = options.known ? *options.known : *own;
    if (auto result = SurfaceLoop(brep, sizing, merged, before, options.narrow, context).run(kept))
        return *std::move(result);
    return *SurfaceLoop(brep, sizing, merged, before, NarrowFaces::own_chains, context).run(kept);
}

}  // namespace featuremesh

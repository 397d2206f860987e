// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/fill_surface.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "brep/solid_probe.h"
#include "core/activity.h"
#include "core/dimension.h"
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

using TrianglePairs = std::vector<std::array<TriangleId, 2>>;

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

/// So many pairs are told of.
constexpr std::size_t most_pairs = 4;

template <class Pairs, class Say>
std::vector<Message> first_of(const Pairs& pairs, Say say_pair) {
    std::vector<Message> lines;
    for (const auto& pair : pairs) {
        if (lines.size() == most_pairs) {
            lines.push_back(say<Code::and_others>());
            break;
        }
        lines.push_back(say_pair(pair));
    }
    return lines;
}

/// Two faces whose triangles cross, how often, and the first triangle of the first of them that does.
struct FacePair {
    FaceId first, second;
    TriangleId where;
    std::size_t crossings = 0;
};

/// The pairs of faces whose triangles cross, most often first: faces that lie on one another before those that only
/// meet in an edge.
std::vector<FacePair> pairs_of(const Mesh& mesh, const TrianglePairs& crossings) {
    std::map<std::pair<FaceId, FaceId>, FacePair> found;
    for (const auto& [t, u] : crossings) {
        const auto [f, g] = std::minmax(mesh.triangle_faces[t.index()], mesh.triangle_faces[u.index()]);
        ++found.try_emplace({f, g}, FacePair{f, g, t}).first->second.crossings;
    }
    std::vector<FacePair> pairs;
    for (const auto& entry : found) pairs.push_back(entry.second);
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const auto& a, const auto& b) { return a.crossings > b.crossings; });
    return pairs;
}

std::vector<Message> names_of(const std::vector<FacePair>& pairs) {
    return first_of(pairs, [](const FacePair& pair) {
        return pair.first == pair.second ? say<Code::with_itself>(pair.first)
                                         : say<Code::pair>(pair.first, pair.second);
    });
}

std::vector<Message> places_of(const Mesh& mesh, const std::vector<FacePair>& pairs) {
    return first_of(pairs, [&](const FacePair& pair) {
        const auto& [a, b, c] = mesh.triangles[pair.where.index()];
        const Vec3 place = (mesh.point(a) + mesh.point(b) + mesh.point(c)) / 3;
        return pair.first == pair.second ? say<Code::with_itself_near>(pair.first, place)
                                         : say<Code::pair_near>(pair.first, pair.second, place);
    });
}

Message warning_of_contact(const Brep& brep, const Mesh& mesh, const TrianglePairs& crossings) {
    const std::vector<Message> faces = names_of(pairs_of(mesh, crossings));
    const auto is_shell = [&](TriangleId t) { return brep.is_free(mesh.triangle_faces[t.index()]); };
    if (std::any_of(crossings.begin(), crossings.end(),
                    [&](const auto& pair) { return is_shell(pair[0]) || is_shell(pair[1]); }))
        return say<Code::sheets_touch>(faces);
    std::set<std::pair<SolidId, SolidId>> solids;
    for (const auto& [t, u] : crossings) {
        const auto solid = [&](TriangleId triangle) {
            const auto beside = brep.solids_beside(mesh.triangle_faces[triangle.index()]);
            return beside[0].is_valid() ? beside[0] : beside[1];
        };
        solids.insert(std::minmax(solid(t), solid(u)));
    }
    const auto say_pair = [](const auto& pair) { return say<Code::pair>(pair.first, pair.second); };
    return say<Code::solids_touch>(first_of(solids, say_pair), faces);
}

/// Shells and beams whose first element has its middle inside a solid that does not know them.
std::vector<Message> warnings_of_enclosed(const Brep& brep, const Mesh& mesh) {
    std::vector<std::unique_ptr<SolidProbe>> probes(brep.solid_count());
    std::vector<Message> places;
    const auto look = [&](Entity entity, const Vec3& p) {
        for (std::size_t s = 0; s < probes.size(); ++s) {
            if (!probes[s]) probes[s] = std::make_unique<SolidProbe>(brep, SolidId(s));
            if (probes[s]->containment_of(p) != Containment::inside) continue;
            places.push_back(say<Code::one_in_other>(entity, SolidId(s)));
            return;
        }
    };
    std::vector<char> is_seen_face(brep.face_count(), 0), is_seen_edge(brep.edge_count(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const FaceId face = mesh.triangle_faces[t];
        if (!brep.is_free(face) || std::exchange(is_seen_face[face.index()], 1)) continue;
        const auto& [a, b, c] = mesh.triangles[t];
        look(entity_of(face), (mesh.point(a) + mesh.point(b) + mesh.point(c)) / 3);
    }
    for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
        const EdgeId edge = mesh.segment_edges[s];
        if (!brep.is_free(edge) || std::exchange(is_seen_edge[edge.index()], 1)) continue;
        look(entity_of(edge), (mesh.point(mesh.segments[s][0]) + mesh.point(mesh.segments[s][1])) / 2);
    }
    if (places.empty()) return {};
    return {say<Code::shells_in_solids>(places)};
}

/// What lies beside the solids of a compound, or beside its faces where those are meshed.
std::vector<Message> warnings_of_loose(const Brep& brep) {
    if (brep.dimension() == Dimension::edges) return {};
    std::vector<Entity> loose;
    for (std::size_t f = 0; f < brep.face_count(); ++f)
        if (!brep.is_meshed(FaceId(f))) loose.push_back(entity_of(FaceId(f)));
    for (std::size_t e = 0; e < brep.edge_count(); ++e)
        if (brep.faces_of(EdgeId(e)).empty() && !brep.is_meshed(EdgeId(e))) loose.push_back(entity_of(EdgeId(e)));
    if (loose.empty()) return {};
    if (brep.dimension() == Dimension::faces) return {say<Code::loose_beside_faces>(loose)};
    return {say<Code::loose_beside_solids>(loose)};
}

}  // namespace

Mesh taken_back(SurfaceResult filled) {
    cut_back(filled.mesh, filled.kept);
    return std::move(filled.mesh);
}

SurfaceResult fill_surface(const Brep& brep, const SizingField& sizing, Mesh kept, RunContext& context,
                           const SurfaceOptions& options) {
    const RunContext::Step step(context, "surface");
    constexpr int attempts = 5, attempts_worth_more = 12;
    constexpr int most_in_vain = 4;      // attempts in a row after which no fewer triangles cross than ever before
    constexpr int looks_for_strips = 6;  // nodes opposite one another may make the next strip one, all along a shape
    constexpr std::size_t few = 100, many = 1000, hopeless = 20000;
    std::size_t crossings_at_first = 0, crossings_before = 0;
    std::size_t fewest_crossings = std::numeric_limits<std::size_t>::max();
    int times_grown = 0, in_vain = 0, looks = 0, fillings = 0;
    const MeshExtent before = extent_of(kept);
    const std::optional<MergedEntities> own = options.known ? std::nullopt : std::optional<MergedEntities>(brep);
    const MergedEntities& merged = options.known ? *options.known : *own;
    WantedLength wanted(sizing);
    EdgesBeside beside;
    bool may_be_halved = false;
    std::optional<OppositePlaces> opposite;  // across thin walls of the last mesh; none while its edges may change
    std::vector<std::vector<Message>> refined;
    for (int attempt = 1;; ++attempt) {
        std::optional<SurfaceFiller> filler;
        const EdgesBeside* known_beside = options.narrow == NarrowFaces::own_chains ? nullptr : &beside;
        while (!filler.emplace(brep, merged, wanted, known_beside, std::move(kept), context).bound()) {
            std::vector<SizeSource> shorter;
            for (const auto& [first, second, piece] : filler->new_beside()) {
                beside.add(first, second);
                may_be_halved = options.narrow == NarrowFaces::opposite_nodes;
                if (options.narrow == NarrowFaces::shorter) shorter.push_back({piece.point, 0.5 * piece.size});
            }
            wanted.limit(shorter);
            kept = filler->take_mesh();
            cut_back(kept, before);
        }
        SurfaceResult result = filler->fill(opposite ? &*opposite : nullptr);
        result.kept = before;
        result.report.has_opposite_nodes = !beside.is_empty();
        result.report.may_be_halved = may_be_halved;
        result.report.fillings = ++fillings;
        const Crossings found = crossing_triangles(brep, result.mesh, before.triangles, context);
        const TrianglePairs& crossings = found.within;
        if (crossings.empty() && !opposite) {
            opposite = find_opposite_places(brep, result.mesh, before.triangles, context);
            if (known_beside && looks++ < looks_for_strips) {
                std::vector<std::array<EdgeId, 2>> edges = edges_of_flat_strips(result.mesh, before.triangles);
                edges.insert(edges.end(), opposite->edges.begin(), opposite->edges.end());
                const std::vector<std::array<EdgeId, 2>> narrow = filler->edges_of_narrow_strips();
                edges.insert(edges.end(), narrow.begin(), narrow.end());
                if (add_beside(merged, edges, beside)) opposite.reset();
            }
            if (!opposite || has_places(*opposite)) {
                kept = taken_back(std::move(result));
                --attempt;
                continue;
            }
        }
        if (crossings.empty()) {
            std::vector<Message> notes = merged.warnings();
            if (!found.between.empty()) notes.push_back(warning_of_contact(brep, result.mesh, found.between));
            for (const Message& line : warnings_of_enclosed(brep, result.mesh)) notes.push_back(line);
            for (const Message& line : warnings_of_loose(brep)) notes.push_back(line);
            result.report.warnings.insert(result.report.warnings.end(), notes.begin(), notes.end());
            for (const std::vector<Message>& names : refined)
                result.report.warnings.push_back(say<Code::finer_between_near_faces>(names));
            return result;
        }
        const std::vector<FacePair> pairs = pairs_of(result.mesh, crossings);
        // Thin walls part as the mesh gets finer; a shape that crosses itself only gets more crossings.
        if (attempt == 1) crossings_at_first = crossings.size();
        times_grown = attempt > 1 && crossings.size() > crossings_before ? times_grown + 1 : 0;
        crossings_before = crossings.size();
        in_vain = crossings.size() < fewest_crossings ? 0 : in_vain + 1;
        fewest_crossings = std::min(fewest_crossings, crossings.size());
        const bool is_hopeless = crossings.size() > hopeless || (times_grown >= 2 && crossings.size() > many);
        const bool is_worth_more = crossings.size() < std::max(crossings_at_first, few) && beside.is_empty();
        const bool is_last = attempt >= (is_worth_more ? attempts_worth_more : attempts) || in_vain >= most_in_vain;
        if ((is_last || is_hopeless) && !beside.is_empty()) {
            SurfaceOptions other = options;
            other.known = &merged, other.narrow = NarrowFaces::own_chains;
            return fill_surface(brep, sizing, taken_back(std::move(result)), context, other);
        }
        if (is_last || is_hopeless) throw MeshError(say<Code::faces_cross>(places_of(result.mesh, pairs)));
        const std::vector<Message> names = names_of(pairs);
        if (std::find(refined.begin(), refined.end(), names) == refined.end()) refined.push_back(names);
        ask_for_less(wanted, result.mesh, crossings);
        opposite.reset();
        kept = std::move(result.mesh);
        cut_back(kept, before);
    }
}

}  // namespace featuremesh

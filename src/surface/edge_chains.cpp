// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_chains.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "brep/occt_geometry.h"
#include "brep/vertex_places.h"
#include "core/activity.h"
#include "core/errors.h"
#include "core/messages.h"
#include "core/numbers_in_words.h"

namespace featuremesh {

namespace {

/// Length over wanted length, arc length and turning of a piece of a curve, cumulated at equal steps of the parameter.
class Measure {
  public:
    Measure(const BRepAdaptor_Curve& curve, const WantedLength& sizing, double first, double last)
        : curve_(curve),
          sizing_(sizing),
          is_line_(curve.GetType() == GeomAbs_Line),
          least_length_(std::min(2 * curve.Tolerance(), sizing.largest())) {
        const int steps = is_line_ ? (sizing.is_uniform() ? 1 : 8) : 32;
        for (int i = 0; i < steps; ++i)
            add(first + (last - first) * i / steps, first + (last - first) * (i + 1) / steps, 0);
        t_.push_back(last);
    }

    double metric_length() const { return metric_.back(); }
    double arc_length() const { return arc_length_; }
    double turning() const { return turning_; }
    bool is_line() const { return is_line_; }

    /// The parameter where the metric length is `share` of the whole.
    double at_share(double share) const {
        const double wanted = share * metric_.back();
        const auto above = std::upper_bound(metric_.begin() + 1, metric_.end() - 1, wanted);
        const auto i = static_cast<std::size_t>(above - metric_.begin()) - 1;
        const double width = metric_[i + 1] - metric_[i];
        return t_[i] + (t_[i + 1] - t_[i]) * (width > 0 ? (wanted - metric_[i]) / width : 0.5);
    }

    /// Those between equal shares, `pieces` - 1 of them.
    std::vector<double> at_shares(int pieces) const {
        std::vector<double> t;
        for (int k = 1; k < pieces; ++k) t.push_back(at_share(static_cast<double>(k) / pieces));
        return t;
    }

  private:
    /// Steps are halved until each is a fraction of the wanted length, so that the cost goes with the number of nodes.
    void add(double start, double end, int depth) {
        // Two Gauss points per step: exact for cubic integrands, the same from either end.
        const double offset = 0.5 / std::sqrt(3.0);
        double sum = 0;
        std::array<Vec3, 2> directions;
        std::array<double, 2> lengths;
        for (const int i : {0, 1}) {
            gp_Pnt p;
            gp_Vec d;
            curve_.D1(start + (0.5 + (i == 0 ? -offset : offset)) * (end - start), p, d);
            directions[static_cast<std::size_t>(i)] = {d.X(), d.Y(), d.Z()};
            lengths[static_cast<std::size_t>(i)] = 0.5 * d.Magnitude() * (end - start);
            sum += lengths[static_cast<std::size_t>(i)] / std::max(sizing_.at(to_vec3(p)), least_length_);
        }
        const bool is_even = is_line_ && sizing_.is_uniform();
        if (sum > 0.5 && depth < 12 && !is_even) {
            add(start, 0.5 * (start + end), depth + 1);
            add(0.5 * (start + end), end, depth + 1);
            return;
        }
        for (const Vec3& direction : directions) turn_to(direction);
        t_.push_back(start);
        arc_length_ += lengths[0] + lengths[1];
        metric_.push_back(metric_.back() + sum);
    }

    void turn_to(const Vec3& direction) {
        if (!(squared_length(direction) > 0)) return;
        if (squared_length(last_direction_) > 0)
            turning_ += std::atan2(length(cross(last_direction_, direction)), dot(last_direction_, direction));
        last_direction_ = direction;
    }

    const BRepAdaptor_Curve& curve_;
    const WantedLength& sizing_;
    bool is_line_;
    double least_length_;  ///< of a loosely fitted edge: pieces shorter than it is known follow its loops
    double arc_length_ = 0;
    double turning_ = 0;
    Vec3 last_direction_{};
    std::vector<double> t_, metric_{0};  ///< at the steps' ends
};

/// What the mesh already has on the edges.
struct KeptOnEdges {
    std::vector<std::vector<NodeId>> nodes;                    ///< by edge
    std::vector<std::vector<std::array<NodeId, 2>>> segments;  ///< by edge
};

KeptOnEdges kept_on_edges(const Brep& brep, const Mesh& mesh) {
    KeptOnEdges kept;
    kept.nodes.resize(brep.edge_count());
    kept.segments.resize(brep.edge_count());
    for (std::size_t n = 0; n < mesh.node_count(); ++n)
        if (mesh.entities[n].dim == 1)
            kept.nodes[static_cast<std::size_t>(mesh.entities[n].index)].push_back(NodeId(n));
    for (std::size_t s = 0; s < mesh.segments.size(); ++s)
        kept.segments[mesh.segment_edges[s].index()].push_back(mesh.segments[s]);
    return kept;
}

/// Where nodes on the edges stay whatever their length is to be: at vertices, and where they are kept.
std::vector<Vec3> stops_on(const std::vector<EdgeId>& edges, const Brep& brep, const MergedEntities& merged,
                           const KeptOnEdges& kept, const Mesh& mesh) {
    std::vector<Vec3> stops;
    for (const EdgeId edge : edges) {
        for (const VertexId v : brep.ends_of(edge))
            if (v.is_valid()) stops.push_back(brep.point_of(v));
        for (const auto& [t, v] : merged.vertices_on[edge.index()]) stops.push_back(brep.point_of(v));
        for (const NodeId n : kept.nodes[edge.index()]) stops.push_back(mesh.point(n));
    }
    return stops;
}

bool is_meshed(const Brep& brep, const MergedEntities& merged, VertexId vertex) {
    const auto edges = brep.edges_of(vertex);
    const auto faces = brep.faces_at(entity_of(vertex));
    return std::any_of(faces.begin(), faces.end(),
                       [&](FaceId face) { return brep.is_meshed(face) && !merged.is_flat[face.index()]; }) ||
           std::any_of(edges.begin(), edges.end(),
                       [&](EdgeId edge) { return brep.is_meshed(edge) && !merged.is_point[edge.index()]; });
}

/// The node of every used vertex. Nodes are made in the order of the vertices' numbers, except for the two ends of an
/// edge so short that a projection cannot tell them apart: these are made in the order of the edge. Other edges sort
/// their nodes by parameter, then by number, and get the right order there, too.
class VertexNodes {
  public:
    VertexNodes(const Brep& brep, const MergedEntities& merged, Mesh& mesh)
        : brep_(brep), merged_(merged), mesh_(mesh), nodes_(brep.vertex_count()), is_asked_(brep.vertex_count(), 0) {}

    std::vector<NodeId> make() {
        for (std::size_t n = 0; n < mesh_.node_count(); ++n)
            if (mesh_.entities[n].dim == 0) shared(VertexId(std::size_t(mesh_.entities[n].index))) = NodeId(n);
        for (std::size_t v = 0; v < nodes_.size(); ++v) number(VertexId(v));
        for (std::size_t v = 0; v < nodes_.size(); ++v) nodes_[v] = shared(VertexId(v));
        return std::move(nodes_);
    }

  private:
    NodeId& shared(VertexId vertex) { return nodes_[merged_.vertex_of[vertex.index()].index()]; }

    void number(VertexId vertex) {
        if (is_asked_[vertex.index()]++ || shared(vertex).is_valid()) return;
        if (!is_meshed(brep_, merged_, vertex)) return;
        for (const EdgeId e : brep_.edges_of(vertex)) {
            const auto [first, last] = brep_.ends_of(e);
            if (last == vertex && first.is_valid() && first != last &&
                distance(brep_.point_of(first), brep_.point_of(last)) < brep_.tolerances().contact())
                number(first);
        }
        const VertexId owner = merged_.vertex_of[vertex.index()];
        if (!shared(owner).is_valid()) shared(owner) = mesh_.add_node(brep_.point_of(owner), entity_of(owner));
    }

    const Brep& brep_;
    const MergedEntities& merged_;
    Mesh& mesh_;
    std::vector<NodeId> nodes_;
    std::vector<char> is_asked_;
};

/// Fewest pieces by which a whole edge stays a curve of its own: a quarter turn at most per piece, a closed one three.
int fewest_pieces(const Measure& measure, bool is_closed) {
    const int by_turning = static_cast<int>(std::ceil(measure.turning() / (0.5 * M_PI) - 0.05));
    return std::max(is_closed ? 3 : 1, by_turning);
}

/// Whether one piece of a whole edge would be the same segment as one piece of another. One that is twice as long as
/// the shorter one turns so far that it has two pieces anyway.
bool is_beside_twin(EdgeId edge, const Measure& measure, const std::vector<EdgeId>& twins, const Brep& brep,
                    const WantedLength& sizing) {
    if (measure.is_line()) return false;
    return std::any_of(twins.begin(), twins.end(), [&](EdgeId twin) {
        if (twin == edge) return false;
        const BRepAdaptor_Curve curve(brep.edge(twin));
        const Measure other(curve, sizing, curve.FirstParameter(), curve.LastParameter());
        return other.arc_length() < 2 * measure.arc_length();
    });
}

/// A vertex beyond the edge's end is not found as a node of the edge: alone with the other end it would leave no piece
/// that carries the edge's loads.
bool misses_vertex(const Brep& brep, EdgeId edge) {
    const auto ends = brep.ends_of(edge);
    const auto is_beyond = [&](std::size_t end) {
        return is_loose(brep.vertex(ends[end])) &&
               distance_beyond_end(brep.edge(edge), end == 0, brep.point_of(ends[end])) > Precision::Confusion();
    };
    return is_beyond(0) || is_beyond(1);
}

/// At the close of a curve that is not periodic a point has the parameters of both its ends: who looks for the nodes of
/// an edge by them may find none there, and a piece must be left without it.
bool ends_at_close(const TopoDS_Edge& edge) {
    double first, last;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull() || curve->IsPeriodic() || !curve->IsClosed()) return false;
    return first == curve->FirstParameter() || last == curve->LastParameter();
}

/// Halves go up whatever the rounding errors, so that equal edges get equal chains.
int rounded(double pieces) { return static_cast<int>(std::floor(pieces + 0.5 + 1e-6)); }

std::vector<std::vector<ChainNeighbours::Place>> places_of(const std::vector<EdgeChain>& chains, const Mesh& mesh) {
    std::vector<std::vector<ChainNeighbours::Place>> places(chains.size());
    for (std::size_t e = 0; e < chains.size(); ++e)
        for (std::size_t i = 0; i < chains[e].nodes.size(); ++i)
            places[e].push_back({chains[e].t[i], mesh.point(chains[e].nodes[i])});
    return places;
}

void check_order(const EdgeChain& chain, EdgeId edge) {
    if (std::is_sorted(chain.t.begin(), chain.t.end(), std::less_equal<>())) return;
    throw MeshError(say<Code::kept_nodes_out_of_order>(edge));
}

/// The kept part of a chain: ends, nodes of vertices on the edge and kept nodes between them, and which neighbours are
/// joined by a kept segment.
EdgeChain kept_chain(const std::array<double, 2>& range, EdgeId edge, const std::array<NodeId, 2>& ends,
                     std::vector<std::pair<double, NodeId>> inner, const std::vector<NodeId>& kept_nodes,
                     const std::vector<std::array<NodeId, 2>>& kept_segments, const Mesh& mesh) {
    for (const NodeId n : kept_nodes) inner.emplace_back(mesh.parameters[n.index()][0], n);
    std::sort(inner.begin(), inner.end());
    EdgeChain chain;
    chain.nodes.push_back(ends[0]), chain.t.push_back(range[0]);
    for (const auto& [t, n] : inner) chain.nodes.push_back(n), chain.t.push_back(t);
    chain.nodes.push_back(ends[1]), chain.t.push_back(range[1]);
    check_order(chain, edge);
    std::vector<std::array<NodeId, 2>> segments = kept_segments;
    std::sort(segments.begin(), segments.end());
    std::size_t found = 0;
    for (std::size_t i = 0; i + 1 < chain.nodes.size(); ++i) {
        const bool kept =
            std::binary_search(segments.begin(), segments.end(), std::array{chain.nodes[i], chain.nodes[i + 1]});
        chain.is_kept.push_back(kept);
        found += kept;
    }
    if (found != segments.size()) throw MeshError(say<Code::kept_segments_off_edge>(edge));
    return chain;
}

}  // namespace

EdgeChains::EdgeChains(const Brep& brep, const MergedEntities& merged, const WantedLength& sizing,
                       const EdgesBeside& beside, Mesh& mesh, RunContext& context)
    : merged_(merged),
      projector_(brep),
      chains_(brep.edge_count()),
      vertex_nodes_(VertexNodes(brep, merged, mesh).make()) {
    const KeptOnEdges kept = kept_on_edges(brep, mesh);
    const std::size_t first_new_node = mesh.node_count();
    std::map<std::array<NodeId, 2>, std::vector<EdgeId>> between;
    const auto shared_ends = [&](EdgeId edge) {
        const auto [first, last] = brep.ends_of(edge);
        const auto node = [&](VertexId v) { return v.is_valid() ? node_of(v) : NodeId(); };
        return std::array<NodeId, 2>{std::min(node(first), node(last)), std::max(node(first), node(last))};
    };
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        if (merged.edge_of[e] != EdgeId(e) || merged.is_point[e] || brep.is_degenerated(EdgeId(e))) continue;
        between[shared_ends(EdgeId(e))].emplace_back(e);
    }
    std::vector<EdgeId> followers;
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        const EdgeId edge(e);
        const Activity activity(name_of(entity_of(edge)));
        if (e % 64 == 0) context.progress(0.1 * static_cast<double>(e) / static_cast<double>(brep.edge_count()));
        if (brep.is_degenerated(edge) || is_point(edge) || !brep.is_meshed(edge)) continue;
        if (merged.edge_of[e] != edge) {
            if (!kept.nodes[e].empty() || !kept.segments[e].empty())
                throw MeshError(say<Code::kept_nodes_of_other_edge>(edge));
            followers.push_back(edge);
            continue;
        }
        auto ends = brep.ends_of(edge);
        if (!ends[0].is_valid() || !ends[1].is_valid()) throw MeshError(say<Code::edge_without_ends>(edge));
        std::array<double, 2> range;
        BRep_Tool::Range(brep.edge(edge), range[0], range[1]);
        std::vector<std::pair<double, NodeId>> passed;
        for (const auto& [t, vertex] : merged.vertices_on[e]) passed.emplace_back(t, node_of(vertex));
        for (const NodeId n : kept.nodes[e])
            if (merged.owner_at(edge, mesh.parameters[n.index()][0]) != edge)
                throw MeshError(say<Code::kept_nodes_of_other_edge>(edge));
        const EdgeChain base = kept_chain(range, edge, {node_of(ends[0]), node_of(ends[1])}, std::move(passed),
                                          kept.nodes[e], kept.segments[e], mesh);
        const auto nodes = shared_ends(edge);
        const std::vector<EdgeId> others = beside.of(edge);
        const std::vector<Vec3> stops = stops_on(others, brep, merged, kept, mesh);
        EdgeChain& chain = chains_[e];
        const bool is_whole = base.is_kept.size() == 1;
        std::optional<BRepAdaptor_Curve> curve;  // most edges of an update need none
        if (std::count(base.is_kept.begin(), base.is_kept.end(), 0) > 0) curve.emplace(brep.edge(edge));
        for (std::size_t i = 0; i < base.is_kept.size(); ++i) {
            chain.nodes.push_back(base.nodes[i]), chain.t.push_back(base.t[i]);
            if (base.is_kept[i] || merged.owner_at(edge, base.t[i]) != edge) {
                chain.is_kept.push_back(1);
                continue;
            }
            const Measure measure(*curve, sizing, base.t[i], base.t[i + 1]);
            int fewest = fewest_pieces(measure, is_whole && nodes[0] == nodes[1]);
            if (fewest == 1 && is_whole && is_beside_twin(edge, measure, between[nodes], brep, sizing)) fewest = 2;
            int pieces = std::max(fewest, rounded(measure.metric_length()));
            constexpr double least_divided = 0.1;  // wanted lengths; no load is worth the elements at shorter halves
            if (pieces == 1 && is_whole && measure.metric_length() > least_divided &&
                (misses_vertex(brep, edge) || ends_at_close(brep.edge(edge))))
                pieces = 2;
            std::vector<double> parameters;
            if (!others.empty())
                parameters = parameters_beside(brep, sizing, edge, {base.t[i], base.t[i + 1]}, others, stops, mesh);
            if (others.empty() || parameters.size() + 1 < static_cast<std::size_t>(fewest))
                parameters = measure.at_shares(pieces);
            for (const double t : parameters) {
                chain.nodes.push_back(mesh.add_node(to_vec3(curve->Value(t)), entity_of(edge), {t, 0}));
                chain.t.push_back(t);
            }
            chain.is_kept.insert(chain.is_kept.end(), parameters.size() + 1, 0);
        }
        chain.nodes.push_back(base.nodes.back()), chain.t.push_back(base.t.back());
    }
    keep_off_contacts(brep, sizing, first_new_node, mesh, context);
    for (std::size_t e = 0; e < chains_.size(); ++e) borrow_stretches(brep, EdgeId(e), mesh);
    for (const EdgeId edge : followers) follow_owner(brep, edge, mesh);
}

std::vector<double> EdgeChains::parameters_beside(const Brep& brep, const WantedLength& sizing, EdgeId edge,
                                                  const std::array<double, 2>& between,
                                                  const std::vector<EdgeId>& others, std::span<const Vec3> stops,
                                                  const Mesh& mesh) const {
    std::vector<Vec3> nodes;
    for (const EdgeId other : others)
        for (const NodeId n : chains_[other.index()].nodes) nodes.push_back(mesh.point(n));
    const BRepAdaptor_Curve curve(brep.edge(edge));
    constexpr double most_off = 0.1;  // of the wanted length
    std::vector<double> parameters;
    double begin = between[0];
    const auto fill_to = [&](double end) {
        constexpr double longest = 1.7;  // wanted lengths, of a piece between nodes that are opposite others
        std::vector<double> inner = parameters_opposite(projector_, sizing, edge, {begin, end}, nodes);
        bool is_even = true;
        double last = begin;
        for (std::size_t i = 0; i <= inner.size() && is_even; ++i) {
            const double next = i < inner.size() ? inner[i] : end;
            is_even = Measure(curve, sizing, last, next).metric_length() <= longest;
            last = next;
        }
        if (!is_even) {
            const Measure measure(curve, sizing, begin, end);
            inner = measure.at_shares(std::max(fewest_pieces(measure, false), rounded(measure.metric_length())));
        }
        parameters.insert(parameters.end(), inner.begin(), inner.end());
        begin = end;
    };
    for (const double stop : parameters_opposite(projector_, sizing, edge, between, stops)) {
        fill_to(stop);
        parameters.push_back(stop);
    }
    fill_to(between[1]);
    // as far as the kernel says that the edges may be off, there is no telling which is on which side
    const auto is_in_one_place = [&](double t) {
        const Vec3 p = to_vec3(curve.Value(t));
        return std::any_of(others.begin(), others.end(), [&](EdgeId other) {
            const double off = std::max(BRep_Tool::Tolerance(brep.edge(edge)), BRep_Tool::Tolerance(brep.edge(other)));
            return projector_.nearest(other, p).distance < std::min(off, most_off * sizing.at(p));
        });
    };
    std::erase_if(parameters, is_in_one_place);
    return parameters;
}

void EdgeChains::keep_off_contacts(const Brep& brep, const WantedLength& sizing, std::size_t first_new_node, Mesh& mesh,
                                   const RunContext& context) {
    std::optional<ChainNeighbours> neighbours;  // many updates need none
    for (std::size_t e = 0; e < chains_.size(); ++e) {
        if (e % 64 == 0) context.check_cancelled();
        EdgeChain& chain = chains_[e];
        const auto is_free = [&](std::size_t i) {
            const std::size_t n = chain.nodes[i].index();
            return n >= first_new_node && mesh.entities[n] == entity_of(EdgeId(e));
        };
        for (std::size_t begin = 1; begin + 1 < chain.nodes.size(); ++begin) {
            std::size_t end = begin;
            while (is_free(end)) ++end;
            if (end == begin) continue;
            if (!neighbours) neighbours.emplace(brep, projector_, places_of(chains_, mesh));
            begin = keep_off_contacts(brep, sizing, *neighbours, EdgeId(e), {begin, end}, mesh);
        }
    }
}

std::size_t EdgeChains::keep_off_contacts(const Brep& brep, const WantedLength& sizing,
                                          const ChainNeighbours& neighbours, EdgeId edge,
                                          const std::array<std::size_t, 2>& run, Mesh& mesh) {
    const auto [begin, end] = run;
    EdgeChain& chain = chains_[edge.index()];
    const auto touches = [&](const Vec3& p) { return neighbours.is_on_another(edge, p, brep.tolerances().contact()); };
    if (std::none_of(chain.nodes.begin() + std::ptrdiff_t(begin), chain.nodes.begin() + std::ptrdiff_t(end),
                     [&](NodeId n) { return touches(mesh.point(n)); }))
        return end;
    const BRepAdaptor_Curve curve(brep.edge(edge));
    const Measure measure(curve, sizing, chain.t[begin - 1], chain.t[end]);
    const std::size_t pieces = end - begin + 1;
    constexpr std::size_t most_added = 3;
    for (std::size_t more = pieces + 1; more <= pieces + most_added; ++more) {
        std::vector<double> t;
        for (std::size_t k = 1; k < more; ++k) t.push_back(measure.at_share(double(k) / double(more)));
        if (std::any_of(t.begin(), t.end(), [&](double at) { return touches(to_vec3(curve.Value(at))); })) continue;
        for (std::size_t k = 0; k < t.size(); ++k) {
            const std::size_t i = begin + k;
            const Vec3 p = to_vec3(curve.Value(t[k]));
            if (i < end) {
                const std::size_t n = chain.nodes[i].index();
                chain.t[i] = t[k], mesh.points[n] = p, mesh.parameters[n] = {t[k], 0};
                continue;
            }
            const auto at = static_cast<std::ptrdiff_t>(i);
            chain.nodes.insert(chain.nodes.begin() + at, mesh.add_node(p, entity_of(edge), {t[k], 0}));
            chain.t.insert(chain.t.begin() + at, t[k]);
            chain.is_kept.insert(chain.is_kept.begin() + at, 0);
        }
        return begin + t.size();
    }
    return end;
}

void EdgeChains::follow_owner(const Brep& brep, EdgeId edge, const Mesh& mesh) {
    const EdgeId owner = merged_.edge_of[edge.index()];
    chains_[edge.index()] = {};
    if (chains_[owner.index()].nodes.empty()) return;
    const BRepAdaptor_Curve curve(brep.edge(edge));
    const auto ends = brep.ends_of(edge);
    chains_[edge.index()] = stretch_of(owner, {node_of(ends[0]), node_of(ends[1])}, edge,
                                       {curve.FirstParameter(), curve.LastParameter()}, mesh);
}

EdgeChain EdgeChains::stretch_of(EdgeId owner, const std::array<NodeId, 2>& ends, EdgeId edge,
                                 const std::array<double, 2>& range, const Mesh& mesh) const {
    const std::vector<NodeId>& nodes = chains_[owner.index()].nodes;
    const auto place = [&](NodeId n) { return std::find(nodes.begin(), nodes.end(), n); };
    auto [first, last] = std::minmax({place(ends[0]), place(ends[1])});
    if (last == nodes.end()) throw MeshError(say<Code::edge_ends_elsewhere>(edge, owner));
    const bool is_closed = ends[0] == ends[1];
    if (is_closed) last = nodes.end() - 1;
    EdgeChain chain;
    chain.nodes.assign(first, last + 1);
    chain.is_kept.assign(chain.nodes.size() - 1, 1);
    for (const NodeId n : chain.nodes) chain.t.push_back(projector_.nearest(edge, mesh.point(n)).t);
    if (is_closed ? chain.t[1] > chain.t[chain.t.size() - 2] : place(ends[1]) < place(ends[0])) {
        std::reverse(chain.nodes.begin(), chain.nodes.end());
        std::reverse(chain.t.begin(), chain.t.end());
    }
    chain.t.front() = range[0], chain.t.back() = range[1];
    if (!std::is_sorted(chain.t.begin(), chain.t.end(), std::less_equal<>()))
        throw MeshError(say<Code::edge_runs_otherwise>(edge, owner));
    return chain;
}

void EdgeChains::borrow_stretches(const Brep& brep, EdgeId edge, const Mesh& mesh) {
    EdgeChain& chain = chains_[edge.index()];
    const std::vector<EdgeId>& lenders = merged_.lender_of[edge.index()];
    if (lenders.empty() || chain.nodes.empty()) return;
    const std::vector<VertexId> sequence = merged_.sequence_of(brep, edge);
    for (std::size_t s = 0; s < lenders.size(); ++s) {
        if (!lenders[s].is_valid()) continue;
        const std::array<NodeId, 2> ends{node_of(sequence[s]), node_of(sequence[s + 1])};
        const auto place = [&](NodeId n) { return std::find(chain.nodes.begin(), chain.nodes.end(), n); };
        const auto begin = place(ends[0]) - chain.nodes.begin(), end = place(ends[1]) - chain.nodes.begin();
        const EdgeChain lent =
            stretch_of(lenders[s], ends, edge, {chain.t[std::size_t(begin)], chain.t[std::size_t(end)]}, mesh);
        const auto replace = [&](auto& all, const auto& by, std::ptrdiff_t past) {
            all.erase(all.begin() + begin, all.begin() + past);
            all.insert(all.begin() + begin, by.begin(), by.end());
        };
        replace(chain.nodes, lent.nodes, end + 1), replace(chain.t, lent.t, end + 1);
        replace(chain.is_kept, lent.is_kept, end);
    }
}

EdgeChains::Piece EdgeChains::owner_of(const Piece& piece) const {
    EdgeId owner = merged_.edge_of[piece.edge.index()];
    if (owner == piece.edge) {
        const std::vector<double>& t = chains_[owner.index()].t;
        if (!t.empty()) owner = merged_.owner_at(owner, 0.5 * (t[piece.index] + t[piece.index + 1]));
        if (owner == piece.edge) return piece;
    }
    const std::vector<NodeId>& nodes = chains_[piece.edge.index()].nodes;
    const std::vector<NodeId>& all = chains_[owner.index()].nodes;
    const auto place = [&](NodeId n) { return std::find(all.begin(), all.end(), n) - all.begin(); };
    const auto [low, high] = std::minmax({place(nodes[piece.index]), place(nodes[piece.index + 1])});
    return owner_of(
        {owner, std::size_t(high - low > 1 ? high : low)});  // the last one of a closed edge ends at its first
}

std::vector<EdgeId> EdgeChains::sharers_of(EdgeId edge) const {
    std::vector<EdgeId> sharers;
    for (std::size_t e = 0; e < chains_.size(); ++e) {
        const EdgeId owner = merged_.edge_of[e];
        const std::vector<EdgeId>& lenders = merged_.lender_of[owner.index()];
        if (owner == edge || std::find(lenders.begin(), lenders.end(), edge) != lenders.end()) sharers.emplace_back(e);
    }
    return sharers;
}

bool EdgeChains::halve(const Brep& brep, EdgeId edge, std::size_t piece, Mesh& mesh) {
    EdgeChain& chain = chains_[edge.index()];
    if (chain.is_kept[piece]) return false;
    const double t = 0.5 * (chain.t[piece] + chain.t[piece + 1]);
    const Vec3 p = to_vec3(BRepAdaptor_Curve(brep.edge(edge)).Value(t));
    const double smallest = 100 * brep.tolerances().same_geometry();
    if (distance(p, mesh.point(chain.nodes[piece])) < smallest ||
        distance(p, mesh.point(chain.nodes[piece + 1])) < smallest)
        return false;
    const auto at = static_cast<std::ptrdiff_t>(piece) + 1;
    chain.nodes.insert(chain.nodes.begin() + at, mesh.add_node(p, entity_of(edge), {t, 0}));
    chain.t.insert(chain.t.begin() + at, t);
    chain.is_kept.insert(chain.is_kept.begin() + at, 0);
    return true;
}

void EdgeChains::update_sharers(const Brep& brep, EdgeId edge, const Mesh& mesh) {
    const std::vector<EdgeId> sharers = sharers_of(edge);
    for (const EdgeId sharer : sharers)
        if (sharer != edge && merged_.edge_of[sharer.index()] == sharer) borrow_stretches(brep, sharer, mesh);
    for (const EdgeId sharer : sharers)
        if (merged_.edge_of[sharer.index()] != sharer) follow_owner(brep, sharer, mesh);
}

void EdgeChains::add_segments(Mesh& mesh) const {
    for (std::size_t e = 0; e < chains_.size(); ++e)
        for (std::size_t i = 0; i < chains_[e].is_kept.size(); ++i)
            if (!chains_[e].is_kept[i]) mesh.add_segment({chains_[e].nodes[i], chains_[e].nodes[i + 1]}, EdgeId(e));
}

}  // namespace featuremesh

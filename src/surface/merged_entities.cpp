// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/merged_entities.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "core/geometry.h"
#include "core/messages.h"
#include "core/numbers_in_words.h"
#include "core/sort_once.h"
#include "core/sorted_pair.h"
#include "surface/projection.h"

namespace featuremesh {

namespace {

std::vector<std::vector<BodyId>> bodies_of_vertices(const Brep& brep) {
    std::vector<std::vector<BodyId>> bodies(brep.vertex_count());
    for (std::size_t v = 0; v < bodies.size(); ++v) {
        for (const FaceId f : brep.faces_at(entity_of(VertexId(v))))
            for (const BodyId body : brep.bodies_of(f))
                if (body.is_valid()) bodies[v].push_back(body);
        sort_once(bodies[v]);
    }
    return bodies;
}

bool share(const std::vector<BodyId>& a, const std::vector<BodyId>& b) {
    return std::any_of(a.begin(), a.end(), [&](BodyId s) { return std::binary_search(b.begin(), b.end(), s); });
}

/// Each vertex takes the lowest one near it that stands for itself.
std::vector<VertexId> merge_vertices(const Brep& brep, const std::vector<std::vector<BodyId>>& bodies,
                                     double tolerance) {
    std::vector<std::size_t> by_x(brep.vertex_count());
    std::iota(by_x.begin(), by_x.end(), std::size_t{0});
    const auto point = [&](std::size_t v) { return brep.point_of(VertexId(v)); };
    std::sort(by_x.begin(), by_x.end(),
              [&](std::size_t a, std::size_t b) { return std::pair(point(a).x, a) < std::pair(point(b).x, b); });
    std::vector<std::vector<std::size_t>> lower(by_x.size());
    for (std::size_t i = 0; i < by_x.size(); ++i)
        for (std::size_t j = i + 1; j < by_x.size() && point(by_x[j]).x - point(by_x[i]).x <= tolerance; ++j) {
            const auto [a, b] = std::minmax(by_x[i], by_x[j]);
            if (distance(point(a), point(b)) <= tolerance && share(bodies[a], bodies[b])) lower[b].push_back(a);
        }
    std::vector<VertexId> merged;
    for (std::size_t v = 0; v < lower.size(); ++v) {
        merged.emplace_back(v);
        std::sort(lower[v].begin(), lower[v].end());
        for (const std::size_t a : lower[v])
            if (merged[a] == VertexId(a)) {
                merged[v] = VertexId(a);
                break;
            }
    }
    return merged;
}

std::array<double, 2> range_of(const BRepAdaptor_Curve& curve) {
    return {curve.FirstParameter(), curve.LastParameter()};
}

Vec3 point_at(const BRepAdaptor_Curve& curve, double share) {
    const auto [first, last] = range_of(curve);
    const gp_Pnt p = curve.Value(first + share * (last - first));
    return {p.X(), p.Y(), p.Z()};
}

constexpr std::array<double, 5> probes{0.5, 0.25, 0.75, 0.1, 0.9};

/// A hull of a curve: no point of it is further from the nearest of these than the reach.
struct CurveSamples {
    std::vector<Vec3> points;
    double reach = 0;

    CurveSamples(const BRepAdaptor_Curve& curve, double tolerance) {
        const int pieces = curve.GetType() == GeomAbs_Line ? 1 : 24;
        for (int i = 0; i <= pieces; ++i) points.push_back(point_at(curve, double(i) / pieces));
        for (std::size_t i = 1; i < points.size(); ++i) reach = std::max(reach, distance(points[i - 1], points[i]));
        reach = (pieces == 1 ? 0.5 : 1.0) * reach + tolerance;
    }
    bool may_hold(const Vec3& p, double tolerance) const {
        if (points.size() == 2) {
            const Vec3 along = points[1] - points[0];
            const double share = dot(p - points[0], along) / std::max(squared_length(along), 1e-300);
            return distance(p, points[0] + std::clamp(share, 0.0, 1.0) * along) <= tolerance;
        }
        return std::any_of(points.begin(), points.end(), [&](const Vec3& q) { return distance(p, q) <= reach; });
    }
    Box box() const {
        Box box;
        for (const Vec3& p : points) box.add(p);
        const double margin = points.size() == 2 ? 0 : reach;
        box.low = box.low - Vec3{margin, margin, margin};
        box.high = box.high + Vec3{margin, margin, margin};
        return box;
    }
};

/// By edge, the vertices of the same bodies that lie on it away from its ends.
std::vector<std::vector<std::pair<double, VertexId>>> find_vertices_on(const Brep& brep,
                                                                       const std::vector<std::vector<BodyId>>& bodies,
                                                                       const std::vector<VertexId>& vertex_of,
                                                                       const Projector& projector, double tolerance) {
    std::vector<std::vector<std::pair<double, VertexId>>> found(brep.edge_count());
    std::vector<std::pair<double, std::size_t>> by_x;
    for (std::size_t v = 0; v < vertex_of.size(); ++v)
        if (vertex_of[v] == VertexId(v)) by_x.emplace_back(brep.point_of(VertexId(v)).x, v);
    std::sort(by_x.begin(), by_x.end());
    for (std::size_t e = 0; e < found.size(); ++e) {
        const auto ends = brep.ends_of(EdgeId(e));
        if (brep.is_degenerated(EdgeId(e)) || !ends[0].is_valid() || !ends[1].is_valid() || ends[0] == ends[1])
            continue;
        const CurveSamples samples(BRepAdaptor_Curve(brep.edge(EdgeId(e))), tolerance);
        const Box box = samples.box();
        // A loose vertex is not where its edge's curve ends.
        const std::array<Vec3, 4> ends_at{brep.point_of(ends[0]), brep.point_of(ends[1]), samples.points.front(),
                                          samples.points.back()};
        const auto is_outside = [&](const Vec3& p) {
            return p.y < box.low.y - tolerance || p.y > box.high.y + tolerance || p.z < box.low.z - tolerance ||
                   p.z > box.high.z + tolerance;
        };
        for (auto it = std::lower_bound(by_x.begin(), by_x.end(), std::pair(box.low.x - tolerance, std::size_t{0}));
             it != by_x.end() && it->first <= box.high.x + tolerance; ++it) {
            const VertexId vertex(it->second);
            const Vec3 p = brep.point_of(vertex);
            if (vertex == vertex_of[ends[0].index()] || vertex == vertex_of[ends[1].index()] || is_outside(p) ||
                !samples.may_hold(p, tolerance) || !share(bodies[vertex.index()], bodies[ends[0].index()]))
                continue;
            const OnEdge nearest = projector.nearest(EdgeId(e), p);
            const auto is_near = [&](const Vec3& end) { return distance(nearest.point, end) <= 2 * tolerance; };
            if (nearest.distance > tolerance || std::any_of(ends_at.begin(), ends_at.end(), is_near)) continue;
            found[e].emplace_back(nearest.t, vertex);
        }
        std::sort(found[e].begin(), found[e].end());
    }
    return found;
}

/// Both of whose ends are this vertex.
bool is_point(const Brep& brep, EdgeId edge, VertexId vertex, double tolerance) {
    const BRepAdaptor_Curve curve(brep.edge(edge));
    return std::all_of(probes.begin(), probes.end(), [&](double share) {
        return distance(point_at(curve, share), brep.point_of(vertex)) <= 2 * tolerance;
    });
}

/// An edge between two shares of it.
struct Stretch {
    EdgeId edge;
    std::array<double, 2> shares{0, 1};
};

/// With ends in common: whether each of the two runs along the other. One shorter than the tolerance is near whatever
/// ends there.
bool run_along(const Brep& brep, const Projector& projector, const Stretch& one, const Stretch& other,
               double tolerance) {
    const BRepAdaptor_Curve curve(brep.edge(one.edge)), other_curve(brep.edge(other.edge));
    if (curve.GetType() == GeomAbs_Line && other_curve.GetType() == GeomAbs_Line) return true;
    const auto is_beside = [&](const BRepAdaptor_Curve& along, const std::array<double, 2>& shares, EdgeId to,
                               double reach) {
        return std::all_of(probes.begin(), probes.end(), [&](double share) {
            const Vec3 p = point_at(along, shares[0] + share * (shares[1] - shares[0]));
            return projector.nearest(to, p).distance <= reach;
        });
    };
    return is_beside(curve, one.shares, other.edge, tolerance) &&
           is_beside(other_curve, other.shares, one.edge, 2 * tolerance);
}

/// Whether two faces with one border lie on one another, or have nothing but a slit of their solid between them: what
/// is thin has elements.
class LyingFaces {
  public:
    LyingFaces(const Brep& brep, const Projector& projector, double tolerance)
        : brep_(brep), projector_(projector), reach_(2 * tolerance) {}

    bool lie_on_one_another(FaceId face, FaceId other) const {
        const SolidId solid = common_solid(face, other);
        if (!solid.is_valid()) return false;
        const bool are_planes = is_plane(face) && is_plane(other);
        const double outward = brep_.solids_beside(face)[0] == solid ? 1 : -1;
        const auto lies_on_other = [&](std::array<double, 2> uv) {
            const Vec3 p = projector_.on_face(face, uv);
            const OnFace at = projector_.nearest(other, p);
            return at.distance <= reach_ && (are_planes || projector_.is_inside_trim(other, at.uv)) &&
                   outward * dot(at.point - p, projector_.normal(face, uv)) >= -brep_.tolerances().same_geometry();
        };
        const auto places = are_planes ? places_on_border(face) : places_inside(face);
        return !places.empty() && std::all_of(places.begin(), places.end(), lies_on_other);
    }

  private:
    SolidId common_solid(FaceId face, FaceId other) const {
        const auto b = brep_.solids_beside(other);
        for (const SolidId s : brep_.solids_beside(face))
            if (s.is_valid() && (s == b[0] || s == b[1])) return s;
        return {};
    }
    bool is_plane(FaceId face) const { return BRepAdaptor_Surface(brep_.face(face), false).GetType() == GeomAbs_Plane; }
    std::vector<std::array<double, 2>> places_on_border(FaceId face) const {
        std::vector<std::array<double, 2>> places;
        for (const EdgeId e : brep_.edges_of(face)) {
            const auto [first, last] = projector_.range(e);
            places.push_back(projector_.nearest(face, projector_.on_edge(e, 0.5 * (first + last))).uv);
        }
        return places;
    }
    std::vector<std::array<double, 2>> places_inside(FaceId face) const {
        constexpr int steps = 7;
        double u_min, u_max, v_min, v_max;
        BRepTools::UVBounds(brep_.face(face), u_min, u_max, v_min, v_max);
        std::vector<std::array<double, 2>> places;
        for (int i = 0; i < steps; ++i)
            for (int j = 0; j < steps; ++j)
                places.push_back(
                    {u_min + (u_max - u_min) * (i + 0.5) / steps, v_min + (v_max - v_min) * (j + 0.5) / steps});
        std::erase_if(places, [&](const auto& uv) { return !projector_.is_inside_trim(face, uv); });
        return places;
    }

    const Brep& brep_;
    const Projector& projector_;
    double reach_;
};

/// Faces that close round a place, or round an edge, within the tolerance, if some closed edges are points.
class ClosedHoles {
  public:
    ClosedHoles(const Brep& brep, const Projector& projector, const std::vector<char>& is_point, double tolerance)
        : brep_(brep), projector_(projector), is_point_(is_point), reach_(2 * tolerance) {
        for (std::size_t e = 0; e < brep.edge_count(); ++e)
            if (may_be_point(EdgeId(e))) is_point_[e] = 1, found_.emplace_back(e);
    }

    /// The closed edges that are points: all that no face needs.
    std::vector<EdgeId> points() {
        for (bool is_changed = true; std::exchange(is_changed, false);)
            std::erase_if(found_, [&](EdgeId e) {
                const auto faces = brep_.faces_of(e);
                if (std::all_of(faces.begin(), faces.end(),
                                [&](FaceId f) { return is_whole_without(f, e) || closes(f); }))
                    return false;
                is_point_[e.index()] = 0;
                return is_changed = true;
            });
        return found_;
    }

    /// Of those faces that close, once points() has been asked.
    std::vector<FaceId> closed_faces() const {
        std::vector<FaceId> closed;
        for (const EdgeId e : found_)
            for (const FaceId f : brep_.faces_of(e))
                if (closes(f)) closed.push_back(f);
        return closed;
    }

  private:
    bool may_be_point(EdgeId e) const {
        const auto ends = brep_.ends_of(e);
        return !brep_.is_degenerated(e) && !is_point_[e.index()] && ends[0].is_valid() && ends[0] == ends[1] &&
               !brep_.faces_of(e).empty() && is_point(brep_, e, ends[0], 0.5 * reach_);
    }

    bool has_no_length(EdgeId e) const { return brep_.is_degenerated(e) || is_point_[e.index()]; }

    /// Whether the edge is a border of its own of the face, which has another one.
    bool is_whole_without(FaceId face, EdgeId edge) const {
        bool is_alone = false, has_other = false;
        for (TopExp_Explorer wire(brep_.face(face), TopAbs_WIRE); wire.More(); wire.Next()) {
            std::vector<EdgeId> edges;
            for (TopExp_Explorer it(wire.Current(), TopAbs_EDGE); it.More(); it.Next())
                edges.push_back(brep_.find(TopoDS::Edge(it.Current())));
            is_alone |= edges.size() == 1 && edges.front() == edge;
            has_other |= std::any_of(edges.begin(), edges.end(), [&](EdgeId e) { return !has_no_length(e); });
        }
        return is_alone && has_other;
    }

    /// Whether all of the face is near its edges, of which those with a length are one, used twice.
    bool closes(FaceId face) const {
        std::vector<EdgeId> long_uses;
        for (TopExp_Explorer it(brep_.face(face), TopAbs_EDGE); it.More(); it.Next())
            if (const EdgeId e = brep_.find(TopoDS::Edge(it.Current())); !has_no_length(e)) long_uses.push_back(e);
        if (!long_uses.empty() && (long_uses.size() != 2 || long_uses[0] != long_uses[1])) return false;
        const Vec3 vertex = brep_.point_of(brep_.ends_of(brep_.edges_of(face).front())[0]);
        constexpr int steps = 6;
        double u_min, u_max, v_min, v_max;
        BRepTools::UVBounds(brep_.face(face), u_min, u_max, v_min, v_max);
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; j <= steps; ++j) {
                const Vec3 p = projector_.on_face(
                    face, {u_min + (u_max - u_min) * i / steps, v_min + (v_max - v_min) * j / steps});
                const double off =
                    long_uses.empty() ? distance(p, vertex) : projector_.nearest(long_uses[0], p).distance;
                if (off > 2 * reach_) return false;
            }
        return true;
    }

    const Brep& brep_;
    const Projector& projector_;
    std::vector<char> is_point_;  ///< by edge, with those found
    double reach_;
    std::vector<EdgeId> found_;
};

}  // namespace

MergedEntities::MergedEntities(const Brep& brep, double ignore_below)
    : is_point(brep.edge_count(), 0),
      is_flat(brep.face_count(), 0),
      is_joined_(brep.face_count(), 0),
      tolerance_(std::max(brep.tolerances().negligible(), ignore_below)),
      is_wide_(ignore_below > brep.tolerances().negligible()) {
    const std::vector<std::vector<BodyId>> bodies = bodies_of_vertices(brep);
    const Projector projector(brep);
    vertex_of = merge_vertices(brep, bodies, tolerance_);
    vertices_on = find_vertices_on(brep, bodies, vertex_of, projector, tolerance_);
    join_edges(brep, projector);
    close_holes(brep, projector);
    find_flat_faces(brep);
    join_faces(brep, projector);
    leave_out_bare_edges(brep);
    merge_bare_vertices(brep);
}

std::vector<VertexId> MergedEntities::sequence_of(const Brep& brep, EdgeId edge) const {
    const auto ends = brep.ends_of(edge);
    std::vector<VertexId> sequence{vertex_of[ends[0].index()]};
    for (const auto& [t, vertex] : vertices_on[edge.index()]) sequence.push_back(vertex);
    sequence.push_back(vertex_of[ends[1].index()]);
    return sequence;
}

std::array<double, 2> MergedEntities::shares_between(const Brep& brep, EdgeId edge,
                                                     const std::array<VertexId, 2>& ends) const {
    const auto [first, last] = range_of(BRepAdaptor_Curve(brep.edge(edge)));
    const std::vector<VertexId> sequence = sequence_of(brep, edge);
    if (ends[0] == ends[1]) return {0, 1};  // all round
    const auto share_of = [&](VertexId vertex) {
        const auto place =
            static_cast<std::size_t>(std::find(sequence.begin(), sequence.end(), vertex) - sequence.begin());
        if (place == 0 || place + 1 >= sequence.size()) return place == 0 ? 0.0 : 1.0;
        return (vertices_on[edge.index()][place - 1].first - first) / (last - first);
    };
    return {share_of(ends[0]), share_of(ends[1])};
}

void MergedEntities::join_edges(const Brep& brep, const Projector& projector) {
    std::vector<EdgeId> order;  // those with most vertices on them first: others may be parts of them
    lender_of.resize(brep.edge_count());
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        edge_of.emplace_back(e);
        const auto ends = brep.ends_of(EdgeId(e));
        if (brep.is_degenerated(EdgeId(e)) || !ends[0].is_valid() || !ends[1].is_valid()) continue;
        const VertexId first = vertex_of[ends[0].index()];
        if (first != vertex_of[ends[1].index()] || !featuremesh::is_point(brep, EdgeId(e), first, tolerance_))
            order.emplace_back(e);
        else if (ends[0] != ends[1])
            is_point[e] = 1;
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](EdgeId a, EdgeId b) { return vertices_on[a.index()].size() > vertices_on[b.index()].size(); });
    std::map<std::array<VertexId, 2>, std::vector<EdgeId>> between;
    for (const EdgeId edge : order) {
        const std::vector<VertexId> sequence = sequence_of(brep, edge);
        const std::array<VertexId, 2> ends{sequence.front(), sequence.back()};
        for (const EdgeId other : between[sorted_pair(ends[0], ends[1])])
            if (run_along(brep, projector, {edge}, {other, shares_between(brep, other, ends)},
                          reach_between(brep, edge, other))) {
                edge_of[edge.index()] = other;
                break;
            }
        if (edge_of[edge.index()] != edge) continue;
        for (std::size_t i = 0; i + 1 < sequence.size() && sequence.size() > 2; ++i)
            borrow_stretch(brep, projector, edge, i, between[sorted_pair(sequence[i], sequence[i + 1])]);
        for (std::size_t i = 0; i < sequence.size(); ++i)
            for (std::size_t j = i + 1; j < sequence.size(); ++j)
                between[sorted_pair(sequence[i], sequence[j])].push_back(edge);
    }
}

double MergedEntities::reach_between(const Brep& brep, EdgeId edge, EdgeId other) const {
    const double off = std::max(BRep_Tool::Tolerance(brep.edge(edge)), BRep_Tool::Tolerance(brep.edge(other)));
    if (off <= tolerance_) return tolerance_;
    const double area_of_strip = tolerance_ * GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(brep.edge(edge)));
    for (const FaceId f : brep.faces_of(edge)) {
        const auto edges = brep.edges_of(f);
        if (edges.size() != 2 || std::find(edges.begin(), edges.end(), other) == edges.end()) continue;
        GProp_GProps area;
        BRepGProp::SurfaceProperties(brep.face(f), area);
        if (std::abs(area.Mass()) < area_of_strip) return off;
    }
    return tolerance_;
}

void MergedEntities::borrow_stretch(const Brep& brep, const Projector& projector, EdgeId edge, std::size_t first,
                                    const std::vector<EdgeId>& others) {
    const std::vector<VertexId> sequence = sequence_of(brep, edge);
    const std::array<VertexId, 2> ends{sequence[first], sequence[first + 1]};
    const std::array<double, 2> shares = shares_between(brep, edge, ends);
    const auto has_stretch = [&](EdgeId other) {
        Stretches its;
        add_stretches(brep, other, ends, its);
        return its.begin()->first.first == other && its.rbegin()->first.first == other &&
               run_along(brep, projector, {edge, shares}, {other, shares_between(brep, other, ends)}, tolerance_);
    };
    const auto lender = std::find_if(others.begin(), others.end(), has_stretch);
    if (lender == others.end()) return;
    lender_of[edge.index()].resize(sequence.size() - 1);
    lender_of[edge.index()][first] = *lender;
}

EdgeId MergedEntities::owner_at(EdgeId edge, double t) const {
    const std::vector<EdgeId>& lenders = lender_of[edge.index()];
    if (lenders.empty()) return edge;
    const auto& on = vertices_on[edge.index()];
    const auto after = std::find_if(on.begin(), on.end(), [&](const auto& vertex) { return vertex.first > t; });
    const EdgeId lender = lenders[std::size_t(after - on.begin())];
    return lender.is_valid() ? lender : edge;
}

void MergedEntities::close_holes(const Brep& brep, const Projector& projector) {
    ClosedHoles holes(brep, projector, is_point, tolerance_);
    for (const EdgeId e : holes.points()) is_point[e.index()] = 1;
    for (const FaceId f : holes.closed_faces()) is_flat[f.index()] = 1;
}

MergedEntities::Stretches MergedEntities::border_of(const Brep& brep, FaceId face) const {
    Stretches uses;
    for (const EdgeId e : brep.edges_of(face)) {
        if (brep.is_degenerated(e) || is_point[e.index()]) continue;
        const EdgeId owner = edge_of[e.index()];
        const auto ends = brep.ends_of(e);
        if (!ends[0].is_valid() || !ends[1].is_valid() || ends[0] == ends[1])
            ++uses[{owner, 0}];
        else
            add_stretches(brep, owner, {vertex_of[ends[0].index()], vertex_of[ends[1].index()]}, uses);
    }
    return uses;
}

void MergedEntities::add_stretches(const Brep& brep, EdgeId edge, const std::array<VertexId, 2>& ends,
                                   Stretches& uses) const {
    const std::vector<VertexId> sequence = sequence_of(brep, edge);
    const auto place = [&](VertexId v) { return std::find(sequence.begin(), sequence.end(), v) - sequence.begin(); };
    auto [first, last] = std::minmax({place(ends[0]), place(ends[1])});
    if (first == last) first = 0, last = std::ptrdiff_t(sequence.size()) - 1;  // all round
    const std::vector<EdgeId>& lenders = lender_of[edge.index()];
    for (std::ptrdiff_t i = first; i < last; ++i) {
        const auto s = static_cast<std::size_t>(i);
        if (!lenders.empty() && lenders[s].is_valid())
            add_stretches(brep, lenders[s], {sequence[s], sequence[s + 1]}, uses);
        else
            ++uses[{edge, i}];
    }
}

void MergedEntities::find_flat_faces(const Brep& brep) {
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        if (is_flat[f] || brep.edges_of(FaceId(f)).empty()) continue;
        const Stretches border = border_of(brep, FaceId(f));
        is_flat[f] = std::all_of(border.begin(), border.end(), [](const auto& use) { return use.second == 2; });
    }
}

/// Those between the same chains: nothing is between them.
void MergedEntities::join_faces(const Brep& brep, const Projector& projector) {
    std::map<Stretches, std::vector<FaceId>> within;
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        if (is_flat[f] || brep.is_free(FaceId(f)) || !brep.is_meshed(FaceId(f))) continue;
        Stretches border = border_of(brep, FaceId(f));
        std::erase_if(border, [](const auto& use) { return use.second == 2; });
        if (!border.empty()) within[std::move(border)].emplace_back(f);
    }
    const LyingFaces lying(brep, projector, tolerance_);
    for (const auto& [border, faces] : within)
        for (std::size_t i = 0; i < faces.size(); ++i)
            for (std::size_t j = i + 1; j < faces.size() && !is_flat[faces[i].index()]; ++j) {
                if (is_flat[faces[j].index()] || !lying.lie_on_one_another(faces[i], faces[j])) continue;
                for (const FaceId face : {faces[i], faces[j]}) is_flat[face.index()] = is_joined_[face.index()] = 1;
            }
}

bool MergedEntities::is_short_spike(const Brep& brep, FaceId face, EdgeId edge) const {
    const VertexId end = brep.ends_of(edge)[0];
    if (brep.is_degenerated(edge) || !end.is_valid() ||
        !featuremesh::is_point(brep, edge, vertex_of[end.index()], tolerance_))
        return false;
    const Stretches border = border_of(brep, face);
    return std::all_of(border.begin(), border.end(),
                       [&](const auto& use) { return use.first.first != edge_of[edge.index()] || use.second == 2; });
}

/// Those beside which no face has triangles: the ends of strips, too, that a large face has there and back.
void MergedEntities::leave_out_bare_edges(const Brep& brep) {
    std::vector<char> has_triangles(brep.edge_count(), 0);  // by edge that has the chain: beside it, or no face is
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        const auto faces = brep.faces_of(EdgeId(e));
        has_triangles[edge_of[e].index()] |= faces.empty() || std::any_of(faces.begin(), faces.end(), [&](FaceId f) {
                                                 return !is_flat[f.index()] && !is_short_spike(brep, f, EdgeId(e));
                                             });
    }
    for (std::size_t e = 0; e < brep.edge_count(); ++e)
        if (!brep.is_degenerated(EdgeId(e)) && !has_triangles[edge_of[e].index()]) is_point[e] = 1;
}

void MergedEntities::merge_bare_vertices(const Brep& brep) {
    std::vector<char> stays(brep.vertex_count(), 0);
    for (const auto& on : vertices_on)
        for (const auto& [t, v] : on) stays[v.index()] = 1;
    for (std::size_t e = 0; e < is_point.size(); ++e) {
        const auto ends = brep.ends_of(EdgeId(e));
        for (const VertexId v : ends)
            if (v.is_valid() && (!is_point[e] || ends[0] == ends[1])) stays[vertex_of[v.index()].index()] = 1;
    }
    for (std::size_t e = 0; e < is_point.size(); ++e) {
        const auto ends = brep.ends_of(EdgeId(e));
        if (!is_point[e] || brep.is_degenerated(EdgeId(e))) continue;
        auto [from, to] = std::pair(vertex_of[ends[0].index()], vertex_of[ends[1].index()]);
        if (stays[from.index()]) std::swap(from, to);
        if (from == to || stays[from.index()] || !featuremesh::is_point(brep, EdgeId(e), to, tolerance_)) continue;
        std::replace(vertex_of.begin(), vertex_of.end(), from, to);
    }
}

bool MergedEntities::is_same_as(const MergedEntities& other) const {
    return vertex_of == other.vertex_of && edge_of == other.edge_of && vertices_on == other.vertices_on &&
           lender_of == other.lender_of && is_point == other.is_point && is_flat == other.is_flat;
}

std::vector<Message> MergedEntities::warnings() const {
    std::vector<Entity> vertices, edges, faces, joined;
    for (std::size_t v = 0; v < vertex_of.size(); ++v)
        if (vertex_of[v] != VertexId(v)) vertices.push_back(entity_of(VertexId(v)));
    for (std::size_t e = 0; e < edge_of.size(); ++e)
        if (is_point[e]) edges.push_back(entity_of(EdgeId(e)));
    for (std::size_t f = 0; f < is_flat.size(); ++f)
        if (is_flat[f]) (is_joined_[f] ? joined : faces).push_back(entity_of(FaceId(f)));
    std::vector<Message> lines;
    if (!vertices.empty())
        lines.push_back(is_wide_ ? say<Code::vertices_nearer_than>(Length{rounded(tolerance_, 3)}, vertices)
                                 : say<Code::vertices_in_one_place>(vertices));
    if (!edges.empty()) lines.push_back(say<Code::edges_too_short>(edges));
    if (!faces.empty()) lines.push_back(say<Code::faces_too_narrow>(faces));
    if (!joined.empty()) lines.push_back(say<Code::faces_joined>(joined));
    return lines;
}

}  // namespace featuremesh

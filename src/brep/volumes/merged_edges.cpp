// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/volumes/merged_edges.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <ElCLib.hxx>
#include <Extrema_ExtPC.hxx>
#include <Standard_DomainError.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "brep/occt_geometry.h"

namespace featuremesh {

namespace {

constexpr double confusion = 1e-7;  // mm: the kernel's own

/// Holds the whole curve, and for a conic more than that.
Box box_of_curve(const TopoDS_Edge& edge, const BRepAdaptor_Curve& curve) {
    Box box;
    const auto add_disc = [&](const gp_Pnt& centre, double radius) {
        box.add(to_vec3(centre));
        box = box.grown(radius);
    };
    switch (curve.GetType()) {
        case GeomAbs_Line:
            box.add(to_vec3(curve.Value(curve.FirstParameter())));
            box.add(to_vec3(curve.Value(curve.LastParameter())));
            break;
        case GeomAbs_Circle:
            add_disc(curve.Circle().Location(), curve.Circle().Radius());
            break;
        case GeomAbs_Ellipse:
            add_disc(curve.Ellipse().Location(), curve.Ellipse().MajorRadius());
            break;
        default:
            box = box_of(edge);
    }
    return box;
}

/// The parameter within the edge's range where the curve comes closer than `tolerance`.
std::optional<double> parameter_on(const BRepAdaptor_Curve& curve, const gp_Pnt& p, double tolerance) {
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    const auto within_range = [&](double t) { return ElCLib::InPeriod(t, first, first + 2 * M_PI); };
    std::optional<double> nearest;
    if (curve.GetType() == GeomAbs_Line)
        nearest = ElCLib::Parameter(curve.Line(), p);
    else if (curve.GetType() == GeomAbs_Circle)
        nearest = within_range(ElCLib::Parameter(curve.Circle(), p));
    else if (curve.GetType() == GeomAbs_Ellipse)
        nearest = within_range(ElCLib::Parameter(curve.Ellipse(), p));
    else {
        const Extrema_ExtPC search(p, curve, first, last);
        double best = tolerance * tolerance;
        for (int i = 1; search.IsDone() && i <= search.NbExt(); ++i)
            if (search.SquareDistance(i) <= best) {
                best = search.SquareDistance(i);
                nearest = search.Point(i).Parameter();
            }
    }
    if (!nearest || *nearest <= first || *nearest >= last || curve.Value(*nearest).Distance(p) > tolerance)
        return std::nullopt;
    return nearest;
}

}  // namespace

MergedEdges::MergedEdges(const std::vector<PatchFace>& faces) {
    collect(faces);
    merge_vertices();
    std::vector<int> only[2];  // vertices of one of the shapes only: they alone can cut edges of the other
    for (int v = 0; v < int(places_.size()); ++v) {
        const Place& place = places_[std::size_t(v)];
        if (place.merged == v && place.is_of[0] != place.is_of[1]) only[place.is_of[1]].push_back(v);
    }
    for (int e = 0; e < int(edges_.size()); ++e) {
        const auto& is_of = edges_[std::size_t(e)].is_of;
        cut(e, is_of[0] == is_of[1] ? std::vector<int>() : only[is_of[0]]);
    }
    merge_pieces();
    resolve_uses();
}

void MergedEdges::collect(const std::vector<PatchFace>& faces) {
    for (const PatchFace& patch : faces) {
        std::vector<Wire>& wires = wires_.emplace_back();
        for (TopoDS_Iterator wire(patch.face.Oriented(TopAbs_FORWARD)); wire.More(); wire.Next()) {
            if (wire.Value().ShapeType() != TopAbs_WIRE) throw Standard_DomainError("a face with loose edges");
            Wire& uses = wires.emplace_back();
            for (TopoDS_Iterator it(wire.Value()); it.More(); it.Next()) {
                const TopoDS_Edge& edge = TopoDS::Edge(it.Value());
                if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED)
                    throw Standard_DomainError("an edge within a face");
                uses.push_back({edge, add_edge(edge, patch.vanished)});
            }
        }
    }
}

int MergedEdges::add_edge(const TopoDS_Edge& edge, bool vanished) {
    const int number = edge_numbers_.Add(edge) - 1;
    if (number == int(edges_.size())) {
        Edge& added = edges_.emplace_back();
        added.edge = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
        const TopoDS_Vertex ends[] = {TopExp::FirstVertex(added.edge), TopExp::LastVertex(added.edge)};
        for (int i = 0; i < 2; ++i) {
            if (ends[i].IsNull()) throw Standard_DomainError("an edge without an end");
            added.ends[std::size_t(i)] = vertices_.Add(ends[i].Oriented(TopAbs_FORWARD)) - 1;
            if (vertices_.Extent() > int(places_.size()))
                places_.push_back({to_vec3(BRep_Tool::Pnt(ends[i])), std::max(confusion, BRep_Tool::Tolerance(ends[i])),
                                   int(places_.size())});
        }
    }
    edges_[std::size_t(number)].is_of[vanished] = true;
    for (const int end : edges_[std::size_t(number)].ends) places_[std::size_t(end)].is_of[vanished] = true;
    return number;
}

void MergedEdges::merge_vertices() {
    double widest = 0;
    for (const Place& place : places_) widest = std::max(widest, place.tolerance);
    std::vector<int> order(places_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return position(a).x < position(b).x; });
    const auto root = [&](int v) {
        while (places_[std::size_t(v)].merged != v) v = places_[std::size_t(v)].merged;
        return v;
    };
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size() && position(order[j]).x <= position(order[i]).x + widest; ++j) {
            const double reach =
                std::max(places_[std::size_t(order[i])].tolerance, places_[std::size_t(order[j])].tolerance);
            if (distance(position(order[i]), position(order[j])) > reach) continue;
            const int a = root(order[i]), b = root(order[j]);
            places_[std::size_t(std::max(a, b))].merged = std::min(a, b);
        }
    for (std::size_t v = 0; v < places_.size(); ++v) {
        Place& first = places_[std::size_t(root(int(v)))];
        if (distance(places_[v].point, first.point) > first.tolerance)
            throw Standard_DomainError("a vertex wider than the one it stands for");
        places_[v].merged = root(int(v));
        for (int shape = 0; shape < 2; ++shape) first.is_of[shape] = first.is_of[shape] || places_[v].is_of[shape];
    }
    for (Edge& edge : edges_)
        for (int& end : edge.ends) end = places_[std::size_t(end)].merged;
}

std::vector<std::pair<double, int>> MergedEdges::cuts_of(const Edge& edge, const std::vector<int>& others) const {
    std::vector<std::pair<double, int>> cuts;
    if (others.empty()) return cuts;
    const BRepAdaptor_Curve curve(edge.edge);
    const double own = std::max(confusion, BRep_Tool::Tolerance(edge.edge));
    const Box box = box_of_curve(edge.edge, curve).grown(own);
    for (const int v : others) {
        const Place& place = places_[std::size_t(v)];
        if (!box.grown(place.tolerance).contains(place.point) || v == edge.ends[0] || v == edge.ends[1]) continue;
        if (const auto t = parameter_on(curve, to_pnt(place.point), std::max(own, place.tolerance)))
            cuts.emplace_back(*t, v);
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

void MergedEdges::cut(int index, const std::vector<int>& others) {
    Edge& edge = edges_[std::size_t(index)];
    const auto add = [&](double first, double last, int from, int to) {
        edge.pieces.push_back(int(pieces_.size()));
        pieces_.push_back({index, first, last, {from, to}, int(pieces_.size()), false, std::nullopt});
    };
    if (BRep_Tool::Degenerated(edge.edge)) return add(0, 0, edge.ends[0], edge.ends[1]);
    const BRepAdaptor_Curve curve(edge.edge);
    if (!curve.Is3DCurve()) throw Standard_DomainError("an edge without a curve");
    double from = curve.FirstParameter();
    int start = edge.ends[0];
    for (const auto& [t, v] : cuts_of(edge, others)) {
        add(from, t, start, v);
        from = t;
        start = v;
    }
    add(from, curve.LastParameter(), start, edge.ends[1]);
    if (edge.pieces.size() > 1 && !(BRep_Tool::SameParameter(edge.edge) && BRep_Tool::SameRange(edge.edge)))
        throw Standard_DomainError("an edge that is not the same on its faces");
    for (const int p : edge.pieces) {
        Piece& piece = pieces_[std::size_t(p)];
        const double length = piece.last - piece.first;
        piece.inner = {to_vec3(curve.Value(piece.first + 0.25 * length)),
                       to_vec3(curve.Value(piece.first + 0.75 * length))};
    }
}

void MergedEdges::merge_pieces() {
    std::map<std::array<int, 2>, std::vector<int>> between;  // pieces that stand for themselves, by their ends
    for (int p = 0; p < int(pieces_.size()); ++p) {
        Piece& piece = pieces_[std::size_t(p)];
        if (!piece.inner) continue;
        std::array<int, 2> ends = piece.ends;
        std::sort(ends.begin(), ends.end());
        std::vector<int>& known = between[ends];
        const auto tolerance = [&](const Piece& of) {
            return std::max({BRep_Tool::Tolerance(edge_of(of)), places_[std::size_t(ends[0])].tolerance,
                             places_[std::size_t(ends[1])].tolerance});
        };
        for (const int k : known) {
            const Piece& other = pieces_[std::size_t(k)];
            const double close = 2 * std::max(tolerance(piece), tolerance(other));
            const auto runs_along = [&](std::size_t first, std::size_t second) {
                return distance((*piece.inner)[0], (*other.inner)[first]) <= close &&
                       distance((*piece.inner)[1], (*other.inner)[second]) <= close;
            };
            const bool along = runs_along(0, 1);
            if (!along && !runs_along(1, 0)) continue;
            piece.merged = k;
            piece.turned = !along;
            break;
        }
        if (piece.merged == p) known.push_back(p);
    }
}

void MergedEdges::resolve_uses() {
    for (std::vector<Wire>& wires : wires_)
        for (Wire& wire : wires) {
            Wire resolved;
            for (const Use& use : wire) {
                const bool forward = use.edge.Orientation() == TopAbs_FORWARD;
                std::vector<int> own = edges_[std::size_t(use.own)].pieces;
                if (!forward) std::reverse(own.begin(), own.end());
                for (const int p : own)
                    resolved.push_back({use.edge, p, piece(p).merged, forward != piece(p).turned ? 1 : -1});
            }
            wire = std::move(resolved);
        }
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/volumes/patch_volumes.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Plane.hxx>
#include <Standard_DomainError.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "brep/occt_geometry.h"
#include "brep/solid_probe.h"
#include "brep/volumes/flux.h"
#include "brep/volumes/merged_edges.h"
#include "brep/volumes/patch_faces.h"
#include "brep/volumes/period_shifts.h"
#include "brep/volumes/sheet_contacts.h"
#include "brep/volumes/surface_caps.h"

namespace featuremesh {

namespace {

constexpr double no_volume = 1e-12;  // of the cube of a shell's size

/// A pcurve over the range of `own` as one over the range of `piece`, which stands for it.
Handle(Geom2d_Curve) over_range_of(const MergedEdges::Piece& piece, const MergedEdges::Piece& own, bool turned,
                                   const Handle(Geom2d_Curve) & trace) {
    const double close = 1e-9 * (1 + std::abs(own.last - own.first));
    if (!turned && std::abs(piece.first - own.first) < close && std::abs(piece.last - own.last) < close) return trace;
    if (!trace->IsKind(STANDARD_TYPE(Geom2d_Line)) ||
        std::abs((piece.last - piece.first) - (own.last - own.first)) > 1e-7 * (own.last - own.first))
        throw Standard_DomainError("the same edge with other parameters");
    const gp_Pnt2d start = trace->Value(turned ? own.last : own.first),
                   end = trace->Value(turned ? own.first : own.last);
    const gp_Dir2d direction(gp_Vec2d(start, end));
    return new Geom2d_Line(start.Translated(gp_Vec2d(direction) * -piece.first), direction);
}

/// Makes the edges of pieces: the document's own ones where they can be left as they are, else copies.
class PieceEdges {
  public:
    explicit PieceEdges(const MergedEdges& edges) : edges_(edges), traces_(edges.piece_count()) {}

    /// The piece will border a face on the surface of `target`; the use is from `source`, on the same surface, `shift`
    /// away in its parameters.
    void need(const MergedEdges::Use& use, const TopoDS_Face& source, const TopoDS_Face& target,
              const Parameters& shift) {
        TopLoc_Location place, source_place;
        const Handle(Geom_Surface)& surface = BRep_Tool::Surface(target, place);
        const MergedEdges::Piece &piece = edges_.piece(use.piece), &own = edges_.piece(use.own);
        const bool has_trace = own.edge == piece.edge && shift.u == 0 && shift.v == 0 &&
                               surface == BRep_Tool::Surface(source, source_place) && place == source_place;
        if (has_trace || surface->IsKind(STANDARD_TYPE(Geom_Plane))) return;
        std::vector<Trace>& known = traces_[std::size_t(use.piece)];
        for (const Trace& trace : known)
            if (trace.surface == surface && trace.place == place) return;
        const TopoDS_Face forward = TopoDS::Face(source.Oriented(TopAbs_FORWARD));
        Trace trace{surface, place, {}, {}, BRep_Tool::Tolerance(use.edge)};
        double first = 0, last = 0;
        const auto on = [&](TopAbs_Orientation orientation) {
            auto curve = BRep_Tool::CurveOnSurface(TopoDS::Edge(use.edge.Oriented(orientation)), forward, first, last);
            if (curve.IsNull()) throw Standard_DomainError("an edge without a curve on its face");
            if (shift.u != 0 || shift.v != 0)
                curve = Handle(Geom2d_Curve)::DownCast(curve->Translated(gp_Vec2d(shift.u, shift.v)));
            return edges_.is_degenerated(own) ? curve : over_range_of(piece, own, own.turned, curve);
        };
        trace.along = on(own.turned ? TopAbs_REVERSED : TopAbs_FORWARD);
        if (BRep_Tool::IsClosed(use.edge, forward)) trace.against = on(own.turned ? TopAbs_FORWARD : TopAbs_REVERSED);
        known.push_back(trace);
    }

    /// The document's own edge.
    bool is_kept(int index) const {
        const MergedEdges::Piece& piece = edges_.piece(index);
        return edges_.is_whole(piece) && traces_[std::size_t(index)].empty() && has_own_vertices(piece);
    }

    const TopoDS_Edge& edge(int index) {
        const auto [at, is_new] = made_.try_emplace(index);
        if (is_new) at->second = is_kept(index) ? edges_.edge_of(edges_.piece(index)) : copy(index);
        return at->second;
    }

  private:
    struct Trace {
        Handle(Geom_Surface) surface;
        TopLoc_Location place;
        Handle(Geom2d_Curve) along, against;  // the second of a seam only
        double tolerance = 0;
    };

    bool has_own_vertices(const MergedEdges::Piece& piece) const {
        const TopoDS_Edge& edge = edges_.edge_of(piece);
        return TopExp::FirstVertex(edge).IsSame(edges_.vertex(piece.ends[0])) &&
               TopExp::LastVertex(edge).IsSame(edges_.vertex(piece.ends[1]));
    }

    TopoDS_Edge copy(int index) const {
        const MergedEdges::Piece& piece = edges_.piece(index);
        const BRep_Builder builder;
        TopoDS_Edge edge = TopoDS::Edge(edges_.edge_of(piece).EmptyCopied());
        builder.Add(edge, edges_.vertex(piece.ends[0]).Oriented(TopAbs_FORWARD));
        builder.Add(edge, edges_.vertex(piece.ends[1]).Oriented(TopAbs_REVERSED));
        if (!edges_.is_whole(piece)) builder.Range(edge, piece.first, piece.last);
        for (const Trace& trace : traces_[std::size_t(index)])
            if (trace.against.IsNull())
                builder.UpdateEdge(edge, trace.along, trace.surface, trace.place, trace.tolerance);
            else
                builder.UpdateEdge(edge, trace.along, trace.against, trace.surface, trace.place, trace.tolerance);
        return edge;
    }

    const MergedEdges& edges_;
    std::vector<std::vector<Trace>> traces_;  // by piece
    std::map<int, TopoDS_Edge> made_;
};

/// A face of the shells: all of a face of the patch, or a region of its surface.
struct Sheet {
    struct Coedge {
        int piece = 0, sense = 1;  // along the piece or against it in `face` oriented forward
    };
    std::size_t on = 0;
    bool vanished = false, is_whole = false, is_reversed = false;
    std::vector<std::vector<Coedge>> wires;
    TopoDS_Face face;  // out of what was removed less what was added
    Box box;
};

class PatchShells {
  public:
    explicit PatchShells(const PatchInput& input)
        : input_(input), faces_(patch_faces(input.vanished, input.appeared)), edges_(faces_), pieces_(edges_) {
        for (std::size_t f = 0; f < faces_.size(); ++f)
            if (faces_[f].underlying < 0) add_whole(f);
        for (const SurfaceCap& cap : surface_caps(faces_, edges_)) add(cap);
        for (Sheet& sheet : sheets_) make(sheet);
        if (any_contact(contact_sheets(), faces_, edges_))
            throw Standard_DomainError("faces that meet without an edge");
    }

    PatchVolumes volumes() const {
        PatchVolumes found{{}, {}, 0};
        std::vector<std::pair<Box, TopoDS_Shape>> solids[2];  // of what was added, of what was removed
        for (const std::vector<std::size_t>& members : shells()) {
            Box box;
            for (const std::size_t s : members) box.add(sheets_[s].box);
            double volume = 0;
            for (const std::size_t s : members) volume += flux_of(sheets_[s]);
            found.change -= volume;
            if (std::abs(volume) <= no_volume * std::pow(box.diagonal(), 3))
                throw Standard_DomainError("a shell without volume");
            const bool is_removed = volume > 0;
            solids[is_removed].emplace_back(box, solid_of(members, !is_removed));
            (is_removed ? found.removed : found.added).push_back(solids[is_removed].back().second);
        }
        for (const auto& [box, solid] : solids[0])
            for (const auto& [other_box, other] : solids[1])
                if ((is_within(box, other_box) && is_within(solid, other)) ||
                    (is_within(other_box, box) && is_within(other, solid)))
                    throw Standard_DomainError("a cavity");
        return found;
    }

  private:
    static bool is_within(const Box& inner, const Box& outer) {
        return outer.contains(inner.low) && outer.contains(inner.high);
    }

    std::vector<ContactSheet> contact_sheets() const {
        std::vector<ContactSheet> list;
        for (const Sheet& sheet : sheets_) {
            ContactSheet& contact = list.emplace_back(ContactSheet{sheet.face, sheet.box, sheet.vanished, {}});
            for (const auto& wire : sheet.wires)
                for (const Sheet::Coedge& coedge : wire) contact.border.push_back(coedge.piece);
        }
        return list;
    }

    double flux_of(const Sheet& sheet) const {
        const PatchFace& on = faces_[sheet.on];
        if (!sheet.is_whole) return flux(sheet.face, input_.apex, sheet.box.diagonal());
        return on.vanished ? input_.flux_of_vanished[on.index] : -input_.flux_of_appeared[on.index];
    }

    /// Of two solids whose borders do not cross.
    static bool is_within(const TopoDS_Shape& inner, const TopoDS_Shape& outer) {
        const auto point = point_on(TopoDS::Face(TopExp_Explorer(inner, TopAbs_FACE).Current()));
        return !point || SolidProbe(outer).containment_of(point->point) != Containment::outside;
    }

    void add_whole(std::size_t f) {
        Sheet& sheet = sheets_.emplace_back();
        sheet.on = f;
        sheet.is_whole = true;
        sheet.vanished = faces_[f].vanished;
        sheet.is_reversed = (faces_[f].face.Orientation() == TopAbs_REVERSED) == faces_[f].vanished;
        for (const MergedEdges::Wire& wire : edges_.wires_of(f)) {
            std::vector<Sheet::Coedge>& coedges = sheet.wires.emplace_back();
            for (const MergedEdges::Use& use : wire) {
                pieces_.need(use, faces_[f].face, faces_[f].face, {});
                coedges.push_back({use.piece, use.sense});
            }
        }
    }

    void add(const SurfaceCap& cap) {
        Sheet& sheet = sheets_.emplace_back();
        sheet.on = cap.on;
        sheet.vanished = cap.vanished;
        sheet.is_reversed = (faces_[cap.on].face.Orientation() == TopAbs_REVERSED) == cap.vanished;
        for (const std::vector<SurfaceCap::Coedge>& wire : cap.wires) {
            std::vector<Sheet::Coedge>& coedges = sheet.wires.emplace_back();
            for (const SurfaceCap::Coedge& coedge : wire) {
                pieces_.need(coedge.use, faces_[coedge.face].face, faces_[cap.on].face, coedge.shift);
                coedges.push_back({coedge.use.piece, coedge.sense});
            }
        }
    }

    void make(Sheet& sheet) {
        const TopoDS_Face& on = faces_[sheet.on].face;
        sheet.face = sheet.is_whole && are_edges_kept(sheet) ? on : bordered(on, sheet);
        sheet.face.Orientation(sheet.is_reversed ? TopAbs_REVERSED : TopAbs_FORWARD);
        sheet.box = box_of(sheet.face);
    }

    bool are_edges_kept(const Sheet& sheet) const {
        std::size_t w = 0;
        for (const MergedEdges::Wire& wire : edges_.wires_of(sheet.on)) {
            for (const MergedEdges::Use& use : wire)
                if (use.own != use.piece || !pieces_.is_kept(use.piece)) return false;
            ++w;
        }
        return w > 0;
    }

    TopoDS_Face bordered(const TopoDS_Face& on, const Sheet& sheet) {
        const BRep_Builder builder;
        TopoDS_Face face = TopoDS::Face(on.EmptyCopied());
        face.Orientation(TopAbs_FORWARD);
        for (const std::vector<Sheet::Coedge>& coedges : sheet.wires) {
            TopoDS_Wire wire;
            builder.MakeWire(wire);
            for (const Sheet::Coedge& coedge : coedges)
                builder.Add(wire,
                            pieces_.edge(coedge.piece).Oriented(coedge.sense > 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
            wire.Closed(true);
            builder.Add(face, wire);
        }
        return face;
    }

    /// Sheets that hang together, each group closed: two of them, with opposite senses, at every edge.
    std::vector<std::vector<std::size_t>> shells() const {
        std::vector<std::size_t> root(sheets_.size());
        std::iota(root.begin(), root.end(), 0);
        const auto root_of = [&](std::size_t s) {
            while (root[s] != s) s = root[s];
            return s;
        };
        std::map<int, std::vector<std::pair<std::size_t, int>>> around;
        for (std::size_t s = 0; s < sheets_.size(); ++s)
            for (const auto& wire : sheets_[s].wires)
                for (const Sheet::Coedge& coedge : wire)
                    if (!edges_.is_degenerated(edges_.piece(coedge.piece)))
                        around[coedge.piece].emplace_back(s, sheets_[s].is_reversed ? -coedge.sense : coedge.sense);
        for (const auto& [piece, uses] : around) {
            if (uses.size() != 2 || uses[0].second == uses[1].second)
                throw Standard_DomainError("faces that do not close");
            const std::size_t a = root_of(uses[0].first), b = root_of(uses[1].first);
            root[std::max(a, b)] = std::min(a, b);
        }
        std::map<std::size_t, std::vector<std::size_t>> groups;
        for (std::size_t s = 0; s < sheets_.size(); ++s) groups[root_of(s)].push_back(s);
        std::vector<std::vector<std::size_t>> list;
        for (auto& [first, members] : groups) list.push_back(std::move(members));
        return list;
    }

    TopoDS_Solid solid_of(const std::vector<std::size_t>& members, bool turned) const {
        const BRep_Builder builder;
        TopoDS_Shell shell;
        builder.MakeShell(shell);
        for (const std::size_t s : members)
            builder.Add(shell, turned ? sheets_[s].face.Reversed() : TopoDS_Shape(sheets_[s].face));
        shell.Closed(true);
        TopoDS_Solid solid;
        builder.MakeSolid(solid);
        builder.Add(solid, shell);
        return solid;
    }

    const PatchInput& input_;
    std::vector<PatchFace> faces_;
    MergedEdges edges_;
    PieceEdges pieces_;
    std::vector<Sheet> sheets_;
};

}  // namespace

std::optional<PatchVolumes> patch_volumes(const PatchInput& input) {
    try {
        return PatchShells(input).volumes();
    } catch (const Standard_Failure&) {
        return std::nullopt;
    }
}

}  // namespace featuremesh

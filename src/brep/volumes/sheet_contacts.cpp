// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/volumes/sheet_contacts.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Geom_Surface.hxx>
#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <set>

#include "brep/face_probe.h"
#include "brep/occt_geometry.h"

namespace featuremesh {

namespace {

constexpr double generous = 10;  // times the tolerances

struct Foot {
    double u = 0, v = 0;
    double offset = 0;  ///< of the point from the surface, along its normal
};

/// Feet of points on a surface. On a free-form one by Newton's method from the nearest of a few points: to search all
/// of it, or near those with the kernel's Extrema_GenLocateExtPS, costs a hundred times as much.
class Feet {
  public:
    explicit Feet(const TopoDS_Face& face)
        : face_(face),
          surface_(face, false),
          u_(surface_.FirstUParameter(), surface_.LastUParameter(), surface_.IsUPeriodic()),
          v_(surface_.FirstVParameter(), surface_.LastVParameter(), surface_.IsVPeriodic()) {
        if (surface_.GetType() <= GeomAbs_Torus) return;
        double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
        BRepTools::UVBounds(face, u1, u2, v1, v2);
        // The adaptor prepares a table for the patch that it evaluates. With a single patch that happens once; with
        // many it would happen at nearly every call.
        const bool is_one_patch =
            surface_.GetType() == GeomAbs_BSplineSurface && surface_.NbUKnots() == 2 && surface_.NbVKnots() == 2;
        TopLoc_Location place;
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, place);
        constexpr int count = 8;
        for (int i = 0; i <= count; ++i)
            for (int k = 0; k <= count; ++k) {
                const double u = u1 + i * (u2 - u1) / count, v = v1 + k * (v2 - v1) / count;
                const gp_Pnt point =
                    is_one_patch ? surface_.Value(u, v) : surface->Value(u, v).Transformed(place.Transformation());
                samples_.push_back({u, v, to_vec3(point)});
            }
    }

    Foot of(const Vec3& p) const {
        const At at = samples_.empty() ? by_formula(p) : by_newton(p);
        const Vec3 off = p - at.point;
        const double height = dot(off, cross(at.du, at.dv)) * (face_.Orientation() == TopAbs_REVERSED ? -1 : 1);
        const bool is_below = height < -1e-12 * length(off) * length(at.du) * length(at.dv);  // never at a pole
        return {at.u, at.v, is_below ? -length(off) : length(off)};
    }

  private:
    struct Sample {
        double u = 0, v = 0;
        Vec3 point;
    };

    /// All but the ends of a range of parameters, where the kernel takes several times as long. A period goes on.
    struct Range {
        double low = 0, high = 0;
        Range(double first, double last, bool is_period) {
            const double beyond = is_period ? std::numeric_limits<double>::infinity() : -1e-12 * (last - first);
            low = first - beyond, high = last + beyond;
        }
    };

    /// A point of the surface with its derivatives.
    struct At {
        double u = 0, v = 0;
        Vec3 point, du, dv;
    };

    At at(double u, double v) const {
        gp_Pnt point;
        gp_Vec du, dv;
        surface_.D1(u, v, point, du, dv);
        return {u, v, to_vec3(point), to_vec3(du), to_vec3(dv)};
    }

    At inner(double u, double v) const { return at(std::clamp(u, u_.low, u_.high), std::clamp(v, v_.low, v_.high)); }

    At by_formula(const Vec3& p) const {
        double u = 0, v = 0;
        switch (surface_.GetType()) {
            case GeomAbs_Plane:
                ElSLib::Parameters(surface_.Plane(), to_pnt(p), u, v);
                break;
            case GeomAbs_Cylinder:
                ElSLib::Parameters(surface_.Cylinder(), to_pnt(p), u, v);
                break;
            case GeomAbs_Cone:
                ElSLib::Parameters(surface_.Cone(), to_pnt(p), u, v);
                break;
            case GeomAbs_Sphere:
                ElSLib::Parameters(surface_.Sphere(), to_pnt(p), u, v);
                break;
            default:
                ElSLib::Parameters(surface_.Torus(), to_pnt(p), u, v);
        }
        return at(u, v);
    }

    At by_newton(const Vec3& p) const {
        const auto nearest = std::min_element(samples_.begin(), samples_.end(), [&](const Sample& a, const Sample& b) {
            return squared_length(a.point - p) < squared_length(b.point - p);
        });
        At best = inner(nearest->u, nearest->v);
        for (int step = 0; step < 12; ++step) {
            const Vec3 off = p - best.point;
            const double aa = dot(best.du, best.du), ab = dot(best.du, best.dv), bb = dot(best.dv, best.dv);
            const double determinant = aa * bb - ab * ab;
            if (determinant <= 1e-12 * aa * bb) break;
            const At next = inner(best.u + (dot(off, best.du) * bb - dot(off, best.dv) * ab) / determinant,
                                  best.v + (dot(off, best.dv) * aa - dot(off, best.du) * ab) / determinant);
            const double is = length(p - next.point), was = length(off);
            if (is < was) best = next;
            if (is > 0.999 * was) break;
        }
        return best;
    }

    TopoDS_Face face_;
    BRepAdaptor_Surface surface_;
    Range u_, v_;
    std::vector<Sample> samples_;
};

/// Pieces of one sheet's counterpart against the sheet.
class SheetContacts {
  public:
    SheetContacts(const ContactSheet& sheet, const MergedEdges& edges)
        : sheet_(sheet), edges_(edges), probe_(sheet.face), box_(sheet.box.grown(BRep_Tool::Tolerance(sheet.face))) {
        for (const int p : sheet.border) {
            border_.insert(p);
            for (const int end : edges_.piece(p).ends) corners_.insert(end);
        }
    }

    bool meets(int index, const Box& reach) {
        if (!reach.overlaps(box_) || border_.count(index) > 0) return false;
        const MergedEdges::Piece& piece = edges_.piece(index);
        if (edges_.is_degenerated(piece)) return false;
        const double first = piece.first, length = piece.last - piece.first;
        const std::array<double, 4> at{first, first + 0.25 * length, first + 0.75 * length, piece.last};
        const std::array<Vec3, 4> points{edges_.position(piece.ends[0]), (*piece.inner)[0], (*piece.inner)[1],
                                         edges_.position(piece.ends[1])};
        if (!feet_) feet_ = std::make_unique<Feet>(sheet_.face);
        const double close =
            generous * (BRep_Tool::Tolerance(edges_.edge_of(piece)) + BRep_Tool::Tolerance(sheet_.face));
        std::array<double, 4> offsets{};
        for (std::size_t i = 0; i < 4; ++i) {
            const bool is_corner = i % 3 == 0 && corners_.count(piece.ends[i / 3]) > 0;
            offsets[i] = is_corner ? 0.0 : feet_->of(points[i]).offset;
            if (std::abs(offsets[i]) <= close) offsets[i] = 0;
        }
        if (offsets[1] == 0 && offsets[2] == 0) return is_within(points[1], close) || is_within(points[2], close);
        for (std::size_t i = 0; i + 1 < 4; ++i)
            if (offsets[i] * offsets[i + 1] < 0 && goes_through(piece, at[i], at[i + 1], offsets[i] < 0)) return true;
        return (offsets[1] == 0 && offsets[0] * offsets[2] < 0 && is_within(points[1], close)) ||
               (offsets[2] == 0 && offsets[1] * offsets[3] < 0 && is_within(points[2], close));
    }

  private:
    bool is_within(const Vec3& p, double close) const {
        if (!box_.grown(close).contains(p)) return false;
        const Foot foot = feet_->of(p);
        return probe_.contains(foot.u, foot.v);
    }

    bool goes_through(const MergedEdges::Piece& piece, double from, double to, bool is_below) const {
        const BRepAdaptor_Curve curve(edges_.edge_of(piece));
        for (int step = 0; step < 30; ++step) {
            const double middle = (from + to) / 2;
            ((feet_->of(to_vec3(curve.Value(middle))).offset < 0) == is_below ? from : to) = middle;
        }
        const Vec3 p = to_vec3(curve.Value(from));
        const Foot foot = feet_->of(p);
        // The piece passes through the sheet only if it is close to it here. Otherwise the sign of the offset changed
        // because the foot jumped to another part of the surface.
        const double close = generous * BRep_Tool::Tolerance(sheet_.face) + 1e-6 * box_.diagonal();
        return std::abs(foot.offset) <= close && box_.grown(close).contains(p) && probe_.contains(foot.u, foot.v);
    }

    const ContactSheet& sheet_;
    const MergedEdges& edges_;
    FaceProbe probe_;
    Box box_;
    std::set<int> border_, corners_;
    std::unique_ptr<Feet> feet_;
};

/// Where a piece can be at all.
Box reach_of(const MergedEdges& edges, const MergedEdges::Piece& piece) {
    Box box;
    if (edges.is_degenerated(piece)) return box;
    for (const Vec3& p : *piece.inner) box.add(p);
    for (const int end : piece.ends) box.add(edges.position(end));
    return box.grown(0.25 * box.diagonal());  // a curve may bulge beyond its points
}

}  // namespace

bool any_contact(const std::vector<ContactSheet>& sheets, const std::vector<PatchFace>& faces,
                 const MergedEdges& edges) {
    std::vector<std::array<bool, 2>> is_of(edges.piece_count(), {false, false});  // faces that appeared, that vanished
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (const MergedEdges::Wire& wire : edges.wires_of(f))
            for (const MergedEdges::Use& use : wire) is_of[std::size_t(use.piece)][faces[f].vanished] = true;
    std::vector<Box> reach;
    for (std::size_t p = 0; p < is_of.size(); ++p) reach.push_back(reach_of(edges, edges.piece(int(p))));
    for (const ContactSheet& sheet : sheets) {
        SheetContacts contacts(sheet, edges);
        for (std::size_t p = 0; p < is_of.size(); ++p)
            if (is_of[p][!sheet.vanished] && !is_of[p][sheet.vanished] && contacts.meets(int(p), reach[p])) return true;
    }
    return false;
}

}  // namespace featuremesh

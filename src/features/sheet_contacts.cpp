// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/sheet_contacts.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Extrema_GenLocateExtPS.hxx>
#include <algorithm>
#include <array>
#include <memory>
#include <set>

#include "features/face_probe.h"
#include "features/occt_geometry.h"

namespace featuremesh {

namespace {

constexpr double generous = 10;  // times the tolerances

struct Foot {
    double u = 0, v = 0;
    double offset = 0;  ///< of the point from the surface, along its normal
};

/// Feet of points on a surface. On a free-form one searched for from the nearest of a few points: to search all of it
/// costs a hundred times as much.
class Feet {
  public:
    explicit Feet(const TopoDS_Face& face) : face_(face), surface_(face, false) {
        if (surface_.GetType() <= GeomAbs_Torus) return;
        double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
        BRepTools::UVBounds(face, u1, u2, v1, v2);
        constexpr int count = 8;
        for (int i = 0; i <= count; ++i)
            for (int k = 0; k <= count; ++k) {
                const double u = u1 + i * (u2 - u1) / count, v = v1 + k * (v2 - v1) / count;
                samples_.push_back({u, v, to_vec3(surface_.Value(u, v))});
            }
    }

    Foot of(const Vec3& p) const {
        Foot foot = samples_.empty() ? by_formula(p) : by_search(p);
        const Vec3 off = p - to_vec3(surface_.Value(foot.u, foot.v));
        foot.offset = dot(off, outward_normal(surface_, face_, foot.u, foot.v)) < 0 ? -length(off) : length(off);
        return foot;
    }

  private:
    struct Sample {
        double u = 0, v = 0;
        Vec3 point;
    };

    Foot by_formula(const Vec3& p) const {
        Foot foot;
        switch (surface_.GetType()) {
            case GeomAbs_Plane:
                ElSLib::Parameters(surface_.Plane(), to_pnt(p), foot.u, foot.v);
                break;
            case GeomAbs_Cylinder:
                ElSLib::Parameters(surface_.Cylinder(), to_pnt(p), foot.u, foot.v);
                break;
            case GeomAbs_Cone:
                ElSLib::Parameters(surface_.Cone(), to_pnt(p), foot.u, foot.v);
                break;
            case GeomAbs_Sphere:
                ElSLib::Parameters(surface_.Sphere(), to_pnt(p), foot.u, foot.v);
                break;
            default:
                ElSLib::Parameters(surface_.Torus(), to_pnt(p), foot.u, foot.v);
        }
        return foot;
    }

    Foot by_search(const Vec3& p) const {
        const auto nearest = std::min_element(samples_.begin(), samples_.end(), [&](const Sample& a, const Sample& b) {
            return squared_length(a.point - p) < squared_length(b.point - p);
        });
        Foot foot{nearest->u, nearest->v};
        Extrema_GenLocateExtPS local(surface_);
        local.Perform(to_pnt(p), foot.u, foot.v);
        if (local.IsDone()) local.Point().Parameter(foot.u, foot.v);
        return foot;
    }

    TopoDS_Face face_;
    BRepAdaptor_Surface surface_;
    std::vector<Sample> samples_;
};

/// Pieces of one sheet's counterpart against the sheet.
class SheetContacts {
  public:
    SheetContacts(const ContactSheet& sheet, const MergedEdges& edges)
        : sheet_(sheet), edges_(edges), probe_(sheet.face), box_(probe_.box().grown(BRep_Tool::Tolerance(sheet.face))) {
        for (const int p : sheet.border) {
            border_.insert(p);
            for (const int end : edges_.piece(p).ends) corners_.insert(end);
        }
    }

    bool meets(int index) {
        const MergedEdges::Piece& piece = edges_.piece(index);
        if (border_.count(index) > 0 || edges_.is_degenerated(piece)) return false;
        const double first = piece.first, length = piece.last - piece.first;
        const std::array<double, 4> at{first, first + 0.25 * length, first + 0.75 * length, piece.last};
        const std::array<Vec3, 4> points{edges_.position(piece.ends[0]), (*piece.inner)[0], (*piece.inner)[1],
                                         edges_.position(piece.ends[1])};
        Box reach;
        for (const Vec3& p : points) reach.add(p);
        // A curve may bulge beyond its points.
        if (!reach.grown(0.25 * reach.diagonal()).overlaps(box_)) return false;
        if (!feet_) feet_ = std::make_unique<Feet>(sheet_.face);
        const double close =
            generous * (BRep_Tool::Tolerance(edges_.edge_of(piece)) + BRep_Tool::Tolerance(sheet_.face));
        std::array<double, 4> offsets{};
        for (std::size_t i = 0; i < 4; ++i) {
            const bool is_corner = i % 3 == 0 && corners_.count(piece.ends[i / 3]) > 0;
            offsets[i] = is_corner ? 0.0 : feet_->of(points[i]).offset;
            if (std::abs(offsets[i]) <= close) offsets[i] = 0;
        }
        if (offsets[1] == 0 && offsets[2] == 0) return is_within(points[1]) || is_within(points[2]);
        for (std::size_t i = 0; i + 1 < 4; ++i)
            if (offsets[i] * offsets[i + 1] < 0 && goes_through(piece, at[i], at[i + 1], offsets[i] < 0)) return true;
        return (offsets[1] == 0 && offsets[0] * offsets[2] < 0 && is_within(points[1])) ||
               (offsets[2] == 0 && offsets[1] * offsets[3] < 0 && is_within(points[2]));
    }

  private:
    bool is_within(const Vec3& p) const {
        const Foot foot = feet_->of(p);
        return probe_.contains(foot.u, foot.v);
    }

    bool goes_through(const MergedEdges::Piece& piece, double from, double to, bool is_below) const {
        const BRepAdaptor_Curve curve(edges_.edge_of(piece));
        for (int step = 0; step < 40; ++step) {
            const double middle = (from + to) / 2;
            ((feet_->of(to_vec3(curve.Value(middle))).offset < 0) == is_below ? from : to) = middle;
        }
        const Vec3 p = to_vec3(curve.Value(from));
        const Foot foot = feet_->of(p);
        // Else the side changed where the foot sprang over to another part of the surface.
        const double close = generous * BRep_Tool::Tolerance(sheet_.face) + 1e-6 * box_.diagonal();
        return std::abs(foot.offset) <= close && probe_.contains(foot.u, foot.v);
    }

    const ContactSheet& sheet_;
    const MergedEdges& edges_;
    FaceProbe probe_;
    Box box_;
    std::set<int> border_, corners_;
    std::unique_ptr<Feet> feet_;
};

}  // namespace

bool any_contact(const std::vector<ContactSheet>& sheets, const std::vector<PatchFace>& faces,
                 const MergedEdges& edges) {
    std::vector<std::array<bool, 2>> is_of(edges.piece_count(), {false, false});  // faces that appeared, that vanished
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (const MergedEdges::Wire& wire : edges.wires_of(f))
            for (const MergedEdges::Use& use : wire) is_of[std::size_t(use.piece)][faces[f].vanished] = true;
    for (const ContactSheet& sheet : sheets) {
        SheetContacts contacts(sheet, edges);
        for (std::size_t p = 0; p < is_of.size(); ++p)
            if (is_of[p][!sheet.vanished] && !is_of[p][sheet.vanished] && contacts.meets(int(p))) return true;
    }
    return false;
}

}  // namespace featuremesh

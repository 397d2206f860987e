// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/narrow_faces.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <optional>

#include "features/occt_geometry.h"

namespace featuremesh {
namespace {

constexpr double widest = 1. / 5, narrowest = 1. / 25;  ///< of the size: what is refined
constexpr double longest = 4;                           ///< widths, of a piece
constexpr double step = 0.25;                           ///< of the size, between places that are looked at
constexpr double least_cosine = 0.978;                  ///< 12 degrees: wider corners have no needles

/// An edge of the face as a curve and as a polygon.
class Border {
  public:
    Border(const Brep& brep, const FaceEdge& use)
        : edge_(use.edge),
          is_forward_(use.is_forward),
          curve_(brep.edge(use.edge)),
          first_(curve_.FirstParameter()),
          last_(curve_.LastParameter()) {
        const int pieces = is_line() ? 1 : 32;
        for (int i = 0; i <= pieces; ++i) {
            points_.push_back(to_vec3(curve_.Value(at(double(i) / pieces))));
            if (i > 0) length_ += distance(points_[points_.size() - 2], points_.back());
        }
        for (const Vec3& p : points_) box_.add(p);
        if (!is_line()) box_ = box_.grown(0.3 * length_ / pieces);
    }

    EdgeId edge() const { return edge_; }
    bool is_line() const { return curve_.GetType() == GeomAbs_Line; }
    double length() const { return length_; }
    const Box& box() const { return box_; }
    /// The parameter at that share of the whole.
    double at(double share) const { return first_ + share * (last_ - first_); }

    struct Place {
        double t;
        Vec3 point, direction;  ///< the face on its left
    };
    Place place(double t) const {
        gp_Pnt p;
        gp_Vec d;
        curve_.D1(t, p, d);
        return {t, to_vec3(p), normalized(to_vec3(d)) * (is_forward_ ? 1.0 : -1.0)};
    }

    /// Where p is opposite the edge; nothing where it is beyond the ends.
    std::optional<Place> opposite(const Vec3& p) const {
        double best = std::numeric_limits<double>::max(), t = first_;
        for (std::size_t i = 1; i < points_.size(); ++i) {
            const Vec3 along = points_[i] - points_[i - 1];
            const double share =
                std::clamp(dot(p - points_[i - 1], along) / std::max(squared_length(along), 1e-300), 0.0, 1.0);
            const double squared = squared_length(p - points_[i - 1] - share * along);
            if (squared >= best) continue;
            best = squared;
            t = at((double(i - 1) + share) / double(points_.size() - 1));
        }
        for (int k = 0; k < 4; ++k) {
            gp_Pnt q;
            gp_Vec d;
            curve_.D1(t, q, d);
            const Vec3 speed = to_vec3(d);
            t = std::clamp(t + dot(p - to_vec3(q), speed) / std::max(squared_length(speed), 1e-300), first_, last_);
        }
        if (!(t > first_ && t < last_)) return {};
        return place(t);
    }

  private:
    EdgeId edge_;
    bool is_forward_;
    BRepAdaptor_Curve curve_;
    double first_, last_, length_ = 0;
    std::vector<Vec3> points_;
    Box box_;
};

class NarrowFaceCover {
  public:
    NarrowFaceCover(const Brep& brep, FaceId face, const SizingOptions& options, std::vector<SourceBall>& out)
        : brep_(brep), face_(face), options_(options), out_(out) {}

    void run() {
        for (const FaceEdge& use : brep_.uses_in(face_))
            if (!use.is_internal && !use.is_external && !brep_.is_degenerated(use.edge) &&
                !brep_.is_seam(use.edge, face_))
                borders_.emplace_back(brep_, use);
        for (const Border& a : borders_)
            for (const Border& b : borders_)
                if (&a != &b && may_be_narrow(a, b)) cover(a, b);
    }

  private:
    bool may_be_narrow(const Border& a, const Border& b) const {
        if (!a.box().grown(widest * options_.size).overlaps(b.box())) return false;
        if (have_common_end(a, b)) return false;
        return !a.is_line() || !b.is_line() || runs_against(a.place(a.at(0.5)), b.place(b.at(0.5)));
    }
    bool have_common_end(const Border& a, const Border& b) const {
        const auto [first, last] = brep_.ends_of(a.edge());
        const auto [from, to] = brep_.ends_of(b.edge());
        return first == from || first == to || last == from || last == to;
    }
    static bool runs_against(const Border::Place& a, const Border::Place& b) {
        return dot(a.direction, b.direction) <= -least_cosine;
    }

    /// Along the first as far as the second is near across the face.
    void cover(const Border& a, const Border& b) {
        const Box near = b.box().grown(widest * options_.size);
        const int count = std::max(4, static_cast<int>(std::ceil(a.length() / (step * options_.size))));
        for (int i = 0; i < count; ++i) {
            const Border::Place at = a.place(a.at((i + 0.5) / count));
            if (!near.contains(at.point)) continue;
            const std::optional<Border::Place> other = b.opposite(at.point);
            if (!other || !runs_against(at, *other)) continue;
            const double width = distance(at.point, other->point);
            if (width > widest * options_.size || width < narrowest * options_.size) continue;
            const double size = std::max(longest * width, options_.min_size);
            if (a.length() <= size) continue;
            if (size < options_.size && is_across(a, at, b, *other) && !is_thin_wall(a, at, b, *other))
                out_.push_back({at.point, 0.5 * a.length() / count, size});
        }
    }

    /// Whether each place has the face on the side where the other is.
    bool is_across(const Border& a, const Border::Place& at, const Border& b, const Border::Place& other) const {
        const Vec3 to_other = other.point - at.point;
        return dot(cross(normal(face_, a.edge(), at.t), at.direction), to_other) > 0 &&
               dot(cross(normal(face_, b.edge(), other.t), other.direction), to_other) < 0;
    }

    /// Whether the faces beyond the two edges are the two sides of a wall.
    bool is_thin_wall(const Border& a, const Border::Place& at, const Border& b, const Border::Place& other) const {
        const Vec3 n = outward_beyond(a.edge(), at.t), m = outward_beyond(b.edge(), other.t);
        return dot(n, m) < -0.7 && dot(n, at.point - other.point) > 0;
    }

    /// Out of the solid, on the face on the other side of the edge.
    Vec3 outward_beyond(EdgeId edge, double t) const {
        for (const FaceId f : brep_.faces_of(edge))
            if (f != face_) return brep_.sides_of(f)[0].is_valid() ? normal(f, edge, t) : -normal(f, edge, t);
        return {};
    }

    /// Of the face as it is oriented in the shape; zero where it has none.
    Vec3 normal(FaceId face, EdgeId edge, double t) const {
        double first, last;
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(brep_.edge(edge), brep_.face(face), first, last);
        if (curve.IsNull()) return {};
        const gp_Pnt2d uv = curve->Value(t);
        return outward_normal(BRepAdaptor_Surface(brep_.face(face), false), brep_.face(face), uv.X(), uv.Y());
    }

    const Brep& brep_;
    const FaceId face_;
    const SizingOptions& options_;
    std::vector<SourceBall>& out_;
    std::vector<Border> borders_;
};

}  // namespace

void cover_narrow_face(const Brep& brep, FaceId face, const SizingOptions& options, std::vector<SourceBall>& out) {
    NarrowFaceCover(brep, face, options, out).run();
}

}  // namespace featuremesh

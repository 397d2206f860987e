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

#include "brep/occt_geometry.h"
#include "core/box_tree.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "sizing/source_ball.h"

namespace featuremesh {
namespace {

constexpr double widest = 1. / 5, narrowest = 1. / 25;  ///< of the size: what is refined
constexpr double longest = 4;                           ///< widths, of a piece
constexpr double shortest = 1. / 4;                     ///< of the size, of a piece
constexpr double least_run = 1.25;                      ///< pieces, along which a strip has to be a strip
constexpr double step = 0.25;                           ///< of the size, between places that are looked at
constexpr double most_places = 1e5;                     ///< that are looked at along an edge
constexpr double least_cosine = 0.99985;                ///< 1 degree between the two borders of a strip

/// An edge of the face as a curve and as a polygon.
class Border {
  public:
    Border(const Brep& brep, const FaceEdge& use)
        : edge_(use.edge),
          is_forward_(use.is_forward),
          curve_(brep.edge(use.edge)),
          first_(curve_.FirstParameter()),
          last_(curve_.LastParameter()) {
        const int pieces = is_line() ? 1 : curve_.GetType() == GeomAbs_Circle ? 8 : 32;
        points_.reserve(std::size_t(pieces) + 1);
        for (int i = 0; i <= pieces; ++i) {
            points_.push_back(to_vec3(curve_.Value(at(double(i) / pieces))));
            if (i > 0) length_ += distance(points_[points_.size() - 2], points_.back());
        }
        if (!is_line()) off_polygon_ = 0.3 * length_ / pieces;
    }

    EdgeId edge() const { return edge_; }
    bool is_line() const { return curve_.GetType() == GeomAbs_Line; }
    double length() const { return length_; }
    /// The parameter at that share of the whole.
    double at(double share) const { return first_ + share * (last_ - first_); }

    Vec3 point(double share) const { return to_vec3(curve_.Value(at(share))); }

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

    /// Where p is opposite the edge; nothing where it is beyond the ends, or clearly further off than `furthest`.
    std::optional<Place> opposite(const Vec3& p, double furthest = std::numeric_limits<double>::max()) const {
        double best = std::numeric_limits<double>::max(), t = first_;
        for (std::size_t i = 1; i < points_.size(); ++i) {
            const Vec3 along = points_[i] - points_[i - 1];
            const double share =
                std::clamp(dot(p - points_[i - 1], along) / std::max(squared_length(along), 1e-300), 0.0, 1.0);
            const double squared_distance = squared_length(p - points_[i - 1] - share * along);
            if (squared_distance >= best) continue;
            best = squared_distance;
            t = at((double(i - 1) + share) / double(points_.size() - 1));
        }
        if (std::sqrt(best) > furthest + off_polygon_) return {};
        for (int k = 0; k < (is_line() ? 1 : 4); ++k) {  // the first one is exact on a line
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
    double first_, last_, length_ = 0, off_polygon_ = 0;
    std::vector<Vec3> points_;
};

bool have_common_end(const Brep& brep, EdgeId a, EdgeId b) {
    const auto [first, last] = brep.ends_of(a);
    const auto [from, to] = brep.ends_of(b);
    return first == from || first == to || last == from || last == to;
}

/// The borders of a face, each made when it is asked for: few edges are near another one.
class FaceBorders {
  public:
    FaceBorders(const Brep& brep, FaceId face) : brep_(brep) {
        for (const FaceEdge& use : brep.uses_in(face))
            if (!use.is_internal && !use.is_external && !brep.is_degenerated(use.edge) && !brep.is_seam(use.edge, face))
                uses_.push_back(use);
        made_.resize(uses_.size());
        std::vector<Box> boxes(uses_.size());
        for (std::size_t i = 0; i < uses_.size(); ++i) boxes[i] = brep.box_of(uses_[i].edge);
        tree_.emplace(boxes);
    }

    std::size_t size() const { return uses_.size(); }
    EdgeId edge(std::size_t i) const { return uses_[i].edge; }
    /// Those whose box overlaps `box`, in ascending order.
    std::vector<std::size_t> near(const Box& box) const {
        std::vector<std::size_t> found;
        tree_->visit_where([&](const Box& other) { return box.overlaps(other); },
                           [&](std::int32_t i) { found.push_back(std::size_t(i)); });
        std::sort(found.begin(), found.end());
        return found;
    }
    const Border& operator[](std::size_t i) {
        if (!made_[i]) made_[i].emplace(brep_, uses_[i]);
        return *made_[i];
    }

  private:
    const Brep& brep_;
    std::vector<FaceEdge> uses_;
    std::vector<std::optional<Border>> made_;
    std::optional<BoxTree> tree_;
};

/// Those of each face, made when they are asked for.
class Borders {
  public:
    explicit Borders(const Brep& brep) : brep_(brep), of_face_(brep.face_count()) {}

    FaceBorders& of(FaceId face) {
        std::optional<FaceBorders>& borders = of_face_[face.index()];
        if (!borders) borders.emplace(brep_, face);
        return *borders;
    }

  private:
    const Brep& brep_;
    std::vector<std::optional<FaceBorders>> of_face_;
};

class NarrowFaceCover {
  public:
    NarrowFaceCover(const Brep& brep, FaceId face, const SizingOptions& options, Borders& all,
                    std::vector<SourceBall>& out)
        : brep_(brep), face_(face), options_(options), all_(all), borders_(all.of(face)), out_(out) {}

    void run(const RunContext& context) {
        for (std::size_t i = 0; i < borders_.size(); ++i) {
            context.check_cancelled();
            for (const std::size_t j : borders_.near(brep_.box_of(borders_.edge(i)).grown(widest * options_.size)))
                if (j < i && !have_common_end(brep_, borders_.edge(i), borders_.edge(j)) &&
                    may_be_narrow(borders_[i], borders_[j]))
                    cover(borders_[i], borders_[j]), cover(borders_[j], borders_[i]);
        }
    }

  private:
    static bool may_be_narrow(const Border& a, const Border& b) {
        return !a.is_line() || !b.is_line() || runs_against(a.place(a.at(0.5)), b.place(b.at(0.5)));
    }
    static bool runs_against(const Border::Place& a, const Border::Place& b) {
        return dot(a.direction, b.direction) <= -least_cosine;
    }

    /// No more than a mesh with not too many elements asks for.
    int places_along(double length, double least) const {
        return static_cast<int>(std::clamp(std::ceil(length / (step * options_.size)), least, most_places));
    }

    /// Along the first as far as the second runs beside it, where all of that is a strip: a lens is none.
    void cover(const Border& a, const Border& b) {
        const Box near = brep_.box_of(b.edge()).grown(widest * options_.size);
        const int count = places_along(a.length(), 4);
        const auto share = [&](int i) { return std::clamp((i + 0.5) / count, 0.0, 1.0); };
        const auto is_narrow = [&](double s) { return width_at(a, s, b, near).has_value(); };
        const auto is_beyond = [&](double s) { return s <= 0 || s >= 1 || !b.opposite(a.point(s)); };
        for (int i = 0; i < count; ++i) {
            if (!is_narrow(share(i))) continue;
            const End begin = end_of(is_narrow, {share(i), share(i - 1)});
            while (i + 1 < count && is_narrow(share(i + 1))) ++i;
            const End end = end_of(is_narrow, {share(i), share(i + 1)});
            if (is_beyond(begin.outside) && is_beyond(end.outside)) cover(a, begin.inside, end.inside, b, near);
        }
    }

    struct End {
        double inside, outside;
    };
    /// Closes in on the end, so that what is asked for does not depend on how long the edges are beyond.
    template <class Holds>
    static End end_of(Holds holds, End end) {
        constexpr int halvings = 8;
        for (int k = 0; k < halvings; ++k) {
            const double middle = 0.5 * (end.inside + end.outside);
            (holds(middle) ? end.inside : end.outside) = middle;
        }
        return end;
    }

    void cover(const Border& a, double from, double to, const Border& b, const Box& near) {
        const double length = (to - from) * a.length();
        const int count = places_along(length, 1);
        const auto share = [&](double i) { return from + (to - from) * i / count; };
        for (int i = 0; i < count; ++i) {
            const std::optional<double> width = width_at(a, share(i + 0.5), b, near);
            if (!width) continue;
            const double size = std::max({longest * *width, shortest * options_.size, options_.min_size});
            if (size >= options_.size || length < least_run * size) continue;
            const Vec3 center = a.point(share(i + 0.5)), begin = a.point(share(i)), end = a.point(share(i + 1));
            const double radius = std::max(distance(center, begin), distance(center, end));
            out_.push_back({center, radius + 0.5 * *width, size});
        }
    }

    /// Of the face at that share of the first, where it is a narrow strip between the two.
    std::optional<double> width_at(const Border& a, double share, const Border& b, const Box& near) const {
        if (!near.contains(a.point(share))) return {};
        const Border::Place at = a.place(a.at(share));
        const std::optional<Border::Place> other = b.opposite(at.point, widest * options_.size);
        if (!other || !runs_against(at, *other)) return {};
        const double width = distance(at.point, other->point);
        if (width > widest * options_.size || width < narrowest * options_.size) return {};
        if (!is_across(a, at, b, *other) || is_wide_wall(a, at, b, *other)) return {};
        return width;
    }

    /// Whether each place has the face where the other is.
    bool is_across(const Border& a, const Border::Place& at, const Border& b, const Border::Place& other) const {
        const Vec3 to_other = other.point - at.point;
        return dot(cross(normal(face_, a.edge(), at.t), at.direction), to_other) > 0 &&
               dot(cross(normal(face_, b.edge(), other.t), other.direction), to_other) < 0;
    }

    /// Whether the faces beyond the two edges are those of one wall that goes on for more than a size: its tets are as
    /// thin everywhere. A low rib is a strip.
    bool is_wide_wall(const Border& a, const Border::Place& at, const Border& b, const Border::Place& other) const {
        const Vec3 n = outward_beyond(a.edge(), at.t), m = outward_beyond(b.edge(), other.t);
        return dot(n, m) < -0.7 && dot(n, at.point - other.point) > 0 && is_wide_beyond(a.edge(), at) &&
               is_wide_beyond(b.edge(), other);
    }

    /// Whether no other border of the face beyond the edge runs beside it within a size.
    bool is_wide_beyond(EdgeId edge, const Border::Place& at) const {
        constexpr double least_parallel_cosine = 0.7;
        const Box near = Box{at.point, at.point}.grown(options_.size);
        for (const FaceId f : brep_.faces_of(edge)) {
            if (f == face_) continue;
            FaceBorders& borders = all_.of(f);
            for (const std::size_t i : borders.near(near)) {
                const EdgeId other = borders.edge(i);
                if (other == edge || have_common_end(brep_, other, edge)) continue;
                const std::optional<Border::Place> across = borders[i].opposite(at.point, options_.size);
                if (across && distance(across->point, at.point) <= options_.size &&
                    dot(across->direction, at.direction) > least_parallel_cosine)
                    return false;
            }
        }
        return true;
    }

    /// Out of the solid, on the face beyond the edge.
    Vec3 outward_beyond(EdgeId edge, double t) const {
        for (const FaceId f : brep_.faces_of(edge))
            if (f != face_) return brep_.solids_beside(f)[0].is_valid() ? normal(f, edge, t) : -normal(f, edge, t);
        return {};
    }

    /// Of the face as it is oriented in the shape; zero where it has none.
    Vec3 normal(FaceId face, EdgeId edge, double t) const {
        const BRepAdaptor_Surface surface(brep_.face(face), false);
        // the kernel would project the edge's curve onto the plane each time
        if (surface.GetType() == GeomAbs_Plane) return outward_normal(surface, brep_.face(face), 0, 0);
        double first, last;
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(brep_.edge(edge), brep_.face(face), first, last);
        if (curve.IsNull()) return {};
        const gp_Pnt2d uv = curve->Value(t);
        return outward_normal(surface, brep_.face(face), uv.X(), uv.Y());
    }

    const Brep& brep_;
    const FaceId face_;
    const SizingOptions& options_;
    Borders& all_;
    FaceBorders& borders_;
    std::vector<SourceBall>& out_;
};

class NarrowFaceProvider : public SizeProvider {
  public:
    NarrowFaceProvider(const Brep& brep, const SizingOptions& options) : brep_(brep), options_(options) {}

    void cover(SizePlaces& out, const RunContext& context) const override {
        if (!options_.refines_narrow_faces) return;
        Borders borders(brep_);
        for (std::size_t f = 0; f < brep_.face_count(); ++f)
            NarrowFaceCover(brep_, FaceId(f), options_, borders, out.balls).run(context);
    }

  private:
    const Brep& brep_;
    const SizingOptions& options_;
};

}  // namespace

std::unique_ptr<SizeProvider> narrow_face_provider(const Brep& brep, const SizingOptions& options) {
    return std::make_unique<NarrowFaceProvider>(brep, options);
}

}  // namespace featuremesh

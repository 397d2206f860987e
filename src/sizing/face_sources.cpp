// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/face_sources.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <cmath>
#include <optional>

#include "brep/occt_geometry.h"

namespace featuremesh {
namespace {

/// A surface with its first and second derivatives at one point.
struct SurfacePoint {
    Vec3 point, du, dv, normal;
    double curvature = 0;  ///< largest absolute principal curvature, 1/mm; 0 at a pole
};

SurfacePoint surface_point(const BRepAdaptor_Surface& surface, double u, double v) {
    gp_Pnt p;
    gp_Vec du, dv, duu, dvv, duv;
    surface.D2(u, v, p, du, dv, duu, dvv, duv);
    SurfacePoint at{to_vec3(p), to_vec3(du), to_vec3(dv), {}, 0};
    const Vec3 n = cross(at.du, at.dv);
    const double area = length(n), e = dot(at.du, at.du), f = dot(at.du, at.dv), g = dot(at.dv, at.dv);
    if (!(area > 1e-10 * std::sqrt(e * g)) || area == 0) return at;
    at.normal = n / area;
    // first form e f g, second form l m k; mean and Gauss curvature
    const double l = dot(to_vec3(duu), at.normal), m = dot(to_vec3(duv), at.normal), k = dot(to_vec3(dvv), at.normal),
                 det = e * g - f * f;
    const double mean = (e * k - 2 * f * m + g * l) / (2 * det), gauss = (l * k - m * m) / det;
    at.curvature = std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss));
    return at;
}

class FaceCover {
  public:
    FaceCover(const Brep& brep, FaceId face, const FaceWish& wish, const SizingOptions& options,
              std::vector<SourceBall>& out)
        : id_(face),
          face_(brep.face(face)),
          surface_(face_, false),
          wish_(wish),
          options_(options),
          sides_(brep.sides_of(face)),
          out_(out) {}

    void run() {
        if (wish_.local >= options_.size && !curves_too_much() && !wish_.walls) return;
        BRepTools::UVBounds(face_, u_[0], u_[1], v_[0], v_[1]);
        trim_.emplace(face_, 1e-9);
        floor_ = curvature_floor(options_, surface_.GetType() >= GeomAbs_BezierSurface);
        if (surface_.GetType() == GeomAbs_Cone) floor_ = std::max(floor_, cone_floor());
        const int pieces_u = pieces(surface_.GetType(), surface_.IsUPeriodic() ? 8 : 2, true),
                  pieces_v = pieces(surface_.GetType(), surface_.IsVPeriodic() ? 8 : 2, false);
        for (int i = 0; i < pieces_u; ++i)
            for (int j = 0; j < pieces_v; ++j)
                cover({at(u_, i, pieces_u), at(u_, i + 1, pieces_u)}, {at(v_, j, pieces_v), at(v_, j + 1, pieces_v)},
                      0);
    }

  private:
    using Range = std::array<double, 2>;
    static double at(const Range& r, int i, int n) { return r[0] + (r[1] - r[0]) * i / n; }

    /// False where the kind of surface tells that the curvature asks for nothing below the size.
    bool curves_too_much() const {
        if (wish_.per_circle <= 0) return false;
        const auto asks = [&](double radius) { return circle_size(1 / radius, wish_.per_circle) < options_.size; };
        switch (surface_.GetType()) {
            case GeomAbs_Plane:
                return false;
            case GeomAbs_Cylinder:
                return asks(surface_.Cylinder().Radius());
            case GeomAbs_Sphere:
                return asks(surface_.Sphere().Radius());
            case GeomAbs_Torus: {
                const double big = surface_.Torus().MajorRadius(), small = surface_.Torus().MinorRadius();
                return asks(small) || asks(std::max(1e-9, std::abs(big - small)));
            }
            default:
                return true;
        }
    }
    /// A cone asks for a quarter of what its widest circle asks for at least: its apex would ask for nothing at all.
    double cone_floor() const {
        double curvature = std::numeric_limits<double>::infinity();
        for (double v : v_)
            if (const double c = surface_point(surface_, u_[0], v).curvature; c > 0) curvature = std::min(curvature, c);
        return std::isfinite(curvature) && wish_.per_circle > 0 ? 0.25 * circle_size(curvature, wish_.per_circle) : 0;
    }
    int pieces(GeomAbs_SurfaceType type, int otherwise, bool along_u) const {
        if (type != GeomAbs_BSplineSurface) return otherwise;
        return std::clamp((along_u ? surface_.NbUKnots() : surface_.NbVKnots()) - 1, 2, 48);
    }

    double wanted(const SurfacePoint& p) const {
        double size = std::min(wish_.local, options_.size);
        if (wish_.per_circle > 0 && p.curvature > 0)
            size = std::min(size, std::max(floor_, circle_size(p.curvature, wish_.per_circle)));
        if (wish_.walls) size = std::min(size, std::max(floor_, wall_size(p)));
        return size;
    }
    double wall_size(const SurfacePoint& p) const {
        const double limit = wish_.across_gap * options_.size;
        const Vec3 outward = face_.Orientation() == TopAbs_REVERSED ? -p.normal : p.normal;
        double thickness = limit;
        if (squared_length(p.normal) == 0) return options_.size;
        if (sides_[0].is_valid())
            thickness = std::min(thickness, wish_.walls->thickness(id_, p.point, -outward, limit));
        if (sides_[1].is_valid()) thickness = std::min(thickness, wish_.walls->thickness(id_, p.point, outward, limit));
        return thickness / wish_.across_gap;
    }

    void cover(const Range& u, const Range& v, int depth) {
        // slightly within the piece, so that the poles on its border are not asked
        constexpr double inset = 0.02;
        const double mu = 0.5 * (u[0] + u[1]), mv = 0.5 * (v[0] + v[1]);
        const auto near = [&](double a, double b) { return a + inset * (b - a); };
        const std::array<std::array<double, 2>, 5> uv{{{mu, mv},
                                                       {near(u[0], u[1]), near(v[0], v[1])},
                                                       {near(u[1], u[0]), near(v[0], v[1])},
                                                       {near(u[0], u[1]), near(v[1], v[0])},
                                                       {near(u[1], u[0]), near(v[1], v[0])}}};
        std::array<SurfacePoint, 5> p;
        for (int i = 0; i < 5; ++i) p[i] = surface_point(surface_, uv[i][0], uv[i][1]);
        double size = options_.size;
        for (const SurfacePoint& q : p) size = std::min(size, wanted(q));
        const double along_u = std::max(
            {distance(p[1].point, p[2].point), distance(p[3].point, p[4].point), length(p[0].du) * (u[1] - u[0])});
        const double along_v = std::max(
            {distance(p[1].point, p[3].point), distance(p[2].point, p[4].point), length(p[0].dv) * (v[1] - v[0])});
        // walls may be thin anywhere, so that pieces are looked at down to the global size
        const bool is_too_long = std::max(along_u, along_v) > 2 * size;
        if (size >= options_.size && (!wish_.walls || !is_too_long || depth >= 12)) return;
        if (is_too_long && depth < 24) {
            const bool split_u = along_u >= along_v;
            cover(split_u ? Range{u[0], mu} : u, split_u ? v : Range{v[0], mv}, depth + 1);
            cover(split_u ? Range{mu, u[1]} : u, split_u ? v : Range{mv, v[1]}, depth + 1);
            return;
        }
        if (std::none_of(uv.begin(), uv.end(),
                         [&](const auto& w) { return trim_->Perform(gp_Pnt2d(w[0], w[1])) != TopAbs_OUT; }))
            return;
        double radius = 0;
        for (int i = 1; i < 5; ++i) radius = std::max(radius, distance(p[0].point, p[i].point));
        out_.push_back({p[0].point, radius / (1 - 2 * inset), size});
    }

    const FaceId id_;
    const TopoDS_Face& face_;
    const BRepAdaptor_Surface surface_;
    const FaceWish& wish_;
    const SizingOptions& options_;
    const std::array<SolidId, 2> sides_;
    std::vector<SourceBall>& out_;
    Range u_{}, v_{};
    double floor_ = 0;
    std::optional<BRepTopAdaptor_FClass2d> trim_;
};

}  // namespace

void cover_face(const Brep& brep, FaceId face, const FaceWish& wish, const SizingOptions& options,
                std::vector<SourceBall>& out) {
    FaceCover(brep, face, wish, options, out).run();
}

}  // namespace featuremesh

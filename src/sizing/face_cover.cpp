// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/face_cover.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include "brep/face_trim.h"
#include "brep/occt_geometry.h"
#include "core/geometry.h"

namespace featuremesh {

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

namespace {

class FaceCover {
  public:
    FaceCover(const Brep& brep, FaceId face, std::span<const FaceWish> wishes, double limit,
              std::vector<SourceBall>& out)
        : face_(brep.face(face)),
          surface_(face_, false),
          trim_(face_),
          wishes_(wishes),
          limit_(limit),
          may_be_anywhere_(
              std::any_of(wishes.begin(), wishes.end(), [](const FaceWish& w) { return w.may_be_anywhere; })),
          out_(out) {}

    void run() {
        BRepTools::UVBounds(face_, u_[0], u_[1], v_[0], v_[1]);
        const int pieces_u = pieces(surface_.GetType(), surface_.IsUPeriodic() ? 8 : 2, true),
                  pieces_v = pieces(surface_.GetType(), surface_.IsVPeriodic() ? 8 : 2, false);
        for (int i = 0; i < pieces_u; ++i)
            for (int j = 0; j < pieces_v; ++j)
                cover({at(u_, i, pieces_u), at(u_, i + 1, pieces_u)}, {at(v_, j, pieces_v), at(v_, j + 1, pieces_v)},
                      0);
    }

  private:
    using Range = std::array<double, 2>;
    static constexpr int most_halvings = 1 << 20;  // so many pieces have ten million triangles
    static double at(const Range& r, int i, int n) { return r[0] + (r[1] - r[0]) * i / n; }

    int pieces(GeomAbs_SurfaceType type, int otherwise, bool along_u) const {
        if (type != GeomAbs_BSplineSurface) return otherwise;
        return std::clamp((along_u ? surface_.NbUKnots() : surface_.NbVKnots()) - 1, 2, 48);
    }

    double wanted(const SurfacePoint& p) const {
        double size = limit_;
        for (const FaceWish& wish : wishes_) size = std::min(size, wish.size(p));
        return size;
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
        double size = limit_;
        for (const SurfacePoint& q : p) size = std::min(size, wanted(q));
        const double along_u = std::max(
            {distance(p[1].point, p[2].point), distance(p[3].point, p[4].point), length(p[0].du) * (u[1] - u[0])});
        const double along_v = std::max(
            {distance(p[1].point, p[3].point), distance(p[2].point, p[4].point), length(p[0].dv) * (v[1] - v[0])});
        const bool is_too_long = std::max(along_u, along_v) > 2 * size;
        if (size >= limit_ && (!may_be_anywhere_ || !is_too_long || depth >= 12)) return;
        if (is_too_long && depth < 24 && ++halvings_ < most_halvings) {
            const bool split_u = along_u >= along_v;
            cover(split_u ? Range{u[0], mu} : u, split_u ? v : Range{v[0], mv}, depth + 1);
            cover(split_u ? Range{mu, u[1]} : u, split_u ? v : Range{mv, v[1]}, depth + 1);
            return;
        }
        if (std::none_of(uv.begin(), uv.end(), [&](const auto& w) { return trim_.has(w[0], w[1]); })) return;
        double radius = 0;
        for (int i = 1; i < 5; ++i) radius = std::max(radius, distance(p[0].point, p[i].point));
        out_.push_back({p[0].point, radius / (1 - 2 * inset), size});
    }

    const TopoDS_Face& face_;
    const BRepAdaptor_Surface surface_;
    const FaceTrim trim_;
    const std::span<const FaceWish> wishes_;
    const double limit_;
    const bool may_be_anywhere_;
    std::vector<SourceBall>& out_;
    int halvings_ = 0;
    Range u_{}, v_{};
};

}  // namespace

void cover_face(const Brep& brep, FaceId face, std::span<const FaceWish> wishes, double limit,
                std::vector<SourceBall>& out) {
    if (!wishes.empty()) FaceCover(brep, face, wishes, limit, out).run();
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Curve2d.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "features/flux.h"
#include "features/occt_geometry.h"

namespace featuremesh {

namespace {

using Integrand = std::function<double(double)>;

constexpr double relative_error = 1e-10;
constexpr int deepest = 14;

struct Estimate {
    double value = 0, error = 0;
};

/// Gauss 7 and Kronrod 15 points on [a, b].
Estimate kronrod(const Integrand& f, double a, double b) {
    static constexpr std::array<double, 8> x{
        0.991455371120812639, 0.949107912342758525, 0.864864423359769073, 0.741531185599394440,
        0.586087235467691130, 0.405845151377397167, 0.207784955007898468, 0.0};
    static constexpr std::array<double, 8> k{0.022935322010529225, 0.063092092629978553, 0.104790010322250184,
                                             0.140653259715525919, 0.169004726639267903, 0.190350578064785410,
                                             0.204432940075298892, 0.209482141084727828};
    static constexpr std::array<double, 4> g{0.129484966168869693, 0.279705391489276668, 0.381830050505118945,
                                             0.417959183673469388};
    const double middle = (a + b) / 2, half = (b - a) / 2;
    double fine = k[7] * f(middle), coarse = g[3] * f(middle);
    for (int i = 0; i < 7; ++i) {
        const double pair = f(middle - half * x[i]) + f(middle + half * x[i]);
        fine += k[i] * pair;
        if (i % 2 == 1) coarse += g[i / 2] * pair;
    }
    return {fine * half, std::abs(fine - coarse) * half};
}

double integrate(const Integrand& f, double a, double b, double error, int depth = 0) {
    const Estimate whole = kronrod(f, a, b);
    if (whole.error <= error || depth == deepest) return whole.value;
    const double middle = (a + b) / 2;
    return integrate(f, a, middle, error / 2, depth + 1) + integrate(f, middle, b, error / 2, depth + 1);
}

/// Integral over [a, b] with n Gauss points, n = 1, 3 or 8.
template <class F>
double gauss(const F& f, double a, double b, int n) {
    static constexpr std::array<double, 2> x3{0.774596669241483377, 0.0}, w3{5.0 / 9, 8.0 / 9};
    static constexpr std::array<double, 4> x8{0.960289856497536232, 0.796666477413626740, 0.525532409916328986,
                                              0.183434642495649805};
    static constexpr std::array<double, 4> w8{0.101228536290376259, 0.222381034453374471, 0.313706645877887287,
                                              0.362683783378361983};
    const double middle = (a + b) / 2, half = (b - a) / 2;
    if (n == 1) return 2 * half * f(middle);
    if (n == 3) return half * (w3[0] * (f(middle - half * x3[0]) + f(middle + half * x3[0])) + w3[1] * f(middle));
    double sum = 0;
    for (int i = 0; i < 4; ++i) sum += w8[i] * (f(middle - half * x8[i]) + f(middle + half * x8[i]));
    return half * sum;
}

template <class Curve>
std::vector<double> smooth_stretches(const Curve& curve) {
    TColStd_Array1OfReal bounds(1, curve.NbIntervals(GeomAbs_CN) + 1);
    curve.Intervals(bounds, GeomAbs_CN);
    return {bounds.begin(), bounds.end()};
}

double along(const Integrand& f, const std::vector<double>& stretches, double scale) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < stretches.size(); ++i)
        sum += integrate(f, stretches[i], stretches[i + 1], relative_error * scale);
    return sum;
}

template <class Visit>
double sum_over_edges(const TopoDS_Face& face, const Visit& visit) {
    double sum = 0;
    for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next()) {
        const TopAbs_Orientation orientation = it.Current().Orientation();
        if (orientation == TopAbs_FORWARD) sum += visit(TopoDS::Edge(it.Current()));
        if (orientation == TopAbs_REVERSED) sum -= visit(TopoDS::Edge(it.Current()));
    }
    return sum;
}

// In space, not in the parameter plane: the faces on both sides of an edge then see the same curve.
double flux_of_plane(const TopoDS_Face& face, const BRepAdaptor_Surface& surface, const Vec3& apex, double size) {
    gp_Pnt origin;
    gp_Vec du, dv;
    surface.D1(0, 0, origin, du, dv);
    const Vec3 o = box_of(face).center(), normal = normalized(to_vec3(du.Crossed(dv)));
    const double height = dot(to_vec3(origin) - apex, normal);
    const double twice_area = sum_over_edges(face, [&](const TopoDS_Edge& edge) {
        const BRepAdaptor_Curve curve(edge);
        const Integrand swept = [&](double t) {
            gp_Pnt p;
            gp_Vec d;
            curve.D1(t, p, d);
            return dot(cross(to_vec3(p) - o, to_vec3(d)), normal);
        };
        return along(swept, smooth_stretches(curve), size * size);
    });
    return height * twice_area / 6;
}

/// The flux through a curved face by Green's theorem: minus the integral over its border of H du, H the flux up to v.
class CurvedFace {
  public:
    CurvedFace(const TopoDS_Face& face, const BRepAdaptor_Surface& surface, const Vec3& apex, double size)
        // Forward, for of a seam's two curves the kernel gives that which goes with the orientations of edge and face.
        : face_(TopoDS::Face(face.Oriented(TopAbs_FORWARD))), surface_(surface), apex_(apex), size_(size) {
        TColStd_Array1OfReal bounds(1, surface.NbVIntervals(GeomAbs_CN) + 1);
        surface.VIntervals(bounds, GeomAbs_CN);
        const GeomAbs_SurfaceType type = surface.GetType();
        points_ = type == GeomAbs_Cylinder || type == GeomAbs_SurfaceOfExtrusion ? 1 : type == GeomAbs_Cone ? 3 : 8;
        // A turn of a torus or a sphere needs more than one stretch for full accuracy.
        const bool periodic = type == GeomAbs_Torus || type == GeomAbs_Sphere || surface.IsVPeriodic();
        for (int i = bounds.Lower(); i < bounds.Upper(); ++i) {
            const int parts = periodic ? 1 + static_cast<int>((bounds(i + 1) - bounds(i)) / (std::numbers::pi / 2)) : 1;
            for (int k = 0; k < parts; ++k) stretches_.push_back(bounds(i) + (bounds(i + 1) - bounds(i)) * k / parts);
        }
        stretches_.push_back(bounds(bounds.Upper()));
    }

    double value() const {
        if (face_.NbChildren() == 0) return over_natural_bounds();
        return -sum_over_edges(face_, [&](const TopoDS_Edge& edge) {
            const BRepAdaptor_Curve2d curve(edge, face_);
            const Integrand share = [&](double t) {
                gp_Pnt2d uv;
                gp_Vec2d d;
                curve.D1(t, uv, d);
                return d.X() == 0 ? 0.0 : up_to(uv.X(), uv.Y()) * d.X();
            };
            return along(share, smooth_stretches(curve), size_ * size_ * size_);
        });
    }

  private:
    double density(double u, double v) const {
        gp_Pnt p;
        gp_Vec du, dv;
        surface_.D1(u, v, p, du, dv);
        return dot(to_vec3(p) - apex_, cross(to_vec3(du), to_vec3(dv))) / 3;
    }

    double up_to(double u, double v) const {
        const auto along_v = [&](double s) { return density(u, s); };
        if (stretches_.size() == 2) return gauss(along_v, stretches_[0], v, points_);
        double sum = 0, from = stretches_[0];
        for (std::size_t i = 1; i < stretches_.size() && from != v; ++i) {
            const bool last = i + 1 == stretches_.size() || v < stretches_[i];
            const double to = last ? v : stretches_[i];
            sum += gauss(along_v, from, to, points_);
            from = to;
        }
        return sum;
    }

    double over_natural_bounds() const {
        TColStd_Array1OfReal bounds(1, surface_.NbUIntervals(GeomAbs_CN) + 1);
        surface_.UIntervals(bounds, GeomAbs_CN);
        const double top = surface_.LastVParameter();
        return along([&](double u) { return up_to(u, top); }, {bounds.begin(), bounds.end()}, size_ * size_ * size_);
    }

    TopoDS_Face face_;
    const BRepAdaptor_Surface& surface_;
    Vec3 apex_;
    double size_;
    int points_ = 8;
    std::vector<double> stretches_;
};

}  // namespace

double flux(const TopoDS_Shape& faces, const Vec3& apex) {
    double sum = 0;
    for (TopExp_Explorer it(faces, TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face& face = TopoDS::Face(it.Current());
        if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED) continue;
        const BRepAdaptor_Surface surface(face, false);
        const double size = box_of(face).diagonal();
        const double share = surface.GetType() == GeomAbs_Plane
                                 ? flux_of_plane(face, surface, apex, size)
                                 : CurvedFace(face, BRepAdaptor_Surface(face, true), apex, size).value();
        sum += face.Orientation() == TopAbs_REVERSED ? -share : share;
    }
    return sum;
}

}  // namespace featuremesh

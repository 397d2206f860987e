// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Curve2d.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
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
constexpr double loose = 1e-8;         // tolerance of an edge over the size of its face from which its ribbon counts
constexpr double ribbon_error = 1e-9;  // of the size's cube; two curves that were fitted to one another are rough

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

double along(const Integrand& f, const std::vector<double>& stretches, double error) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < stretches.size(); ++i) sum += integrate(f, stretches[i], stretches[i + 1], error);
    return sum;
}

struct CurvePoint {
    Vec3 point, derivative;
};

CurvePoint point_on(const BRepAdaptor_Curve& curve, double t) {
    gp_Pnt p;
    gp_Vec d;
    curve.D1(t, p, d);
    return {to_vec3(p), to_vec3(d)};
}

/// Flux through the ribbon between a face's border, as its surface has it, and the edge's own curve in space, per unit
/// of their parameter. The face on the other side ends at the same curve: with the ribbons the faces of a shape close,
/// however loose its edges are; without them its volume depends on the apex and on how its faces were split.
double ribbon(const CurvePoint& border, const CurvePoint& edge, const Vec3& apex) {
    return dot(border.point - apex, cross(edge.point - border.point, (border.derivative + edge.derivative) / 2)) / 3;
}

bool has_ribbon(const TopoDS_Edge& edge, double size) {
    return BRep_Tool::Tolerance(edge) > loose * size && !BRep_Tool::Degenerated(edge);
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

/// From where one edge of a border ends to where the next begins; a vertex is as wide as its tolerance.
struct Gap {
    Vec3 from, to;
};

/// At each vertex what ends there goes on with what begins nearest to it. `end_of(edge, first)` is the edge's end at
/// the first or the last parameter: a point in space or in the parameter plane.
template <class EndOf>
std::vector<Gap> gaps_of_border(const TopoDS_Face& face, const EndOf& end_of) {
    TopTools_IndexedMapOfShape vertices;
    std::vector<std::vector<Vec3>> ends, starts;
    const auto add = [&](std::vector<std::vector<Vec3>>& lists, const TopoDS_Vertex& vertex, const Vec3& end) {
        if (vertex.IsNull()) return;
        const int index = vertices.Add(vertex);
        ends.resize(vertices.Extent());
        starts.resize(vertices.Extent());
        lists[index - 1].push_back(end);
    };
    for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
        if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) continue;
        const bool forward = edge.Orientation() == TopAbs_FORWARD;
        add(forward ? starts : ends, TopExp::FirstVertex(edge), end_of(edge, true));
        add(forward ? ends : starts, TopExp::LastVertex(edge), end_of(edge, false));
    }
    std::vector<Gap> gaps;
    for (std::size_t v = 0; v < ends.size(); ++v)
        for (const Vec3& end : ends[v]) {
            const auto next = std::min_element(starts[v].begin(), starts[v].end(), [&](const Vec3& a, const Vec3& b) {
                return squared_length(a - end) < squared_length(b - end);
            });
            if (next == starts[v].end()) break;
            if (!(*next == end)) gaps.push_back({end, *next});
            starts[v].erase(next);
        }
    return gaps;
}

Vec3 end_in_space(const TopoDS_Edge& edge, bool first) {
    const BRepAdaptor_Curve curve(edge);
    return to_vec3(curve.Value(first ? curve.FirstParameter() : curve.LastParameter()));
}

// In space, not in the parameter plane: the faces on both sides of an edge then see the same curve.
double flux_of_plane(const TopoDS_Face& face, const BRepAdaptor_Surface& surface, const Vec3& apex, double size) {
    gp_Pnt origin;
    gp_Vec du, dv;
    surface.D1(0, 0, origin, du, dv);
    const Vec3 o = box_of(face).center(), normal = normalized(to_vec3(du.Crossed(dv)));
    const double height = dot(to_vec3(origin) - apex, normal);
    double across_gaps = 0;
    for (const Gap& gap : gaps_of_border(face, end_in_space))
        across_gaps += dot(cross(gap.from - o, gap.to - gap.from), normal) * height / 6;
    return across_gaps + sum_over_edges(face, [&](const TopoDS_Edge& edge) {
               const BRepAdaptor_Curve curve(edge);
               const std::vector<double> stretches = smooth_stretches(curve);
               const Integrand swept = [&](double t) {
                   const CurvePoint c = point_on(curve, t);
                   return dot(cross(c.point - o, c.derivative), normal);
               };
               const double share = along(swept, stretches, relative_error * size * size) * height / 6;
               if (!has_ribbon(edge, size)) return share;
               const Integrand off_plane = [&](double t) {
                   const CurvePoint c = point_on(curve, t);
                   const Vec3 foot = c.point - normal * dot(c.point - to_vec3(origin), normal);
                   return ribbon({foot, c.derivative - normal * dot(c.derivative, normal)}, c, apex);
               };
               return share + along(off_plane, stretches, ribbon_error * size * size * size);
           });
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
        double across_gaps = 0;
        for (const Gap& gap : gaps_of_border(face_, [&](const TopoDS_Edge&edge, bool first) {
                 const BRepAdaptor_Curve2d curve(edge, face_);
                 const gp_Pnt2d uv = curve.Value(first ? curve.FirstParameter() : curve.LastParameter());
                 return Vec3{uv.X(), uv.Y(), 0};
             }))
            across_gaps -= up_to((gap.from.x + gap.to.x) / 2, (gap.from.y + gap.to.y) / 2) * (gap.to.x - gap.from.x);
        return across_gaps + sum_over_edges(face_, [&](const TopoDS_Edge& edge) {
                   const BRepAdaptor_Curve2d curve(edge, face_);
                   const Integrand share = [&](double t) {
                       gp_Pnt2d uv;
                       gp_Vec2d d;
                       curve.D1(t, uv, d);
                       return d.X() == 0 ? 0.0 : up_to(uv.X(), uv.Y()) * d.X();
                   };
                   const double up_to_border = -along(share, smooth_stretches(curve), relative_error * cube());
                   return has_ribbon(edge, size_) ? up_to_border + beyond_border(edge, curve) : up_to_border;
               });
    }

  private:
    double density(double u, double v) const {
        gp_Pnt p;
        gp_Vec du, dv;
        surface_.D1(u, v, p, du, dv);
        return dot(to_vec3(p) - apex_, cross(to_vec3(du), to_vec3(dv))) / 3;
    }

    double cube() const { return size_ * size_ * size_; }

    double beyond_border(const TopoDS_Edge& edge, const BRepAdaptor_Curve2d& curve) const {
        const BRepAdaptor_Curve in_space(edge);
        const Integrand share = [&](double t) {
            gp_Pnt2d uv;
            gp_Vec2d d;
            curve.D1(t, uv, d);
            gp_Pnt p;
            gp_Vec du, dv;
            surface_.D1(uv.X(), uv.Y(), p, du, dv);
            return ribbon({to_vec3(p), to_vec3(du) * d.X() + to_vec3(dv) * d.Y()}, point_on(in_space, t), apex_);
        };
        return along(share, smooth_stretches(in_space), ribbon_error * cube());
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
        return along([&](double u) { return up_to(u, top); }, {bounds.begin(), bounds.end()}, relative_error * cube());
    }

    TopoDS_Face face_;
    const BRepAdaptor_Surface& surface_;
    Vec3 apex_;
    double size_;
    int points_ = 8;
    std::vector<double> stretches_;
};

}  // namespace

double flux(const TopoDS_Face& face, const Vec3& apex, double size) {
    const BRepAdaptor_Surface surface(face, false);
    const double share = surface.GetType() == GeomAbs_Plane
                             ? flux_of_plane(face, surface, apex, size)
                             : CurvedFace(face, BRepAdaptor_Surface(face, true), apex, size).value();
    return face.Orientation() == TopAbs_REVERSED ? -share : share;
}

double flux(const TopoDS_Shape& faces, const Vec3& apex) {
    double sum = 0;
    for (TopExp_Explorer it(faces, TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face& face = TopoDS::Face(it.Current());
        if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED) continue;
        sum += flux(face, apex, box_of(face).diagonal());
    }
    return sum;
}

}  // namespace featuremesh

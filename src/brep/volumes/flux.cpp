// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Curve2d.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "brep/occt_geometry.h"
#include "brep/volumes/flux.h"
#include "brep/volumes/period_shifts.h"

namespace featuremesh {

namespace {

using Integrand = std::function<double(double)>;

constexpr double relative_error = 1e-10;
constexpr int deepest = 14;
constexpr double no_stretch = 1e-12;   // of the range of a parameter
constexpr double loose = 1e-8;         // tolerance of an edge over the size of its face from which its ribbon counts
constexpr double ribbon_error = 1e-9;  // of the size's cube; two curves that were fitted to one another are rough

struct Estimate {
    double value = 0, error = 0;
};

/// Patterson's rules on [a, b], each with the points of the one before: Gauss's 3, 7, and 15 where those two differ.
Estimate patterson(const Integrand& f, double a, double b, double error) {
    static constexpr std::array<double, 4> x7{0.0, 0.774596669241483377, 0.434243749346802558, 0.960491268708020283};
    static constexpr std::array<double, 2> w3{8.0 / 9, 5.0 / 9};
    static constexpr std::array<double, 4> w7{0.450916538658474142, 0.268488089868333440, 0.401397414775962222,
                                              0.104656226026467265};
    static constexpr std::array<double, 4> x15{0.223386686428966881, 0.621102946737226402, 0.888459232872256998,
                                               0.993831963212755022};
    static constexpr std::array<double, 8> w15{0.225510499798206687,  0.134415255243784220, 0.200628529376989021,
                                               0.0516032829970797396, 0.219156858401587496, 0.171511909136391380,
                                               0.0929271953151245376, 0.0170017196299402603};
    const double middle = (a + b) / 2, half = (b - a) / 2;
    const auto pair = [&](double x) { return f(middle - half * x) + f(middle + half * x); };
    std::array<double, 4> at{f(middle)};
    for (std::size_t i = 1; i < 4; ++i) at[i] = pair(x7[i]);
    double fine = 0;
    for (std::size_t i = 0; i < 4; ++i) fine += w7[i] * at[i];
    const double coarse = w3[0] * at[0] + w3[1] * at[1];
    if (std::abs(fine - coarse) * half <= error) return {fine * half, std::abs(fine - coarse) * half};
    double finest = 0;
    for (std::size_t i = 0; i < 4; ++i) finest += w15[i] * at[i] + w15[i + 4] * pair(x15[i]);
    return {finest * half, std::abs(finest - fine) * half};
}

double integrate(const Integrand& f, double a, double b, double error, int depth = 0) {
    const Estimate whole = patterson(f, a, b, error);
    if (whole.error <= error || depth == deepest) return whole.value;
    const double middle = (a + b) / 2;
    return integrate(f, a, middle, error / 2, depth + 1) + integrate(f, middle, b, error / 2, depth + 1);
}

/// Integral over [a, b] with n Gauss points, n = 1, 3, 5 or 8.
template <class F>
double gauss(const F& f, double a, double b, int n) {
    static constexpr std::array<double, 2> x3{0.774596669241483377, 0.0}, w3{5.0 / 9, 8.0 / 9};
    static constexpr std::array<double, 2> x5{0.906179845938663993, 0.538469310105683091};
    static constexpr std::array<double, 3> w5{0.236926885056189088, 0.478628670499366468, 0.568888888888888889};
    static constexpr std::array<double, 4> x8{0.960289856497536232, 0.796666477413626740, 0.525532409916328986,
                                              0.183434642495649805};
    static constexpr std::array<double, 4> w8{0.101228536290376259, 0.222381034453374471, 0.313706645877887287,
                                              0.362683783378361983};
    const double middle = (a + b) / 2, half = (b - a) / 2;
    if (n == 1) return 2 * half * f(middle);
    if (n == 3) return half * (w3[0] * (f(middle - half * x3[0]) + f(middle + half * x3[0])) + w3[1] * f(middle));
    double sum = 0;
    if (n == 5) {
        for (int i = 0; i < 2; ++i) sum += w5[i] * (f(middle - half * x5[i]) + f(middle + half * x5[i]));
        return half * (sum + w5[2] * f(middle));
    }
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

/// A face's border, computed from its surface, may lie beside the edge's own curve in space. This is the flux through
/// the ribbon between the two, per unit of their parameter. Both faces at an edge get their ribbon to the same curve,
/// so together they close, however loose the edge is. Without ribbons the volume would depend on the apex and on how
/// the faces were split.
double ribbon(const CurvePoint& border, const CurvePoint& edge, const Vec3& apex) {
    return dot(border.point - apex, cross(edge.point - border.point, (border.derivative + edge.derivative) / 2)) / 3;
}

bool has_ribbon(const TopoDS_Edge& edge, double size) {
    return BRep_Tool::Tolerance(edge) > loose * size && !BRep_Tool::Degenerated(edge);
}

/// `of(number)` by edge.
template <class Of>
double sum_along(const std::vector<TopoDS_Edge>& border, const Of& of) {
    double sum = 0;
    for (std::size_t i = 0; i < border.size(); ++i) sum += border[i].Orientation() == TopAbs_FORWARD ? of(i) : -of(i);
    return sum;
}

/// From where one edge of a border ends to where the next begins; a vertex is as wide as its tolerance.
struct Gap {
    Vec3 from, to;
};

/// At each vertex what ends there goes on with what begins nearest to it. `end_of(number, first)` is an edge's end at
/// the first or the last parameter: a point in space or in the parameter plane.
template <class EndOf>
std::vector<Gap> gaps_of_border(const std::vector<TopoDS_Edge>& border, const EndOf& end_of) {
    TopTools_IndexedMapOfShape vertices;
    std::vector<std::vector<Vec3>> ends, starts;
    const auto add = [&](std::vector<std::vector<Vec3>>& lists, const TopoDS_Vertex& vertex, const Vec3& end) {
        if (vertex.IsNull()) return;
        const int index = vertices.Add(vertex);
        ends.resize(vertices.Extent());
        starts.resize(vertices.Extent());
        lists[index - 1].push_back(end);
    };
    for (std::size_t i = 0; i < border.size(); ++i) {
        const bool forward = border[i].Orientation() == TopAbs_FORWARD;
        add(forward ? starts : ends, TopExp::FirstVertex(border[i]), end_of(i, true));
        add(forward ? ends : starts, TopExp::LastVertex(border[i]), end_of(i, false));
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

/// Of a curve in space or in the parameter plane.
template <class Curve>
auto end_of(const Curve& curve, bool first) {
    return curve.Value(first ? curve.FirstParameter() : curve.LastParameter());
}

// In space, not in the parameter plane: both faces at an edge then see the same curve.
double flux_of_plane(const TopoDS_Face& face, const BRepAdaptor_Surface& surface, const Vec3& apex, double size) {
    gp_Pnt origin;
    gp_Vec du, dv;
    surface.D1(0, 0, origin, du, dv);
    const std::vector<TopoDS_Edge> border = border_of(face);
    if (border.empty()) return 0;
    const std::vector<BRepAdaptor_Curve> curves(border.begin(), border.end());
    const Vec3 o = to_vec3(end_of(curves.front(), true)), normal = normalized(to_vec3(du.Crossed(dv)));
    const double height = dot(to_vec3(origin) - apex, normal);
    double across_gaps = 0;
    for (const Gap& gap :
         gaps_of_border(border, [&](std::size_t i, bool first) { return to_vec3(end_of(curves[i], first)); }))
        across_gaps += dot(cross(gap.from - o, gap.to - gap.from), normal) * height / 6;
    return across_gaps + sum_along(border, [&](std::size_t i) {
               const BRepAdaptor_Curve& curve = curves[i];
               const std::vector<double> stretches = smooth_stretches(curve);
               const Integrand swept = [&](double t) {
                   const CurvePoint c = point_on(curve, t);
                   return dot(cross(c.point - o, c.derivative), normal);
               };
               const double area =
                   curve.GetType() == GeomAbs_Line
                       ? swept(curve.FirstParameter()) * (curve.LastParameter() - curve.FirstParameter())
                       : along(swept, stretches, relative_error * size * size);
               const double share = area * height / 6;
               if (!has_ribbon(border[i], size)) return share;
               const Integrand off_plane = [&](double t) {
                   const CurvePoint c = point_on(curve, t);
                   const Vec3 foot = c.point - normal * dot(c.point - to_vec3(origin), normal);
                   return ribbon({foot, c.derivative - normal * dot(c.derivative, normal)}, c, apex);
               };
               return share + along(off_plane, stretches, ribbon_error * size * size * size);
           });
}

/// One of a surface's parameters: the stretches on which the surface is smooth, and how many Gauss points each needs.
struct Direction {
    std::vector<double> stretches;
    int points = 8;
};

bool is_spline(const BRepAdaptor_Surface& surface) {
    return surface.GetType() == GeomAbs_BSplineSurface || surface.GetType() == GeomAbs_BezierSurface;
}

/// Do weights change along v by more than they were rounded? The kernel's IsURational and IsVRational each speak of the
/// other direction, and lofts have weights that differ from one in the last digit.
bool has_weights_along_v(const BRepAdaptor_Surface& surface) {
    if (!surface.IsURational() && !surface.IsVRational()) return false;
    if (surface.GetType() != GeomAbs_BSplineSurface) return true;
    constexpr double rounding = 1e-14;
    const TColStd_Array2OfReal* weights = surface.Surface().BSpline()->Weights();
    if (weights == nullptr) return false;
    for (int i = weights->LowerRow(); i <= weights->UpperRow(); ++i)
        for (int k = weights->LowerCol(); k <= weights->UpperCol(); ++k)
            if (std::abs((*weights)(i, k) / (*weights)(i, weights->LowerCol()) - 1) > rounding) return true;
    return false;
}

/// For a spline of degree n whose weights do not change along v the density is a polynomial of degree 3 n - 1 there.
int points_along_v(const BRepAdaptor_Surface& surface) {
    const GeomAbs_SurfaceType type = surface.GetType();
    if (type == GeomAbs_Cylinder || type == GeomAbs_SurfaceOfExtrusion) return 1;
    if (type == GeomAbs_Cone) return 3;
    if (!is_spline(surface) || surface.VDegree() > 3 || has_weights_along_v(surface)) return 8;
    return surface.VDegree() == 3 ? 5 : 3;
}

/// Of these, as many as do over `share` of a stretch: fewer reach the same accuracy over less.
int points_over(double share, int points) {
    constexpr double few = 1.0 / 64, some = 1.0 / 8;
    return std::min(points, share <= few ? 3 : share <= some ? 5 : 8);
}

Direction along_v(const BRepAdaptor_Surface& surface) {
    TColStd_Array1OfReal bounds(1, surface.NbVIntervals(GeomAbs_CN) + 1);
    surface.VIntervals(bounds, GeomAbs_CN);
    Direction v;
    v.points = points_along_v(surface);
    // A turn needs more than one stretch for full accuracy: of a torus or a sphere a quarter each, of another surface
    // less, since borders lie beyond its range.
    const GeomAbs_SurfaceType type = surface.GetType();
    const bool is_round = type == GeomAbs_Torus || type == GeomAbs_Sphere;
    const auto parts_of = [&](double quarters) {
        if (is_round) return std::max(1, static_cast<int>(std::ceil(quarters - no_stretch)));
        return surface.IsVPeriodic() ? 1 + static_cast<int>(quarters) : 1;
    };
    for (int i = bounds.Lower(); i < bounds.Upper(); ++i) {
        const int parts = parts_of((bounds(i + 1) - bounds(i)) / (std::numbers::pi / 2));
        for (int k = 0; k < parts; ++k) v.stretches.push_back(bounds(i) + (bounds(i + 1) - bounds(i)) * k / parts);
    }
    v.stretches.push_back(bounds(bounds.Upper()));
    return v;
}

/// Has it far more smooth stretches along v than along u, as the flank of a thread does? Then lines of constant u are
/// costly.
bool is_long_along_v(const BRepAdaptor_Surface& surface) {
    constexpr int far_more = 4, many = 8;
    if (!is_spline(surface) || surface.IsUPeriodic() || surface.IsVPeriodic()) return false;
    const int count = surface.NbVIntervals(GeomAbs_CN);
    return count >= many && count >= far_more * surface.NbUIntervals(GeomAbs_CN);
}

Direction along_u_of_long(const BRepAdaptor_Surface& surface) {
    TColStd_Array1OfReal bounds(1, surface.NbUIntervals(GeomAbs_CN) + 1);
    surface.UIntervals(bounds, GeomAbs_CN);
    return {{bounds.begin(), bounds.end()}};
}

/// The flux through a curved face. By Green's theorem it is minus the integral of H du along the face's border, where
/// H(u, v) is the flux through the line of constant u, from the start of v's range to v. Where the face is long along v
/// the two parameters change places, which turns the border round.
class CurvedFace {
  public:
    CurvedFace(const TopoDS_Face& face, const BRepAdaptor_Surface& surface, const Vec3& apex, double size)
        // Oriented forward: which of a seam's two parameter curves the kernel returns depends on the face's
        // orientation.
        : face_(TopoDS::Face(face.Oriented(TopAbs_FORWARD))),
          surface_(surface),
          apex_(apex),
          size_(size),
          is_turned_(face_.NbChildren() > 0 && is_long_along_v(surface)),
          v_(is_turned_ ? along_u_of_long(surface) : along_v(surface)),
          border_(border_of(face)) {
        for (const TopoDS_Edge& edge : border_) traces_.emplace_back(edge, face_);
        if (is_spline(surface) && v_.stretches.size() > 2)
            for (std::size_t i = 1; i < v_.stretches.size(); ++i) patches_.emplace_back(face_, false);
    }

    double value() const {
        if (face_.NbChildren() == 0) return over_natural_bounds();
        std::vector<Gap> gaps = gaps_between(std::vector<Parameters>(border_.size()));
        std::vector<Parameters> shifts(border_.size());
        if (std::any_of(gaps.begin(), gaps.end(), [&](const Gap& gap) { return is_whole_periods(gap); })) {
            shifts = shifts_of_border();
            gaps = gaps_between(shifts);
        }
        double up_to_border = 0;
        for (const Gap& gap : gaps) {
            const Vec3 middle = (gap.from + gap.to) / 2, along = gap.to - gap.from;
            up_to_border += is_turned_ ? -up_to(middle.y, middle.x) * along.y : up_to(middle.x, middle.y) * along.x;
        }
        up_to_border += sum_along(border_, [&](std::size_t i) {
            const Integrand share = [&](double t) {
                gp_Pnt2d uv;
                gp_Vec2d d;
                traces_[i].D1(t, uv, d);
                if (is_turned_) return d.Y() == 0 ? 0.0 : -up_to(uv.Y(), uv.X()) * d.Y();
                return d.X() == 0 ? 0.0 : up_to(uv.X(), uv.Y() + shifts[i].v) * d.X();
            };
            return along(share, smooth_stretches(traces_[i]), relative_error * cube());
        });
        const double beyond =
            sum_along(border_, [&](std::size_t i) { return has_ribbon(border_[i], size_) ? beyond_border(i) : 0.0; });
        return beyond - up_to_border;
    }

  private:
    double density(const BRepAdaptor_Surface& surface, double u, double v) const {
        if (is_turned_) std::swap(u, v);
        gp_Pnt p;
        gp_Vec du, dv;
        surface.D1(u, v, p, du, dv);
        return dot(to_vec3(p) - apex_, cross(to_vec3(du), to_vec3(dv))) / 3;
    }

    double cube() const { return size_ * size_ * size_; }

    std::vector<Gap> gaps_between(const std::vector<Parameters>& shifts) const {
        return gaps_of_border(border_, [&](std::size_t i, bool first) {
            const gp_Pnt2d uv = end_of(traces_[i], first);
            return Vec3{uv.X() + shifts[i].u, uv.Y() + shifts[i].v, 0};
        });
    }

    bool is_whole_periods(const Gap& gap) const {
        const Parameters jump = whole_periods({gap.to.x - gap.from.x, gap.to.y - gap.from.y}, period_of(surface_));
        return jump.u != 0 || jump.v != 0;
    }

    /// By edge, where the kernel lets curves of the border lie whole periods apart.
    std::vector<Parameters> shifts_of_border() const {
        TopTools_IndexedMapOfShape vertices;
        std::vector<BorderStep> steps;
        for (std::size_t i = 0; i < border_.size(); ++i) {
            const bool forward = border_[i].Orientation() == TopAbs_FORWARD;
            const gp_Pnt2d begin = end_of(traces_[i], forward), end = end_of(traces_[i], !forward);
            steps.push_back({vertices.Add(TopExp::FirstVertex(border_[i], true)),
                             vertices.Add(TopExp::LastVertex(border_[i], true)),
                             {begin.X(), begin.Y()},
                             {end.X(), end.Y()}});
        }
        return period_shifts(steps, period_of(surface_));
    }

    double beyond_border(std::size_t number) const {
        const BRepAdaptor_Curve in_space(border_[number]);
        const Integrand share = [&](double t) {
            gp_Pnt2d uv;
            gp_Vec2d d;
            traces_[number].D1(t, uv, d);
            gp_Pnt p;
            gp_Vec du, dv;
            surface_.D1(off_ends(uv.X(), surface_.FirstUParameter(), surface_.LastUParameter()),
                        off_ends(uv.Y(), surface_.FirstVParameter(), surface_.LastVParameter()), p, du, dv);
            return ribbon({to_vec3(p), to_vec3(du) * d.X() + to_vec3(dv) * d.Y()}, point_on(in_space, t), apex_);
        };
        return along(share, smooth_stretches(in_space), ribbon_error * cube());
    }

    /// At the ends of a parameter's range the kernel takes several times as long on splines.
    static double off_ends(double t, double first, double last) {
        return t == first ? t + no_stretch * (last - first) : t == last ? t - no_stretch * (last - first) : t;
    }

    double up_to(double u, double v) const {
        const std::vector<double>& stretches = v_.stretches;
        // A border along the lower end.
        if (std::abs(v - stretches.front()) <= no_stretch * (stretches.back() - stretches.front())) return 0;
        double sum = 0, from = stretches[0];
        for (std::size_t i = 1; i < stretches.size() && from != v; ++i) {
            const BRepAdaptor_Surface& surface = patches_.empty() ? surface_ : patches_[i - 1];
            const bool last = i + 1 == stretches.size() || v < stretches[i];
            const double to = last ? v : stretches[i];
            const double share = std::abs(to - from) / (stretches[i] - stretches[i - 1]);
            sum += gauss([&](double s) { return density(surface, u, s); }, from, to, points_over(share, v_.points));
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
    bool is_turned_;  ///< u is v, and v is u
    Direction v_;
    std::vector<TopoDS_Edge> border_;
    std::deque<BRepAdaptor_Curve2d> traces_;   ///< by edge
    std::deque<BRepAdaptor_Surface> patches_;  ///< by stretch: the kernel keeps the powers of one patch of a spline
};

}  // namespace

double flux(const TopoDS_Face& face, const Vec3& apex, double size) {
    if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED) return 0;
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
        sum += flux(face, apex, box_of(face).diagonal());
    }
    return sum;
}

}  // namespace featuremesh

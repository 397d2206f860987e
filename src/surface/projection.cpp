// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/projection.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <ElCLib.hxx>
#include <ElSLib.hxx>
#include <Extrema_ExtPC.hxx>
#include <Extrema_ExtPS.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "brep/face_trim.h"
#include "brep/occt_geometry.h"

namespace featuremesh {

namespace {

using Uv = std::array<double, 2>;

struct UvBox {
    double u_min = 0, u_max = 0, v_min = 0, v_max = 0;
};

/// What is kept per face; built when the face is first asked for.
struct SurfaceData {
    explicit SurfaceData(const TopoDS_Face& f) : face(f), adaptor(f, Standard_False), trim(f) {
        u_period = adaptor.IsUPeriodic() ? adaptor.UPeriod() : 0;
        v_period = adaptor.IsVPeriodic() ? adaptor.VPeriod() : 0;
    }
    const UvBox& trim_box() const {
        if (!box) {
            box.emplace();
            BRepTools::UVBounds(face, box->u_min, box->u_max, box->v_min, box->v_max);
        }
        return *box;
    }
    TopoDS_Face face;
    BRepAdaptor_Surface adaptor;
    mutable std::optional<UvBox> box;  ///< few who ask for a face need its trim
    double u_period = 0, v_period = 0;
    FaceTrim trim;
    Handle(ShapeAnalysis_Surface) global;
    std::unique_ptr<Extrema_ExtPS> nearest_points;  ///< with the grid of its surface, which takes longer than a search
};

double shifted_near(double x, double period, double wanted) {
    return period > 0 ? x + period * std::round((wanted - x) / period) : x;
}

/// The same point of the surface, in the period that the face's trim (or the guess) uses.
Uv in_period(const SurfaceData& s, Uv uv, const std::optional<Uv>& guess) {
    if (s.u_period == 0 && s.v_period == 0) return uv;
    const Uv wanted =
        guess ? *guess
              : Uv{0.5 * (s.trim_box().u_min + s.trim_box().u_max), 0.5 * (s.trim_box().v_min + s.trim_box().v_max)};
    return {shifted_near(uv[0], s.u_period, wanted[0]), shifted_near(uv[1], s.v_period, wanted[1])};
}

/// Half way between two parameters of a closed surface whose parameters do not go on beyond their range.
double half_way_round(double from, double to, double first, double last) {
    const double range = last - first, middle = 0.5 * (from + shifted_near(to, range, from));
    return middle < first ? middle + range : middle > last ? middle - range : middle;
}

std::optional<Uv> analytic_parameters(const BRepAdaptor_Surface& a, const gp_Pnt& p) {
    Uv uv;
    switch (a.GetType()) {
        case GeomAbs_Plane:
            ElSLib::Parameters(a.Plane(), p, uv[0], uv[1]);
            return uv;
        case GeomAbs_Cylinder:
            ElSLib::Parameters(a.Cylinder(), p, uv[0], uv[1]);
            return uv;
        case GeomAbs_Cone:
            ElSLib::Parameters(a.Cone(), p, uv[0], uv[1]);
            return uv;
        case GeomAbs_Sphere:
            ElSLib::Parameters(a.Sphere(), p, uv[0], uv[1]);
            return uv;
        case GeomAbs_Torus:
            ElSLib::Parameters(a.Torus(), p, uv[0], uv[1]);
            return uv;
        default:
            return std::nullopt;
    }
}

OnFace at(const SurfaceData& s, const Uv& uv, const Vec3& asked) {
    const Vec3 q = to_vec3(s.adaptor.Value(uv[0], uv[1]));
    return {q, uv, distance(q, asked)};
}

double clamped(double x, double low, double high, double period) { return period > 0 ? x : std::clamp(x, low, high); }

/// Smaller steps are rounding, mm.
double negligible_step(const Vec3& p, double distance) { return 1e-12 * (1 + distance) + 1e-14 * length(p); }
/// Far from the origin rounding hides in the squared distance what the last steps gain.
double rounding_of_square(const Vec3& p, double square) {
    return 1e-14 * square + 2e-15 * length(p) * std::sqrt(square);
}

/// Of a step, so that it is half a period at most.
double share_within_period(double step, double period) {
    return period > 0 && 2 * std::abs(step) > period ? 0.5 * period / std::abs(step) : 1;
}

/// Newton on |S(u,v) - p|^2 with step halving; none when it does not reach a stationary point.
std::optional<Uv> newton(const SurfaceData& s, const Vec3& p, Uv uv) {
    const auto& a = s.adaptor;
    const auto value = [&](const Uv& w) { return squared_length(to_vec3(a.Value(w[0], w[1])) - p); };
    double f = value(uv);
    for (int round = 0; round < 30; ++round) {
        gp_Pnt q;
        gp_Vec du, dv, duu, dvv, duv;
        a.D2(uv[0], uv[1], q, du, dv, duu, dvv, duv);
        const gp_Vec r(to_pnt(p), q);
        const double gu = r * du, gv = r * dv, e = du * du, g = dv * dv, m = du * dv;
        double huu = e + r * duu, hvv = g + r * dvv, huv = m + r * duv;
        if (huu <= 0 || huu * hvv - huv * huv <= 1e-8 * e * g) huu = e, hvv = g, huv = m;
        const double det = huu * hvv - huv * huv;
        if (!(det > 0)) return std::nullopt;
        const Uv step{(-gu * hvv + gv * huv) / det, (-gv * huu + gu * huv) / det};
        const double move =
            std::sqrt(std::abs(step[0] * step[0] * e + 2 * step[0] * step[1] * m + step[1] * step[1] * g));
        if (move < negligible_step(p, std::sqrt(f))) return uv;
        // beside a pole a short way in space may be one of many periods
        double scale = std::min(share_within_period(step[0], s.u_period), share_within_period(step[1], s.v_period));
        bool better = false;
        for (int halving = 0; halving < 12 && !better; ++halving, scale *= 0.5) {
            const Uv next{clamped(uv[0] + scale * step[0], a.FirstUParameter(), a.LastUParameter(), s.u_period),
                          clamped(uv[1] + scale * step[1], a.FirstVParameter(), a.LastVParameter(), s.v_period)};
            const double f_next = value(next);
            if (f_next < f || (halving == 0 && f_next <= f + rounding_of_square(p, f))) {
                better = next != uv;
                uv = next, f = std::min(f, f_next);
                if (!better) return uv;
            }
        }
        if (!better) return move < 1e-7 * (1 + std::sqrt(f)) ? std::optional<Uv>(uv) : std::nullopt;
    }
    return std::nullopt;
}

OnFace global_nearest(SurfaceData& s, const Vec3& p) {
    if (s.global.IsNull()) s.global = new ShapeAnalysis_Surface(BRep_Tool::Surface(s.face));
    const gp_Pnt2d start = s.global->ValueOfUV(to_pnt(p), 1e-9);
    Uv best{start.X(), start.Y()};
    if (const auto polished = newton(s, p, best)) best = *polished;
    OnFace result = at(s, in_period(s, best, {}), p);
    if (result.distance < 1e-6) return result;
    if (!s.nearest_points) {
        const UvBox& b = s.trim_box();
        s.nearest_points = std::make_unique<Extrema_ExtPS>();
        s.nearest_points->Initialize(s.adaptor, b.u_min, b.u_max, b.v_min, b.v_max, 1e-10, 1e-10);
    }
    Extrema_ExtPS& extrema = *s.nearest_points;
    extrema.Perform(to_pnt(p));
    if (extrema.IsDone())
        for (int i = 1; i <= extrema.NbExt(); ++i) {
            Uv uv;
            extrema.Point(i).Parameter(uv[0], uv[1]);
            if (const OnFace other = at(s, in_period(s, uv, {}), p); other.distance < result.distance) result = other;
        }
    return result;
}

/// What is kept per edge.
struct CurveData {
    explicit CurveData(const TopoDS_Edge& e)
        : adaptor(e), first(adaptor.FirstParameter()), last(adaptor.LastParameter()) {}
    BRepAdaptor_Curve adaptor;
    double first, last;
};

OnEdge at(const CurveData& c, double t, const Vec3& asked) {
    const Vec3 q = to_vec3(c.adaptor.Value(t));
    return {q, t, distance(q, asked)};
}

OnEdge nearer_of(const OnEdge& a, const OnEdge& b) { return b.distance < a.distance ? b : a; }

/// The parameter within the trimmed edge, or the nearer end.
OnEdge within_edge(const CurveData& c, double t, double period, const Vec3& p) {
    t = shifted_near(t, period, 0.5 * (c.first + c.last));
    if (t >= c.first && t <= c.last) return at(c, t, p);
    return nearer_of(at(c, c.first, p), at(c, c.last, p));
}

std::optional<double> newton(const CurveData& c, const Vec3& p, double t) {
    for (int round = 0; round < 30; ++round) {
        gp_Pnt q;
        gp_Vec d1, d2;
        c.adaptor.D2(t, q, d1, d2);
        const gp_Vec r(to_pnt(p), q);
        const double slope = r * d1, speed = d1 * d1;
        double curvature = speed + r * d2;
        if (curvature <= 0.1 * speed) curvature = speed;
        if (!(curvature > 0)) return std::nullopt;
        const double next = std::clamp(t - slope / curvature, c.first, c.last);
        if (std::abs(next - t) * std::sqrt(speed) < negligible_step(p, r.Magnitude())) return next;
        t = next;
    }
    return std::nullopt;
}

OnEdge global_nearest(const CurveData& c, const Vec3& p) {
    OnEdge best = nearer_of(at(c, c.first, p), at(c, c.last, p));
    Extrema_ExtPC extrema(to_pnt(p), c.adaptor, c.first, c.last, 1e-10);
    if (extrema.IsDone())
        for (int i = 1; i <= extrema.NbExt(); ++i) best = nearer_of(best, at(c, extrema.Point(i).Parameter(), p));
    return best;
}

/// Builds the entry when it is first asked for.
template <class Entry, class Shape>
Entry& entry(std::vector<std::unique_ptr<Entry>>& list, std::size_t index, const Shape& shape) {
    if (!list[index]) list[index] = std::make_unique<Entry>(shape);
    return *list[index];
}

}  // namespace

struct Projector::Data {
    explicit Data(const Brep& b) : brep(b), curves(b.edge_count()), surfaces(b.face_count()) {}
    CurveData& curve(EdgeId id) { return entry(curves, id.index(), brep.edge(id)); }
    SurfaceData& surface(FaceId id) { return entry(surfaces, id.index(), brep.face(id)); }

    Brep brep;
    std::vector<std::unique_ptr<CurveData>> curves;
    std::vector<std::unique_ptr<SurfaceData>> surfaces;
};

Projector::Projector(const Brep& brep) : data_(std::make_unique<Data>(brep)) {}
Projector::~Projector() = default;
Projector::Projector(Projector&&) noexcept = default;
Projector Projector::another() const { return Projector(data_->brep); }

Vec3 Projector::on_edge(EdgeId edge, double t) const { return to_vec3(data_->curve(edge).adaptor.Value(t)); }

std::array<double, 2> Projector::range(EdgeId edge) const {
    const BRepAdaptor_Curve& curve = data_->curve(edge).adaptor;
    return {curve.FirstParameter(), curve.LastParameter()};
}

double Projector::half_way(EdgeId edge, double from, double to) const {
    const BRepAdaptor_Curve& curve = data_->curve(edge).adaptor;
    const double middle = 0.5 * (from + to);
    if (curve.GetType() == GeomAbs_Line || curve.GetType() == GeomAbs_Circle) return middle;
    const double half_length = 0.5 * GCPnts_AbscissaPoint::Length(curve, from, to);
    GCPnts_AbscissaPoint search(curve, half_length, from, middle);
    return search.IsDone() && search.Parameter() > from && search.Parameter() < to ? search.Parameter() : middle;
}

Vec3 Projector::tangent(EdgeId edge, double t) const {
    gp_Pnt p;
    gp_Vec d;
    data_->curve(edge).adaptor.D1(t, p, d);
    return d.Magnitude() > 0 ? to_vec3(d) / d.Magnitude() : Vec3{};
}

Vec3 Projector::on_face(FaceId face, std::array<double, 2> uv) const {
    return to_vec3(data_->surface(face).adaptor.Value(uv[0], uv[1]));
}

std::array<double, 2> Projector::half_way(FaceId face, std::array<double, 2> from, std::array<double, 2> to) const {
    const SurfaceData& s = data_->surface(face);
    if (s.u_period > 0 || s.v_period > 0) to = in_period(s, to, from);
    const auto& a = s.adaptor;
    return {a.IsUClosed() && s.u_period == 0 ? half_way_round(from[0], to[0], a.FirstUParameter(), a.LastUParameter())
                                             : 0.5 * (from[0] + to[0]),
            a.IsVClosed() && s.v_period == 0 ? half_way_round(from[1], to[1], a.FirstVParameter(), a.LastVParameter())
                                             : 0.5 * (from[1] + to[1])};
}

OnEdge Projector::nearest(EdgeId edge, const Vec3& p, std::optional<double> guess) const {
    const CurveData& c = data_->curve(edge);
    if (c.adaptor.GetType() == GeomAbs_Line)
        return within_edge(c, ElCLib::Parameter(c.adaptor.Line(), to_pnt(p)), 0, p);
    if (c.adaptor.GetType() == GeomAbs_Circle)
        return within_edge(c, ElCLib::Parameter(c.adaptor.Circle(), to_pnt(p)), 2 * M_PI, p);
    if (guess)
        if (const auto t = newton(c, p, std::clamp(*guess, c.first, c.last))) return at(c, *t, p);
    return global_nearest(c, p);
}

bool Projector::needs_search(FaceId face) const {
    return data_->surface(face).adaptor.GetType() > GeomAbs_Torus;  // those before it are listed above
}

bool Projector::closes(FaceId face) const {
    const BRepAdaptor_Surface& surface = data_->surface(face).adaptor;
    return surface.IsUClosed() || surface.IsVClosed();
}

OnFace Projector::nearest(FaceId face, const Vec3& p, std::optional<std::array<double, 2>> guess) const {
    SurfaceData& s = data_->surface(face);
    if (const auto uv = analytic_parameters(s.adaptor, to_pnt(p))) return at(s, in_period(s, *uv, guess), p);
    if (guess)
        if (const auto uv = newton(s, p, *guess)) return at(s, *uv, p);
    return global_nearest(s, p);
}

std::optional<OnFace> Projector::nearest_by_steps(FaceId face, const Vec3& p, std::array<double, 2> guess) const {
    const SurfaceData& s = data_->surface(face);
    if (const auto uv = analytic_parameters(s.adaptor, to_pnt(p))) return at(s, in_period(s, *uv, guess), p);
    if (const auto uv = newton(s, p, guess)) return at(s, *uv, p);
    return std::nullopt;
}

std::optional<OnEntity> Projector::nearest_by_steps(Entity entity, const Vec3& p, std::array<double, 2> guess) const {
    if (entity.dim == 1) {
        const OnEdge there = nearest(EdgeId(entity.index), p, guess[0]);
        return OnEntity{there.point, {there.t, 0}};
    }
    const std::optional<OnFace> there = nearest_by_steps(FaceId(entity.index), p, guess);
    return there ? std::optional(OnEntity{there->point, there->uv}) : std::nullopt;
}

bool Projector::is_inside_trim(FaceId face, std::array<double, 2> uv) const {
    SurfaceData& s = data_->surface(face);
    uv = in_period(s, uv, {});  // the kernel would take one period after the other
    return s.trim.has(uv[0], uv[1]);
}

Vec3 Projector::normal(FaceId face, std::array<double, 2> uv) const {
    const SurfaceData& s = data_->surface(face);
    gp_Pnt q;
    gp_Vec du, dv;
    s.adaptor.D1(uv[0], uv[1], q, du, dv);
    Vec3 n = cross(to_vec3(du), to_vec3(dv));
    if (length(n) <= 1e-12 * length(to_vec3(du)) * length(to_vec3(dv)) || length(n) == 0) {
        // A pole: the normal a little way into the face is the one of the pole to first order.
        const auto& b = s.trim_box();
        const double share = 1e-6;
        s.adaptor.D1(uv[0] + share * (0.5 * (b.u_min + b.u_max) - uv[0]),
                     uv[1] + share * (0.5 * (b.v_min + b.v_max) - uv[1]), q, du, dv);
        n = cross(to_vec3(du), to_vec3(dv));
    }
    n = normalized(n);
    return s.face.Orientation() == TopAbs_REVERSED ? -n : n;
}

Vec3 Projector::along(Entity entity, std::array<double, 2> parameters, const Vec3& direction) const {
    if (entity.dim == 1) {
        const Vec3 way = tangent(EdgeId(entity.index), parameters[0]);
        return dot(direction, way) * way;
    }
    const Vec3 across = normal(FaceId(entity.index), parameters);
    return direction - dot(direction, across) * across;
}

}  // namespace featuremesh

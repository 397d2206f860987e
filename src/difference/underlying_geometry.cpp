// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/underlying_geometry.h"

#include <BRep_Tool.hxx>
#include <ElCLib.hxx>
#include <ElSLib.hxx>
#include <Extrema_ExtPC.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include "core/tolerances.h"

namespace featuremesh {

namespace {
Vec3 axis_of(const UnderlyingSurface& c) { return to_vec3(gp_Vec(c.position.Direction())); }
Vec3 axis_of(const UnderlyingCurve& c) { return to_vec3(gp_Vec(c.position.Direction())); }
Vec3 origin_of(const UnderlyingSurface& c) { return to_vec3(c.position.Location()); }
Vec3 origin_of(const UnderlyingCurve& c) { return to_vec3(c.position.Location()); }

Vec3 foot_on_axis(const Vec3& origin, const Vec3& axis, const Vec3& p) { return origin + axis * dot(p - origin, axis); }

bool parallel(const Vec3& a, const Vec3& b, const Sameness& s) { return length(cross(a, b)) * s.reach <= s.length; }

bool same_axis(const Vec3& origin_a, const Vec3& axis_a, const Vec3& origin_b, const Vec3& axis_b, const Sameness& s) {
    const Vec3 q = foot_on_axis(origin_b, axis_b, s.centre);
    return parallel(axis_a, axis_b, s) && distance(foot_on_axis(origin_a, axis_a, q), q) <= s.length;
}

bool same_plane(const UnderlyingSurface& a, const UnderlyingSurface& b, const Sameness& s) {
    const Vec3 q = s.centre - axis_of(b) * dot(s.centre - origin_of(b), axis_of(b));
    return parallel(axis_of(a), axis_of(b), s) && std::abs(dot(q - origin_of(a), axis_of(a))) <= s.length;
}

/// Radius and slope along the axis at a point of it; the sign of both together has no meaning on a double cone.
std::array<double, 2> cone_at(const UnderlyingSurface& c, const Vec3& p) {
    const double slope = std::tan(c.second);
    return {c.radius + dot(p - origin_of(c), axis_of(c)) * slope, slope};
}

bool same_cone(const UnderlyingSurface& a, const UnderlyingSurface& b, const Sameness& s) {
    if (!same_axis(origin_of(a), axis_of(a), origin_of(b), axis_of(b), s)) return false;
    const Vec3 q = foot_on_axis(origin_of(b), axis_of(b), s.centre);
    const auto [radius_a, slope_a] = cone_at(a, q);
    auto [radius_b, slope_b] = cone_at(b, q);
    if (dot(axis_of(a), axis_of(b)) < 0) slope_b = -slope_b;
    for (const double sign : {1.0, -1.0})
        if (std::abs(radius_a - sign * radius_b) <= s.length &&
            std::abs(slope_a - sign * slope_b) * s.reach <= s.length)
            return true;
    return false;
}

bool same_radii(double a, double b, double a2, double b2, const Sameness& s) {
    return std::abs(a - b) <= s.length && std::abs(a2 - b2) <= s.length;
}

template <class Geometry>
bool take(const Handle(Geom_Surface) & surface, Handle(Geometry) & result) {
    result = Handle(Geometry)::DownCast(surface);
    return !result.IsNull();
}

void recognise(UnderlyingSurface& c) {
    Handle(Geom_Plane) plane;
    Handle(Geom_CylindricalSurface) cylinder;
    Handle(Geom_ConicalSurface) cone;
    Handle(Geom_SphericalSurface) sphere;
    Handle(Geom_ToroidalSurface) torus;
    if (take(c.surface, plane)) {
        c.kind = SurfaceKind::plane, c.position = plane->Position();
    } else if (take(c.surface, cylinder)) {
        c.kind = SurfaceKind::cylinder, c.position = cylinder->Position(), c.radius = cylinder->Radius();
    } else if (take(c.surface, cone)) {
        c.kind = SurfaceKind::cone, c.position = cone->Position();
        c.radius = cone->RefRadius(), c.second = cone->SemiAngle();
    } else if (take(c.surface, sphere)) {
        c.kind = SurfaceKind::sphere, c.position = sphere->Position(), c.radius = sphere->Radius();
    } else if (take(c.surface, torus)) {
        c.kind = SurfaceKind::torus, c.position = torus->Position();
        c.radius = torus->MajorRadius(), c.second = torus->MinorRadius();
    }
}

void recognise(UnderlyingCurve& c) {
    if (const auto line = Handle(Geom_Line)::DownCast(c.curve); !line.IsNull()) {
        c.kind = CurveKind::line;
        c.position = gp_Ax2(line->Lin().Location(), line->Lin().Direction());
    } else if (const auto circle = Handle(Geom_Circle)::DownCast(c.curve); !circle.IsNull()) {
        c.kind = CurveKind::circle, c.position = circle->Position(), c.radius = circle->Radius();
    } else if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(c.curve); !ellipse.IsNull()) {
        c.kind = CurveKind::ellipse, c.position = ellipse->Position();
        c.radius = ellipse->MajorRadius(), c.second = ellipse->MinorRadius();
    }
}
}  // namespace

Sameness sameness_of(const Box& was, const Box& is) {
    Box both = was;
    both.add(is);
    return {Tolerances{both.diagonal()}.same_geometry(), both.center(), both.diagonal()};
}

UnderlyingSurface underlying_of(const TopoDS_Face& face) {
    UnderlyingSurface c;
    TopLoc_Location location;
    c.surface = BRep_Tool::Surface(face, location);
    while (!c.surface.IsNull() && c.surface->IsKind(STANDARD_TYPE(Geom_RectangularTrimmedSurface)))
        c.surface = Handle(Geom_RectangularTrimmedSurface)::DownCast(c.surface)->BasisSurface();
    c.placement = location.Transformation();
    recognise(c);
    if (c.kind != SurfaceKind::free_form) c.position.Transform(c.placement);
    return c;
}

UnderlyingSurface moved(UnderlyingSurface c, const gp_Trsf& motion) {
    c.position.Transform(motion);
    c.placement = motion * c.placement;
    return c;
}

bool same_underlying(const UnderlyingSurface& a, const UnderlyingSurface& b, const Sameness& s) {
    if (a.kind != b.kind) return false;
    switch (a.kind) {
        case SurfaceKind::plane:
            return same_plane(a, b, s);
        case SurfaceKind::cylinder:
            return same_radii(a.radius, b.radius, 0, 0, s) &&
                   same_axis(origin_of(a), axis_of(a), origin_of(b), axis_of(b), s);
        case SurfaceKind::cone:
            return same_cone(a, b, s);
        case SurfaceKind::sphere:
            return same_radii(a.radius, b.radius, 0, 0, s) && distance(origin_of(a), origin_of(b)) <= s.length;
        case SurfaceKind::torus:
            return same_radii(a.radius, b.radius, a.second, b.second, s) &&
                   distance(origin_of(a), origin_of(b)) <= s.length && parallel(axis_of(a), axis_of(b), s);
        case SurfaceKind::free_form:
            return same_geometry(a.surface, a.placement, b.surface, b.placement, s.length);
    }
    return false;
}

bool is_as_wide(const UnderlyingSurface& a, const UnderlyingSurface& b) {
    constexpr double same_radius = 1e-5, same_angle = 1e-6;  // mm, rad: as files and rebuilt shapes keep them
    if (a.kind != b.kind) return false;
    const bool is_cone = a.kind == SurfaceKind::cone;
    return (is_cone || std::abs(a.radius - b.radius) <= same_radius) &&
           std::abs(a.second - b.second) <= (is_cone ? same_angle : same_radius);
}

double sort_key(const UnderlyingSurface& c, const Vec3& reference) {
    switch (c.kind) {
        case SurfaceKind::plane:
            return std::abs(dot(reference - origin_of(c), axis_of(c)));
        case SurfaceKind::cylinder:
        case SurfaceKind::cone:
            return distance(foot_on_axis(origin_of(c), axis_of(c), reference), reference);
        case SurfaceKind::sphere:
        case SurfaceKind::torus:
            return distance(origin_of(c), reference);
        case SurfaceKind::free_form:
            break;
    }
    double u0, u1, v0, v1;
    c.surface->Bounds(u0, u1, v0, v1);
    const auto finite = [](double t) { return std::abs(t) < 1e50 ? t : 0.0; };
    return distance(to_vec3(c.surface->Value(finite(u0), finite(v0)).Transformed(c.placement)), reference);
}

Vec3 point_at(const UnderlyingSurface& c, double u, double v) {
    switch (c.kind) {
        case SurfaceKind::plane:
            return to_vec3(ElSLib::PlaneValue(u, v, c.position));
        case SurfaceKind::cylinder:
            return to_vec3(ElSLib::CylinderValue(u, v, c.position, c.radius));
        case SurfaceKind::cone:
            return to_vec3(ElSLib::ConeValue(u, v, c.position, c.radius, c.second));
        case SurfaceKind::sphere:
            return to_vec3(ElSLib::SphereValue(u, v, c.position, c.radius));
        case SurfaceKind::torus:
            return to_vec3(ElSLib::TorusValue(u, v, c.position, c.radius, c.second));
        case SurfaceKind::free_form:
            break;
    }
    return to_vec3(c.surface->Value(u, v).Transformed(c.placement));
}

std::array<double, 2> parameters_of(const UnderlyingSurface& c, const Vec3& p) {
    double u = 0, v = 0;
    const gp_Pnt q = to_pnt(p);
    if (c.kind == SurfaceKind::plane) ElSLib::PlaneParameters(c.position, q, u, v);
    if (c.kind == SurfaceKind::cylinder) ElSLib::CylinderParameters(c.position, c.radius, q, u, v);
    if (c.kind == SurfaceKind::cone) ElSLib::ConeParameters(c.position, c.radius, c.second, q, u, v);
    if (c.kind == SurfaceKind::sphere) ElSLib::SphereParameters(c.position, c.radius, q, u, v);
    if (c.kind == SurfaceKind::torus) ElSLib::TorusParameters(c.position, c.radius, c.second, q, u, v);
    return {u, v};
}

Vec3 outward_at(const UnderlyingSurface& c, const Vec3& p, const Vec3& parametric_normal) {
    const Vec3 from_axis = p - foot_on_axis(origin_of(c), axis_of(c), p);
    switch (c.kind) {
        case SurfaceKind::plane:
            return axis_of(c);
        case SurfaceKind::cylinder:
        case SurfaceKind::cone:
            return from_axis;
        case SurfaceKind::sphere:
            return p - origin_of(c);
        case SurfaceKind::torus:
            return p - (origin_of(c) + normalized(from_axis - axis_of(c) * dot(from_axis, axis_of(c))) * c.radius);
        case SurfaceKind::free_form:
            break;
    }
    return parametric_normal;
}

bool same_sense(const UnderlyingSurface& a, const UnderlyingSurface& b) {
    return a.kind != SurfaceKind::plane || dot(axis_of(a), axis_of(b)) > 0;
}

UnderlyingCurve underlying_of(const TopoDS_Edge& edge) {
    UnderlyingCurve c;
    TopLoc_Location location;
    c.curve = BRep_Tool::Curve(edge, location, c.first, c.last);
    while (!c.curve.IsNull() && c.curve->IsKind(STANDARD_TYPE(Geom_TrimmedCurve)))
        c.curve = Handle(Geom_TrimmedCurve)::DownCast(c.curve)->BasisCurve();
    c.placement = location.Transformation();
    c.tolerance = BRep_Tool::Tolerance(edge);
    if (!c.curve.IsNull()) recognise(c);
    if (c.kind != CurveKind::free_form) {
        c.position.Transform(c.placement);
        return c;
    }
    c.adaptor = std::make_shared<BRepAdaptor_Curve>(edge);
    c.first = c.adaptor->FirstParameter();
    c.last = c.adaptor->LastParameter();
    return c;
}

UnderlyingCurve moved(UnderlyingCurve c, const gp_Trsf& motion) {
    c.position.Transform(motion);
    c.placement = motion * c.placement;
    c.motion = motion * c.motion;
    return c;
}

bool same_underlying(const UnderlyingCurve& a, const UnderlyingCurve& b, const Sameness& s) {
    if (a.kind != b.kind) return false;
    switch (a.kind) {
        case CurveKind::line:
            return same_axis(origin_of(a), axis_of(a), origin_of(b), axis_of(b), s);
        case CurveKind::circle:
            return same_radii(a.radius, b.radius, 0, 0, s) && distance(origin_of(a), origin_of(b)) <= s.length &&
                   parallel(axis_of(a), axis_of(b), s);
        case CurveKind::ellipse:
            return same_radii(a.radius, b.radius, a.second, b.second, s) &&
                   distance(origin_of(a), origin_of(b)) <= s.length && parallel(axis_of(a), axis_of(b), s) &&
                   parallel(to_vec3(gp_Vec(a.position.XDirection())), to_vec3(gp_Vec(b.position.XDirection())), s);
        case CurveKind::free_form:
            return !a.curve.IsNull() && !b.curve.IsNull() &&
                   same_geometry(a.curve, a.placement, b.curve, b.placement, s.length);
    }
    return false;
}

bool same_path(const UnderlyingCurve& a, const UnderlyingCurve& b, const Sameness& s) {
    if (!a.adaptor || !b.adaptor) return false;
    const double tolerance = std::max(s.length, std::min(a.tolerance + b.tolerance, 100 * s.length));
    const auto close = [&](double t, double u) { return distance(point_at(a, t), point_at(b, u)) <= tolerance; };
    if (!(close(a.first, b.first) && close(a.last, b.last)) && !(close(a.first, b.last) && close(a.last, b.first)))
        return false;
    const gp_Trsf to_b = b.motion.Inverted();
    constexpr int samples = 9;
    for (int i = 1; i < samples; ++i) {
        const Vec3 p = point_at(a, a.first + (a.last - a.first) * i / samples);
        const Extrema_ExtPC nearest(to_pnt(p).Transformed(to_b), *b.adaptor);
        bool found = false;
        for (int k = 1; nearest.IsDone() && k <= nearest.NbExt(); ++k)
            found = found || nearest.SquareDistance(k) <= tolerance * tolerance;
        if (!found) return false;
    }
    return true;
}

double sort_key(const UnderlyingCurve& c, const Vec3& reference) {
    if (c.kind == CurveKind::line) return distance(foot_on_axis(origin_of(c), axis_of(c), reference), reference);
    if (c.kind != CurveKind::free_form) return distance(origin_of(c), reference);
    if (c.curve.IsNull()) return distance(point_at(c, c.first), reference);
    const double first = c.curve->FirstParameter();
    return distance(to_vec3(c.curve->Value(std::abs(first) < 1e50 ? first : 0.0).Transformed(c.placement)), reference);
}

Vec3 point_at(const UnderlyingCurve& c, double t) {
    switch (c.kind) {
        case CurveKind::line:
            return to_vec3(ElCLib::LineValue(t, c.position.Axis()));
        case CurveKind::circle:
            return to_vec3(ElCLib::CircleValue(t, c.position, c.radius));
        case CurveKind::ellipse:
            return to_vec3(ElCLib::EllipseValue(t, c.position, c.radius, c.second));
        case CurveKind::free_form:
            break;
    }
    return to_vec3(c.adaptor->Value(t).Transformed(c.motion));
}

double parameter_of(const UnderlyingCurve& c, const Vec3& p) {
    if (c.kind == CurveKind::line) return ElCLib::LineParameter(c.position.Axis(), to_pnt(p));
    if (c.kind == CurveKind::circle) return ElCLib::CircleParameter(c.position, to_pnt(p));
    return ElCLib::EllipseParameter(c.position, c.radius, c.second, to_pnt(p));
}

bool same_direction(const UnderlyingCurve& a, const UnderlyingCurve& b) { return dot(axis_of(a), axis_of(b)) > 0; }

}  // namespace featuremesh

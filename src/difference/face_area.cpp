// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/face_area.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Conic.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>

#include "brep/occt_geometry.h"
#include "core/geometry.h"
#include "difference/boundary_model.h"
#include "difference/underlying_geometry.h"

namespace featuremesh {
namespace {
/// Integral over v, from 0, of the area of the surface element.
double strip(const UnderlyingSurface& c, double v) {
    switch (c.kind) {
        case SurfaceKind::plane:
            return v;
        case SurfaceKind::cylinder:
            return c.radius * v;
        case SurfaceKind::cone:
            return c.radius * v + 0.5 * v * v * std::sin(c.second);
        case SurfaceKind::sphere:
            return c.radius * c.radius * std::sin(v);
        case SurfaceKind::torus:
            return c.second * (c.radius * v + c.second * std::sin(v));
        case SurfaceKind::free_form:
            break;
    }
    return 0;
}

/// Integral of `strip` du along the edge's trace, by eight Gauss points on each of some parts.
double along_trace(const UnderlyingSurface& c, Handle(Geom2d_Curve) trace, double first, double last) {
    constexpr double x[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    constexpr double w[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    if (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(trace); !trimmed.IsNull())
        trace = trimmed->BasisCurve();
    const bool is_line = trace->IsKind(STANDARD_TYPE(Geom2d_Line)),
               is_conic = trace->IsKind(STANDARD_TYPE(Geom2d_Conic));
    const int parts = is_line ? 1 : is_conic ? std::max(1, int(std::ceil((last - first) / 1.6))) : 12;
    const double half = 0.5 * (last - first) / parts;
    double sum = 0;
    for (int i = 0; i < parts; ++i)
        for (int k = 0; k < 8; ++k) {
            const double t = first + half * (2 * i + 1 + (k < 4 ? x[k] : -x[k - 4]));
            gp_Pnt2d uv;
            gp_Vec2d tangent;
            trace->D1(t, uv, tangent);
            sum += half * w[k % 4] * strip(c, uv.Y()) * tangent.X();
        }
    return sum;
}
}  // namespace

// From here on the kernel takes its Gauss points span by span. Its adaptive integration takes forty times as long on
// swept splines for 1e-6, and is further off for 1e-4.
constexpr double not_adaptive = 1e-3;

double area_of(const TopoDS_Face& face) {
    const UnderlyingSurface underlying = underlying_of(face);
    if (underlying.kind == SurfaceKind::free_form) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(face, properties, not_adaptive);
        return std::abs(properties.Mass());
    }
    double sum = 0;
    for (TopExp_Explorer e(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); e.More(); e.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(e.Current());
        if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) continue;
        double first = 0, last = 0;
        // Of a seam's two traces this gives the one for the edge's orientation.
        const Handle(Geom2d_Curve) trace =
            BRep_Tool::CurveOnSurface(edge, TopoDS::Face(face.Oriented(TopAbs_FORWARD)), first, last);
        if (trace.IsNull()) continue;
        sum += (edge.Orientation() == TopAbs_FORWARD ? 1 : -1) * along_trace(underlying, trace, first, last);
    }
    return std::abs(sum);
}

double area_of(const BoundaryModel& model, FaceId id) {
    const BoundaryFace& face = model.faces()[id.index()];
    const auto is_simple = [&](const EdgeUse& use) {
        const CurveKind kind = model.edges()[use.edge.index()].curve.kind;
        return kind == CurveKind::line || kind == CurveKind::circle;
    };
    if (face.underlying.kind != SurfaceKind::plane || !std::all_of(face.uses.begin(), face.uses.end(), is_simple))
        return area_of(model.brep().face(id));
    const Vec3 origin = to_vec3(face.underlying.position.Location());
    Vec3 doubled;  // the integral of r x dr along the border
    for (const EdgeUse& use : face.uses) {
        if (use.is_internal) continue;
        const BoundaryEdge& edge = model.edges()[use.edge.index()];
        const UnderlyingCurve& curve = edge.curve;
        Vec3 share = cross(edge.first - origin, edge.last - origin);
        if (curve.kind == CurveKind::circle)
            share =
                cross(to_vec3(curve.position.Location()) - origin, edge.last - edge.first) +
                curve.radius * curve.radius * (curve.last - curve.first) * to_vec3(gp_Vec(curve.position.Direction()));
        doubled += use.forward ? share : -share;
    }
    return 0.5 * std::abs(dot(doubled, to_vec3(gp_Vec(face.underlying.position.Direction()))));
}

}  // namespace featuremesh

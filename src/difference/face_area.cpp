// SPDX-License-Identifier: GPL-3.0-or-later
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
#include "core/ids.h"
#include "difference/feature_difference.h"
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
// From here on the kernel takes its Gauss points span by span. Its adaptive integration takes forty times as long on
// swept splines for 1e-6, and is further off for 1e-4.
constexpr double not_adaptive = 1e-3;

/// mm^2. On planes, cylinders, cones, spheres and tori by Green's theorem along the border in the parameter plane, some
/// fifty times faster than the kernel's integration, which serves the other surfaces.
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
}  // namespace

void tell_areas(std::vector<FaceChange>& faces, const Brep& old_shape, const Brep& new_shape) {
    for (FaceChange& change : faces) {
        if (change.verdict == BoundaryVerdict::kept) continue;
        if (change.old_face.is_valid()) change.old_area = area_of(old_shape.face(change.old_face));
        if (change.new_face.is_valid()) change.new_area = area_of(new_shape.face(change.new_face));
    }
}

}  // namespace featuremesh

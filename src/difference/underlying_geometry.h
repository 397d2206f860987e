// SPDX-License-Identifier: GPL-3.0-or-later
// The unbounded surfaces and curves that faces and edges are cut from, in space and comparable.
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Trsf.hxx>
#include <memory>

#include "brep/occt_geometry.h"
#include "core/geometry.h"

namespace featuremesh {

/// When two underlying surfaces or curves count as one: no further apart than `length` within `reach` of `centre`, mm.
struct Sameness {
    double length = 1e-7;
    Vec3 centre;
    double reach = 1.0;
};

/// Within what either of two states has, by the boxes of the two.
Sameness sameness_of(const Box& was, const Box& is);

enum class SurfaceKind { plane, cylinder, cone, sphere, torus, free_form };

struct UnderlyingSurface {
    SurfaceKind kind = SurfaceKind::free_form;
    gp_Ax3 position;
    double radius = 0;  ///< mm; of the cone at its position, of the torus the larger one
    double second = 0;  ///< smaller radius of the torus, mm; half angle of the cone, rad
    Handle(Geom_Surface) surface;
    gp_Trsf placement;  ///< of `surface` in space
};

UnderlyingSurface underlying_of(const TopoDS_Face& face);
UnderlyingSurface moved(UnderlyingSurface underlying, const gp_Trsf& motion);
bool same_underlying(const UnderlyingSurface& a, const UnderlyingSurface& b, const Sameness& sameness);
/// Equal radii and angles, wherever they are. Planes have none, and free-form surfaces are not asked for theirs.
bool is_as_wide(const UnderlyingSurface& a, const UnderlyingSurface& b);
/// Nearly the same number for the same underlying surfaces, mm; other underlying surfaces mostly have another one.
double sort_key(const UnderlyingSurface& underlying, const Vec3& reference);
Vec3 point_at(const UnderlyingSurface& underlying, double u, double v);
/// The parameters of a point on an underlying surface that is not free-form.
std::array<double, 2> parameters_of(const UnderlyingSurface& underlying, const Vec3& p);
/// A normal that does not depend on the parametrisation: away from the axis, or the plane's own (same_sense tells its
/// sense).
Vec3 outward_at(const UnderlyingSurface& underlying, const Vec3& p, const Vec3& parametric_normal);
/// Whether `outward_at` of both has the same sense.
bool same_sense(const UnderlyingSurface& a, const UnderlyingSurface& b);

enum class CurveKind { line, circle, ellipse, free_form };

struct UnderlyingCurve {
    CurveKind kind = CurveKind::free_form;
    gp_Ax2 position;
    double radius = 0, second = 0;               ///< mm; of the ellipse the larger and the smaller one
    double first = 0, last = 0;                  ///< the edge's own range
    Handle(Geom_Curve) curve;                    ///< null when the edge has none in space
    gp_Trsf placement;                           ///< of `curve` in space
    std::shared_ptr<BRepAdaptor_Curve> adaptor;  ///< of a free-form edge
    gp_Trsf motion;                              ///< of `adaptor`
    double tolerance = 0;                        ///< of the edge, mm
};

UnderlyingCurve underlying_of(const TopoDS_Edge& edge);
UnderlyingCurve moved(UnderlyingCurve underlying, const gp_Trsf& motion);
/// Same curve with, when free-form, the same parameters.
bool same_underlying(const UnderlyingCurve& a, const UnderlyingCurve& b, const Sameness& sameness);
/// Free-form edges that run through the same points in whatever parameters: both ends and points between.
bool same_path(const UnderlyingCurve& a, const UnderlyingCurve& b, const Sameness& sameness);
double sort_key(const UnderlyingCurve& underlying, const Vec3& reference);
Vec3 point_at(const UnderlyingCurve& underlying, double t);
/// The parameter of a point on a curve that is not free-form.
double parameter_of(const UnderlyingCurve& underlying, const Vec3& p);
/// Whether both run in the same direction at a common point, for equal underlying surfaces that are not free-form.
bool same_direction(const UnderlyingCurve& a, const UnderlyingCurve& b);

/// Equal poles, knots, weights, radii, positions; parameters included.
bool same_geometry(const Handle(Geom_Curve) & a, const gp_Trsf& place_a, const Handle(Geom_Curve) & b,
                   const gp_Trsf& place_b, double tolerance);
bool same_geometry(const Handle(Geom_Surface) & a, const gp_Trsf& place_a, const Handle(Geom_Surface) & b,
                   const gp_Trsf& place_b, double tolerance);

}  // namespace featuremesh

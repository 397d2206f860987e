// SPDX-License-Identifier: GPL-3.0-or-later
// Equality of free-form geometry by what defines it.
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Conic.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>

#include "difference/underlying_geometry.h"

namespace featuremesh {
namespace {
/// Two pieces of geometry with their placements; points and directions are compared in space.
struct Placed {
    const gp_Trsf& a;
    const gp_Trsf& b;
    double tolerance;

    bool same(const gp_Pnt& p, const gp_Pnt& q) const {
        return p.Transformed(a).SquareDistance(q.Transformed(b)) <= tolerance * tolerance;
    }
    bool same(const gp_Dir& p, const gp_Dir& q) const {
        return (p.Transformed(a).XYZ() - q.Transformed(b).XYZ()).SquareModulus() <= 1e-20;
    }
    bool same(const gp_Ax2& p, const gp_Ax2& q) const {
        return same(p.Location(), q.Location()) && same(p.Direction(), q.Direction()) &&
               same(p.XDirection(), q.XDirection());
    }
    bool same(double p, double q) const { return std::abs(p - q) <= tolerance; }
};

bool same_numbers(const TColStd_Array1OfReal& a, const TColStd_Array1OfReal& b) {
    if (a.Length() != b.Length()) return false;
    for (int i = 0; i < a.Length(); ++i)
        if (std::abs(a(a.Lower() + i) - b(b.Lower() + i)) > 1e-12 * (1 + std::abs(a(a.Lower() + i)))) return false;
    return true;
}

bool same_numbers(const TColStd_Array1OfInteger& a, const TColStd_Array1OfInteger& b) {
    if (a.Length() != b.Length()) return false;
    for (int i = 0; i < a.Length(); ++i)
        if (a(a.Lower() + i) != b(b.Lower() + i)) return false;
    return true;
}

template <class Curve>
bool same_poles(const Curve& a, const Curve& b, const Placed& at) {
    if (a.Degree() != b.Degree() || a.NbPoles() != b.NbPoles() || a.IsRational() != b.IsRational()) return false;
    for (int i = 1; i <= a.NbPoles(); ++i)
        if (!at.same(a.Pole(i), b.Pole(i)) || std::abs(a.Weight(i) - b.Weight(i)) > 1e-12) return false;
    return true;
}

template <class Surface>
bool same_net(const Surface& a, const Surface& b, const Placed& at) {
    if (a.UDegree() != b.UDegree() || a.VDegree() != b.VDegree() || a.NbUPoles() != b.NbUPoles() ||
        a.NbVPoles() != b.NbVPoles())
        return false;
    for (int i = 1; i <= a.NbUPoles(); ++i)
        for (int j = 1; j <= a.NbVPoles(); ++j)
            if (!at.same(a.Pole(i, j), b.Pole(i, j)) || std::abs(a.Weight(i, j) - b.Weight(i, j)) > 1e-12) return false;
    return true;
}

bool same_spline(const Geom_BSplineCurve& a, const Geom_BSplineCurve& b, const Placed& at) {
    return a.IsPeriodic() == b.IsPeriodic() && same_poles(a, b, at) && same_numbers(a.Knots(), b.Knots()) &&
           same_numbers(a.Multiplicities(), b.Multiplicities());
}

bool same_spline(const Geom_BSplineSurface& a, const Geom_BSplineSurface& b, const Placed& at) {
    return a.IsUPeriodic() == b.IsUPeriodic() && a.IsVPeriodic() == b.IsVPeriodic() && same_net(a, b, at) &&
           same_numbers(a.UKnots(), b.UKnots()) && same_numbers(a.VKnots(), b.VKnots()) &&
           same_numbers(a.UMultiplicities(), b.UMultiplicities()) &&
           same_numbers(a.VMultiplicities(), b.VMultiplicities());
}

/// Position and the two numbers of a conic.
std::array<double, 2> sizes_of(const Handle(Geom_Conic) & conic) {
    if (const auto c = Handle(Geom_Circle)::DownCast(conic); !c.IsNull()) return {c->Radius(), 0};
    if (const auto c = Handle(Geom_Ellipse)::DownCast(conic); !c.IsNull()) return {c->MajorRadius(), c->MinorRadius()};
    if (const auto c = Handle(Geom_Hyperbola)::DownCast(conic); !c.IsNull())
        return {c->MajorRadius(), c->MinorRadius()};
    if (const auto c = Handle(Geom_Parabola)::DownCast(conic); !c.IsNull()) return {c->Focal(), 0};
    return {0, 0};
}
}  // namespace

bool same_geometry(const Handle(Geom_Curve) & a, const gp_Trsf& place_a, const Handle(Geom_Curve) & b,
                   const gp_Trsf& place_b, double tolerance) {
    if (a.IsNull() || b.IsNull() || a->DynamicType() != b->DynamicType()) return false;
    const Placed at{place_a, place_b, tolerance};
    if (const auto c = Handle(Geom_BSplineCurve)::DownCast(a); !c.IsNull())
        return same_spline(*c, *Handle(Geom_BSplineCurve)::DownCast(b), at);
    if (const auto c = Handle(Geom_BezierCurve)::DownCast(a); !c.IsNull())
        return same_poles(*c, *Handle(Geom_BezierCurve)::DownCast(b), at);
    if (const auto c = Handle(Geom_Line)::DownCast(a); !c.IsNull()) {
        const gp_Lin p = c->Lin(), q = Handle(Geom_Line)::DownCast(b)->Lin();
        return at.same(p.Location(), q.Location()) && at.same(p.Direction(), q.Direction());
    }
    if (const auto c = Handle(Geom_Conic)::DownCast(a); !c.IsNull()) {
        const auto d = Handle(Geom_Conic)::DownCast(b);
        const auto p = sizes_of(c), q = sizes_of(d);
        return at.same(c->Position(), d->Position()) && at.same(p[0], q[0]) && at.same(p[1], q[1]);
    }
    if (const auto c = Handle(Geom_TrimmedCurve)::DownCast(a); !c.IsNull()) {
        const auto d = Handle(Geom_TrimmedCurve)::DownCast(b);
        return at.same(c->StartPoint(), d->StartPoint()) && at.same(c->EndPoint(), d->EndPoint()) &&
               same_geometry(c->BasisCurve(), place_a, d->BasisCurve(), place_b, tolerance);
    }
    if (const auto c = Handle(Geom_OffsetCurve)::DownCast(a); !c.IsNull()) {
        const auto d = Handle(Geom_OffsetCurve)::DownCast(b);
        return at.same(c->Offset(), d->Offset()) && at.same(c->Direction(), d->Direction()) &&
               same_geometry(c->BasisCurve(), place_a, d->BasisCurve(), place_b, tolerance);
    }
    return false;
}

bool same_geometry(const Handle(Geom_Surface) & a, const gp_Trsf& place_a, const Handle(Geom_Surface) & b,
                   const gp_Trsf& place_b, double tolerance) {
    if (a.IsNull() || b.IsNull() || a->DynamicType() != b->DynamicType()) return false;
    const Placed at{place_a, place_b, tolerance};
    if (const auto s = Handle(Geom_BSplineSurface)::DownCast(a); !s.IsNull())
        return same_spline(*s, *Handle(Geom_BSplineSurface)::DownCast(b), at);
    if (const auto s = Handle(Geom_BezierSurface)::DownCast(a); !s.IsNull())
        return same_net(*s, *Handle(Geom_BezierSurface)::DownCast(b), at);
    if (const auto s = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(a); !s.IsNull()) {
        const auto t = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(b);
        return at.same(s->Direction(), t->Direction()) &&
               same_geometry(s->BasisCurve(), place_a, t->BasisCurve(), place_b, tolerance);
    }
    if (const auto s = Handle(Geom_SurfaceOfRevolution)::DownCast(a); !s.IsNull()) {
        const auto t = Handle(Geom_SurfaceOfRevolution)::DownCast(b);
        return at.same(s->Axis().Location(), t->Axis().Location()) &&
               at.same(s->Axis().Direction(), t->Axis().Direction()) &&
               same_geometry(s->BasisCurve(), place_a, t->BasisCurve(), place_b, tolerance);
    }
    if (const auto s = Handle(Geom_OffsetSurface)::DownCast(a); !s.IsNull()) {
        const auto t = Handle(Geom_OffsetSurface)::DownCast(b);
        return at.same(s->Offset(), t->Offset()) &&
               same_geometry(s->BasisSurface(), place_a, t->BasisSurface(), place_b, tolerance);
    }
    return false;
}

}  // namespace featuremesh

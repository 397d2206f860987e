// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/curvature.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sizing/face_cover.h"

namespace featuremesh {
namespace {

double circle_size(double curvature, double per_circle) { return 2 * std::numbers::pi / (curvature * per_circle); }

double least_size(const SizingOptions& options, bool is_free_form) {
    return std::max(options.min_size, (is_free_form ? 0.05 : 0.01) * options.size);
}

double cone_floor(const TopoDS_Face& face, const BRepAdaptor_Surface& cone, double per_circle) {
    std::array<double, 2> u, v;
    BRepTools::UVBounds(face, u[0], u[1], v[0], v[1]);
    double curvature = no_size;
    for (const double at : v)
        if (const double c = surface_point(cone, u[0], at).curvature; c > 0) curvature = std::min(curvature, c);
    return std::isfinite(curvature) && per_circle > 0 ? 0.25 * circle_size(curvature, per_circle) : 0;
}

/// False where the kind of surface tells that the curvature asks for nothing below the size.
bool may_curve_too_much(const BRepAdaptor_Surface& surface, const SizingOptions& options) {
    const auto asks = [&](double radius) {
        return circle_size(1 / radius, options.elements_per_circle) < options.size;
    };
    switch (surface.GetType()) {
        case GeomAbs_Plane:
            return false;
        case GeomAbs_Cylinder:
            return asks(surface.Cylinder().Radius());
        case GeomAbs_Sphere:
            return asks(surface.Sphere().Radius());
        case GeomAbs_Torus: {
            const double big = surface.Torus().MajorRadius(), small = surface.Torus().MinorRadius();
            return asks(small) || asks(std::max(1e-9, std::abs(big - small)));
        }
        default:
            return true;
    }
}

class CurvatureProvider : public SizeProvider {
  public:
    CurvatureProvider(const Brep& brep, const SizingOptions& options) : brep_(brep), options_(options) {}

    EdgeWish on(EdgeId edge) const override {
        if (options_.elements_per_circle <= 0 || brep_.is_degenerated(edge)) return {};
        const GeomAbs_CurveType type = BRepAdaptor_Curve(brep_.edge(edge)).GetType();
        if (type == GeomAbs_Line) return {};
        return [per_circle = options_.elements_per_circle,
                floor = least_size(options_, type > GeomAbs_Circle)](double curvature) {
            return curvature > 0 ? std::max(floor, circle_size(curvature, per_circle)) : no_size;
        };
    }
    FaceWish on(FaceId face) const override {
        if (options_.elements_per_circle <= 0) return {};
        if (!may_curve_too_much(BRepAdaptor_Surface(brep_.face(face), false), options_)) return {};
        return {[per_circle = options_.elements_per_circle,
                 floor = curvature_floor(brep_, face, options_)](const SurfacePoint& p) {
            return p.curvature > 0 ? std::max(floor, circle_size(p.curvature, per_circle)) : no_size;
        }};
    }

  private:
    const Brep& brep_;
    const SizingOptions& options_;
};

}  // namespace

double curvature_floor(const Brep& brep, FaceId face, const SizingOptions& options) {
    const BRepAdaptor_Surface surface(brep.face(face), false);
    const double floor = least_size(options, surface.GetType() >= GeomAbs_BezierSurface);
    if (surface.GetType() != GeomAbs_Cone) return floor;
    return std::max(floor, cone_floor(brep.face(face), surface, options.elements_per_circle));
}

std::unique_ptr<SizeProvider> curvature_provider(const Brep& brep, const SizingOptions& options) {
    return std::make_unique<CurvatureProvider>(brep, options);
}

}  // namespace featuremesh

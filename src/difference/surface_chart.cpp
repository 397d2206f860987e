// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/surface_chart.h"

#include <Extrema_GenLocateExtPS.hxx>
#include <algorithm>
#include <limits>
#include <numbers>

namespace featuremesh {

namespace {
constexpr double two_pi = 2 * std::numbers::pi;
constexpr double straight = 1e300;

double step_on_circle(double radius, double sag) {
    return sag >= radius ? std::numbers::pi / 2 : std::min(std::numbers::pi / 2, 2 * std::acos(1 - sag / radius));
}
/// Largest distance from the axis of a torus over a range of its tube's angle.
double widest_circle(double radius, double tube, double first, double last) {
    double widest = std::max(std::abs(radius + tube * std::cos(first)), std::abs(radius + tube * std::cos(last)));
    for (double top = std::numbers::pi * std::ceil(first / std::numbers::pi); top <= last; top += std::numbers::pi)
        widest = std::max(widest, std::abs(radius + tube * std::cos(top)));
    return std::max(widest, 1e-12);
}
}  // namespace

SurfaceChart::SurfaceChart(const UnderlyingSurface& underlying) : underlying_(underlying) {
    if (underlying.kind != SurfaceKind::free_form) return;
    analysis_ = new ShapeAnalysis_Surface(underlying.surface);
    evaluator_.Load(underlying.surface);
    to_own_ = underlying.placement.Inverted();
}

Vec3 SurfaceChart::point(const Uv& uv) const {
    if (underlying_.kind != SurfaceKind::free_form) return point_at(underlying_, uv[0], uv[1]);
    return to_vec3(evaluator_.Value(uv[0], uv[1]).Transformed(underlying_.placement));
}

void SurfaceChart::scale_for(const UvBox& box) {
    const double r = underlying_.radius;
    switch (underlying_.kind) {
        case SurfaceKind::plane:
            scale_ = {1, 1};
            break;
        case SurfaceKind::cylinder:
            scale_ = {r, 1};
            break;
        case SurfaceKind::cone:
            scale_ = {std::max(std::abs(r + box.low[1] * std::sin(underlying_.second)),
                               std::abs(r + box.high[1] * std::sin(underlying_.second))),
                      1};
            scale_[0] = std::max(scale_[0], 1e-12);
            break;
        case SurfaceKind::sphere:
            scale_ = {r, r};
            break;
        case SurfaceKind::torus:
            scale_ = {widest_circle(r, underlying_.second, box.low[1], box.high[1]), underlying_.second};
            break;
        case SurfaceKind::free_form: {
            constexpr int samples = 12;
            double du = 0, dv = 0;
            for (int i = 0; i <= samples; ++i)
                for (int j = 0; j <= samples; ++j) {
                    const Uv uv = box.at(double(i) / samples, double(j) / samples);
                    gp_Pnt p;
                    gp_Vec u, v;
                    evaluator_.D1(uv[0], uv[1], p, u, v);
                    du = std::max(du, u.Magnitude()), dv = std::max(dv, v.Magnitude());
                }
            scale_ = {std::max(1.2 * du, 1e-12), std::max(1.2 * dv, 1e-12)};
        }
    }
}

double SurfaceChart::period(int direction) const {
    if (underlying_.kind == SurfaceKind::plane) return 0;
    if (underlying_.kind != SurfaceKind::free_form)
        return direction == 0 || underlying_.kind == SurfaceKind::torus ? two_pi : 0;
    if (direction == 0) return evaluator_.IsUPeriodic() ? evaluator_.UPeriod() : 0;
    return evaluator_.IsVPeriodic() ? evaluator_.VPeriod() : 0;
}

bool SurfaceChart::is_pole(const Uv& uv) const {
    if (underlying_.kind == SurfaceKind::sphere) return std::cos(uv[1]) < 1e-7;
    if (underlying_.kind == SurfaceKind::cone)
        return std::abs(underlying_.radius + uv[1] * std::sin(underlying_.second)) < 1e-7;
    return false;
}

void SurfaceChart::start_searches_in(const UvBox& box) {
    constexpr int count = 8;
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
            const Uv uv = box.at((i + 0.5) / count, (j + 0.5) / count);
            starts_.push_back({uv, point(uv)});
        }
}

Uv SurfaceChart::nearest_start(const Vec3& p) const {
    return std::min_element(starts_.begin(), starts_.end(),
                            [&](const auto& a, const auto& b) {
                                return squared_length(a.second - p) < squared_length(b.second - p);
                            })
        ->first;
}

// Gauss and Newton's way, since the point is on the surface: no second derivatives. Parameters stay a little off the
// surface's ends, for there the kernel evaluates without its cached polynomials.
std::optional<Uv> SurfaceChart::descend(const gp_Pnt& own, Uv uv) const {
    constexpr int most_steps = 12;
    constexpr double off_ends = 1e-8, on_it = 1e-8, near_it = 1e-5;  // share of the range; mm
    const double first[] = {evaluator_.FirstUParameter(), evaluator_.FirstVParameter()},
                 last[] = {evaluator_.LastUParameter(), evaluator_.LastVParameter()};
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < most_steps; ++step) {
        for (int k = 0; k < 2; ++k) {
            if (period(k) > 0) continue;  // it goes on beyond its range
            const double slack = off_ends * (last[k] - first[k]);
            uv[k] = std::clamp(uv[k], first[k] + slack, last[k] - slack);
        }
        gp_Pnt at;
        gp_Vec du, dv;
        evaluator_.D1(uv[0], uv[1], at, du, dv);
        const gp_Vec rest(at, own);
        const double away = rest.Magnitude();
        if (away <= on_it || (away <= near_it && away > 0.5 * before)) return uv;
        const double uu = du.Dot(du), u_v = du.Dot(dv), vv = dv.Dot(dv), determinant = uu * vv - u_v * u_v;
        if (!(determinant > 1e-12 * uu * vv)) return std::nullopt;
        const double ru = du.Dot(rest), rv = dv.Dot(rest);
        uv[0] += (vv * ru - u_v * rv) / determinant;
        uv[1] += (uu * rv - u_v * ru) / determinant;
        before = away;
    }
    return std::nullopt;
}

// The kernel's search from nothing looks at a grid over all of the surface for every point: it is the last resort.
std::optional<Uv> SurfaceChart::search(const Vec3& p, const Uv& start) const {
    constexpr double near_it = 1e-4;  // mm
    const gp_Pnt own = to_pnt(p).Transformed(to_own_);
    if (const auto uv = descend(own, start)) return uv;
    Extrema_GenLocateExtPS local(evaluator_);
    local.Perform(own, start[0], start[1]);
    if (local.IsDone() && local.SquareDistance() <= near_it * near_it) {
        Uv uv;
        local.Point().Parameter(uv[0], uv[1]);
        return uv;
    }
    const gp_Pnt2d found = analysis_->ValueOfUV(own, 1e-6);
    const Uv uv{found.X(), found.Y()};
    return distance(point(uv), p) > near_it ? std::nullopt : std::optional(uv);
}

std::optional<Uv> SurfaceChart::parameters(const Vec3& p, const std::optional<Uv>& previous) const {
    const bool is_free = underlying_.kind == SurfaceKind::free_form;
    const std::optional<Uv> near = is_free && !previous ? nearest_start(p) : previous;
    std::optional<Uv> uv = is_free ? search(p, *near) : parameters_of(underlying_, p);
    if (!uv || !near) return uv;
    if (is_pole(*uv)) (*uv)[0] = (*near)[0];
    for (int k = 0; k < 2; ++k)
        if (const double full = period(k); full > 0) (*uv)[k] += full * std::round(((*near)[k] - (*uv)[k]) / full);
    return uv;
}

Uv SurfaceChart::step_for_sag(double sag) const {
    switch (underlying_.kind) {
        case SurfaceKind::plane:
            return {straight, straight};
        case SurfaceKind::cylinder:
        case SurfaceKind::cone:
            return {step_on_circle(scale_[0], sag), straight};
        case SurfaceKind::sphere:
            return {step_on_circle(underlying_.radius, sag / 2), step_on_circle(underlying_.radius, sag / 2)};
        case SurfaceKind::torus:
            return {step_on_circle(scale_[0], sag / 2), step_on_circle(underlying_.second, sag / 2)};
        case SurfaceKind::free_form:
            break;
    }
    return {straight, straight};
}

}  // namespace featuremesh

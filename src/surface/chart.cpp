// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/chart.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "brep/occt_geometry.h"

namespace featuremesh {

namespace {

using Uv = std::array<double, 2>;

/// A growing, piecewise linear function of one surface parameter: the arc length along it, averaged over the other
/// parameter.
class Stretch {
  public:
    /// `speed[i]` is the derivative on the i-th of equal intervals of [first, last].
    void set(double first, double last, std::vector<double> speed) {
        first_ = first, step_ = (last - first) / static_cast<double>(speed.size());
        speed_ = std::move(speed);
        sum_.assign(1, 0);
        for (const double s : speed_) sum_.push_back(sum_.back() + s * step_);
    }
    double forward(double u) const {
        const std::size_t i = interval(u);
        return sum_[i] + speed_[i] * (u - first_ - static_cast<double>(i) * step_);
    }
    double back(double x) const {
        const auto above = std::upper_bound(sum_.begin() + 1, sum_.end() - 1, x);
        const std::size_t i = static_cast<std::size_t>(above - sum_.begin()) - 1;
        return first_ + static_cast<double>(i) * step_ + (x - sum_[i]) / speed_[i];
    }
    double slope(double u) const { return speed_[interval(u)]; }

  private:
    std::size_t interval(double u) const {
        const double i = std::floor((u - first_) / step_);
        return static_cast<std::size_t>(std::clamp(i, 0.0, static_cast<double>(speed_.size() - 1)));
    }
    double first_ = 0, step_ = 1;
    std::vector<double> speed_, sum_;
};

enum class Kind { plane, cylinder, cone, stretched };

double mid(double a, double b) { return 0.5 * (a + b); }

}  // namespace

struct Chart::Data {
    BRepAdaptor_Surface surface;
    Kind kind = Kind::stretched;
    bool reversed = false, isometric = true;
    double u_min = 0, u_max = 0, v_min = 0, v_max = 0;  ///< of the face's trim
    double u_period = 0, v_period = 0;
    double radius = 0;  ///< cylinder
    double apex = 0, sine = 0, nappe = 1, turn = 0,
           slant = 0;  ///< cone: v of the apex, |sin|, which nappe, middle u, length
    Stretch u_stretch, v_stretch;

    explicit Data(const TopoDS_Face& face) : surface(face, Standard_False) {
        reversed = face.Orientation() == TopAbs_REVERSED;
        BRepTools::UVBounds(face, u_min, u_max, v_min, v_max);
        u_period = surface.IsUPeriodic() ? surface.UPeriod() : 0;
        v_period = surface.IsVPeriodic() ? surface.VPeriod() : 0;
        switch (surface.GetType()) {
            case GeomAbs_Plane:
                kind = Kind::plane;
                break;
            case GeomAbs_Cylinder:
                kind = Kind::cylinder, radius = surface.Cylinder().Radius();
                break;
            case GeomAbs_Cone:
                make_cone();
                break;
            default:
                make_stretched();
        }
    }

    void make_cone() {
        kind = Kind::cone;
        const gp_Cone cone = surface.Cone();
        const double signed_sine = std::sin(cone.SemiAngle());
        apex = -cone.RefRadius() / signed_sine;
        sine = std::abs(signed_sine);
        nappe = mid(v_min, v_max) > apex ? 1 : -1;
        turn = mid(u_min, u_max);
        // At the apex a triangle of the developed plane may span half the cone and more: there only lengths in space
        // tell.
        const double nearest = std::min(std::abs(v_min - apex), std::abs(v_max - apex));
        isometric = nearest > 1e-3 * (v_max - v_min);
        slant = std::max(std::abs(v_min - apex), std::abs(v_max - apex));
    }

    void make_stretched() {
        const bool is_even = surface.GetType() == GeomAbs_Sphere || surface.GetType() == GeomAbs_Torus;
        const int intervals = is_even ? 1 : 32, lines = 8;
        const auto speeds = [&](bool along_u) {
            std::vector<double> speed(static_cast<std::size_t>(intervals), 0);
            for (int i = 0; i < intervals; ++i)
                for (int j = 0; j < lines; ++j) {
                    const double a = (i + 0.5) / intervals, b = (j + 0.5) / lines;
                    gp_Pnt p;
                    gp_Vec du, dv;
                    surface.D1(u_min + (along_u ? a : b) * (u_max - u_min), v_min + (along_u ? b : a) * (v_max - v_min),
                               p, du, dv);
                    speed[static_cast<std::size_t>(i)] += (along_u ? du : dv).Magnitude() / lines;
                }
            // A floor keeps the map one to one where the surface is singular along a whole line.
            const double largest = *std::max_element(speed.begin(), speed.end());
            for (double& s : speed) s = std::max(s, largest > 0 ? 1e-3 * largest : 1.0);
            return speed;
        };
        u_stretch.set(u_min, u_max, speeds(true));
        v_stretch.set(v_min, v_max, speeds(false));
        isometric = measure_isometry();
    }

    bool measure_isometry() const {
        constexpr int n = 9;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double u = u_min + (i + 0.5) / n * (u_max - u_min), v = v_min + (j + 0.5) / n * (v_max - v_min);
                gp_Pnt p;
                gp_Vec du, dv;
                surface.D1(u, v, p, du, dv);
                du /= u_stretch.slope(u), dv /= v_stretch.slope(v);
                const double e = du.SquareMagnitude(), g = dv.SquareMagnitude(), f = du * dv;
                if (std::abs(e - 1) > 0.06 || std::abs(g - 1) > 0.06 || std::abs(f) > 0.03) return false;
            }
        return true;
    }
};

Chart::Chart(const Brep& brep, FaceId face) : data_(std::make_unique<Data>(brep.face(face))) {}
Chart::~Chart() = default;
Chart::Chart(Chart&&) noexcept = default;

Vec2 Chart::to_plane(std::array<double, 2> uv) const {
    const Data& d = *data_;
    switch (d.kind) {
        case Kind::plane:
            return {uv[0], uv[1]};
        case Kind::cylinder:
            return {d.radius * uv[0], uv[1]};
        case Kind::cone: {
            const double s = d.nappe * (uv[1] - d.apex), angle = (uv[0] - d.turn) * d.sine;
            return {d.nappe * s * std::sin(angle), s * std::cos(angle)};
        }
        default:
            return {d.u_stretch.forward(uv[0]), d.v_stretch.forward(uv[1])};
    }
}

std::array<double, 2> Chart::to_uv(Vec2 p) const {
    const Data& d = *data_;
    switch (d.kind) {
        case Kind::plane:
            return {p.x, p.y};
        case Kind::cylinder:
            return {p.x / d.radius, p.y};
        case Kind::cone: {
            const double angle = std::atan2(d.nappe * p.x, p.y);
            return {d.turn + angle / d.sine, d.apex + d.nappe * std::hypot(p.x, p.y)};
        }
        default:
            return {d.u_stretch.back(p.x), d.v_stretch.back(p.y)};
    }
}

Vec3 Chart::point(Vec2 p) const {
    const auto uv = to_uv(p);
    return to_vec3(data_->surface.Value(uv[0], uv[1]));
}

Chart::Frame Chart::frame(Vec2 p) const {
    const Data& d = *data_;
    const auto uv = to_uv(p);
    gp_Pnt q;
    gp_Vec du, dv;
    d.surface.D1(uv[0], uv[1], q, du, dv);
    const Vec3 su = to_vec3(du), sv = to_vec3(dv);
    switch (d.kind) {
        case Kind::plane:
            return {to_vec3(q), su, sv};
        case Kind::cylinder:
            return {to_vec3(q), su / d.radius, sv};
        case Kind::cone: {
            // Unit vectors around and along; d(angle) = d(u) sine and the slant length is the radius in the plane.
            const double s = std::hypot(p.x, p.y);
            // At the apex there is no direction around; what rounding leaves of it may even point backwards.
            if (s < 1e-9 * d.slant) return {to_vec3(q), Vec3{}, sv};
            const Vec3 around = su / (s * d.sine), along = d.nappe * sv;
            const double c = p.y / s, n = d.nappe * p.x / s;
            return {to_vec3(q), d.nappe * (c * around + n * along), c * along - n * around};
        }
        default:
            return {to_vec3(q), su / d.u_stretch.slope(uv[0]), sv / d.v_stretch.slope(uv[1])};
    }
}

bool Chart::is_isometric() const { return data_->isometric; }
bool Chart::is_plane() const { return data_->kind == Kind::plane; }
double Chart::cone_sine() const { return data_->kind == Kind::cone ? data_->sine : 0; }
bool Chart::is_reversed() const { return data_->reversed; }

std::array<double, 2> Chart::in_trim_period(std::array<double, 2> uv) const {
    const Data& d = *data_;
    const auto shifted = [](double x, double period, double wanted) {
        return period > 0 ? x + period * std::round((wanted - x) / period) : x;
    };
    return {shifted(uv[0], d.u_period, mid(d.u_min, d.u_max)), shifted(uv[1], d.v_period, mid(d.v_min, d.v_max))};
}

}  // namespace featuremesh

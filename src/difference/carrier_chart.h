// SPDX-License-Identifier: GPL-3.0-or-later
// The parameter plane of a carrier, scaled so that a distance in it is no shorter than in space.
#pragma once

#include <ShapeAnalysis_Surface.hxx>
#include <array>
#include <optional>

#include "difference/carriers.h"

namespace featuremesh {

using Uv = std::array<double, 2>;

/// Rectangle in the parameter plane.
struct UvBox {
    Uv low{1e300, 1e300}, high{-1e300, -1e300};
    bool is_empty() const { return low[0] > high[0]; }
    void add(const Uv& p) {
        for (int k = 0; k < 2; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
    double size(int k) const { return high[k] - low[k]; }
    Uv at(double s, double t) const { return {low[0] + s * size(0), low[1] + t * size(1)}; }
};

class CarrierChart {
  public:
    explicit CarrierChart(const SurfaceCarrier& carrier);

    const SurfaceCarrier& carrier() const { return carrier_; }
    /// Sets how much longer than in space a unit of either parameter may be, for the part of the plane that is used.
    void scale_for(const UvBox& box);
    Uv scale() const { return scale_; }
    double period(int direction) const;
    /// Parameters of a point on the carrier, near `previous` where they are not unique; nothing when the point is not
    /// on it.
    std::optional<Uv> parameters(const Vec3& p, const std::optional<Uv>& previous) const;
    Vec3 point(const Uv& uv) const { return point_at(carrier_, uv[0], uv[1]); }
    /// Longest parameter step whose chord leaves the carrier by no more than `sag`, mm; huge along straight lines
    /// and on free-form carriers, where only the points themselves tell.
    Uv step_for_sag(double sag) const;

  private:
    bool is_pole(const Uv& uv) const;

    SurfaceCarrier carrier_;
    Handle(ShapeAnalysis_Surface) analysis_;
    gp_Trsf to_own_;
    Uv scale_{1, 1};
};

}  // namespace featuremesh

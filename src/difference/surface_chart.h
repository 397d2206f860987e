// SPDX-License-Identifier: GPL-3.0-or-later
// The parameter plane of an underlying surface, scaled so that a distance in it is no shorter than in space.
#pragma once

#include <GeomAdaptor_Surface.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/geometry.h"
#include "difference/underlying_geometry.h"

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

class SurfaceChart {
  public:
    explicit SurfaceChart(const UnderlyingSurface& underlying);

    const UnderlyingSurface& underlying() const { return underlying_; }
    /// Sets how much longer than in space a unit of either parameter may be, for the part of the plane that is used.
    void scale_for(const UvBox& box);
    Uv scale() const { return scale_; }
    double period(int direction) const;
    /// For a free-form underlying surface, before anything is asked of it: where searches for parameters start when
    /// nothing is known.
    void start_searches_in(const UvBox& box);
    /// Parameters of a point on the underlying surface, near `previous` where they are not unique; nothing when the
    /// point is not on it.
    std::optional<Uv> parameters(const Vec3& p, const std::optional<Uv>& previous) const;
    /// Quick where one point follows another nearby, also on a free-form underlying surface.
    Vec3 point(const Uv& uv) const;
    /// Longest parameter step whose chord leaves the underlying surface by no more than `sag`, mm; huge along straight
    /// lines and on free-form underlying surfaces, where only the points themselves tell.
    Uv step_for_sag(double sag) const;

  private:
    bool is_pole(const Uv& uv) const;
    Uv nearest_start(const Vec3& p) const;
    std::optional<Uv> search(const Vec3& p, const Uv& start) const;
    std::optional<Uv> descend(const gp_Pnt& own, Uv uv) const;

    UnderlyingSurface underlying_;
    Handle(ShapeAnalysis_Surface) analysis_;
    GeomAdaptor_Surface evaluator_;  ///< remembers the polynomial of the patch that was asked for last
    gp_Trsf to_own_;
    std::vector<std::pair<Uv, Vec3>> starts_;
    Uv scale_{1, 1};
};

}  // namespace featuremesh

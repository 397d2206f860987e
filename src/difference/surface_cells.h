// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of the parameter plane as triangles in space.
#pragma once

#include <array>
#include <vector>

#include "core/geometry.h"
#include "difference/cell_strips.h"
#include "difference/feature_difference.h"
#include "difference/surface_chart.h"
#include "difference/trim_difference.h"

namespace featuremesh {

/// References stay in use. Triangles are no further from the underlying surface than a quarter of the resolution.
class SurfaceCells {
  public:
    SurfaceCells(const SurfaceChart& chart, const Resolution& resolution, std::vector<SpaceTriangle>& triangles)
        : chart_(chart), resolution_(resolution), triangles_(triangles) {}

    /// What is added lies in this part of the plane, for which the chart has its scale.
    void begin_in(const UvBox& root);
    void add(const UvBox& cell);
    /// What is between a height of the strip and the next one; not on free-form underlying surfaces.
    void add_between(const CellStrip& strip, std::size_t height);
    /// As triangles without area; likewise.
    void add_line(const UvLine& line);

  private:
    /// Corners in the order (0, 0), (1, 0), (1, 1), (0, 1).
    using Corners = std::array<Vec3, 4>;
    struct Look {
        Vec3 place;
        double resolution;
    };

    void add_free_form(const UvBox& cell);
    void add_free_form(const UvBox& cell, const Corners& corners, Look look, int depth);
    void add_quadrilateral(const Corners& corners);
    void add_triangle(const Vec3& a, const Vec3& b, const Vec3& c);
    int parts_of(double size, std::size_t direction) const;

    const SurfaceChart& chart_;
    const Resolution& resolution_;
    std::vector<SpaceTriangle>& triangles_;
    Uv step_{};
    double least_free_form_cell_ = 0;
};

}  // namespace featuremesh

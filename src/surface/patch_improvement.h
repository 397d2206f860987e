// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the triangles of a face near-equilateral on the surface.
#pragma once

#include "core/geometry.h"
#include "surface/chart.h"
#include "surface/heartbeat.h"
#include "surface/triangle_patch.h"

namespace featuremesh {

/// The way from the chart's plane to the places where lengths are measured, and back.
class PatchGeometry {
  public:
    explicit PatchGeometry(const Chart& chart) : chart_(chart), is_flat_(chart.is_isometric()) {}
    bool is_flat() const { return is_flat_; }
    Vec3 place(Vec2 p) const { return is_flat_ ? Vec3{p.x, p.y, 0} : chart_.point(p); }
    /// The step in the chart that comes nearest to the step in space; zero where the surface is singular.
    Vec2 step(Vec2 p, const Vec3& d) const;
    const Chart& chart() const { return chart_; }

  private:
    const Chart& chart_;
    bool is_flat_;
};

/// 4 sqrt(3) A / (sum of squared sides): 1 for the equilateral triangle, 0 for a flat one.
double triangle_quality(const Vec3& a, const Vec3& b, const Vec3& c);
/// Smallest angle, radians.
double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c);

/// Turns sides until each is locally Delaunay as measured on the surface.
void make_delaunay(TrianglePatch& patch);
/// Splits inner sides that are much longer than wanted. False where there would be no end of them: the surface is far
/// larger than its border encloses.
bool split_long_sides(TrianglePatch& patch, const PatchGeometry& geometry, const Heartbeat& heart);
/// The variational step, node by node: each goes to the area-weighted mean of the circumcentres of its star (Chen and
/// Holst 2011), as long as that does not make a bad star worse; sides are turned in between. Only nodes with something
/// to gain are visited.
void smooth(TrianglePatch& patch, const PatchGeometry& geometry, const Heartbeat& heart);
/// Splits triangles that stand across the surface: normals more than about 75 degrees off, as coarse chains on a
/// strongly curved face give. Returns how many.
std::size_t split_folded(TrianglePatch& patch, const PatchGeometry& geometry, const Heartbeat& heart);
/// Triangles with an angle below the given one, worst first: turns, moves, removals and splits, each only when the
/// smallest angle around grows. Beside a piece of an edge that is far shorter than wanted, and shorter than
/// `least_length`, triangles stay needles.
void raise_smallest_angles(TrianglePatch& patch, const PatchGeometry& geometry, double wanted_angle,
                           double least_length, const Heartbeat& heart);

}  // namespace featuremesh

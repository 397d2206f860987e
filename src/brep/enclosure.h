// SPDX-License-Identifier: GPL-3.0-or-later
// Where points are: inside a volume, in which solid, near which other points.
#pragma once

#include <TopoDS_Shape.hxx>
#include <memory>
#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"

namespace featuremesh {

/// A triangulation of the shape's faces but those drawn into it, coarse where they are flat; the shape itself stays
/// without one.
std::vector<std::array<Vec3, 3>> triangulate(const TopoDS_Shape& shape);

/// The inside of some volumes, which may overlap, by their triangulation: quick, and wrong only within the
/// triangulation's deflection of the boundary.
class Enclosure {
  public:
    explicit Enclosure(const std::vector<TopoDS_Shape>& volumes);
    bool contains(const Vec3& p) const;

  private:
    struct Triangle {
        Vec3 a, b, c;
        std::uint32_t volume;
    };
    Box box_;
    double pitch_ = 1;
    std::size_t columns_ = 0, rows_ = 0;
    std::vector<Triangle> triangles_;  // those of a volume lie together, in each column, too
    std::vector<std::vector<std::uint32_t>> columns_triangles_;
};

/// Which solid a point is in, exactly.
class SolidLocator {
  public:
    explicit SolidLocator(const Brep& brep);
    ~SolidLocator();
    /// None outside or on the boundary. `may_be`: by solid, not to be looked at where 0 (empty: all are).
    SolidId solid_at(const Vec3& p, std::span<const char> may_be = {}) const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

/// Points in buckets.
class PointGrid {
  public:
    PointGrid(std::vector<Vec3> points, double spacing);
    /// Whether a point is closer to p than `radius` (at most the spacing).
    bool has_within(const Vec3& p, double radius) const;

  private:
    std::array<std::int64_t, 3> bucket_of(const Vec3& p) const;
    std::vector<Vec3> points_;  // sorted by bucket
    std::vector<std::array<std::int64_t, 3>> buckets_;
    double spacing_;
};

}  // namespace featuremesh

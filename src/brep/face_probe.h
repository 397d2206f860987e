// SPDX-License-Identifier: GPL-3.0-or-later
// Points against one face: on its surface, inside its trim.
#pragma once

#include <TopoDS_Face.hxx>
#include <memory>
#include <optional>

#include "core/geometry.h"

namespace featuremesh {

constexpr double boolean_tolerance =
    1e-5;                              ///< mm: how closely the kernel's booleans and repairs keep a face on its surface
constexpr double same_normal = 0.999;  ///< cosine: faces that touch there, and do not cross

/// Questions to one face; what they need is made when first needed and kept. Not for concurrent use.
class FaceProbe {
  public:
    explicit FaceProbe(const TopoDS_Face& face);
    ~FaceProbe();
    FaceProbe(FaceProbe&&) noexcept;
    FaceProbe& operator=(FaceProbe&&) noexcept;

    const Box& box() const;
    /// Distance from p to the untrimmed surface, mm.
    double distance_to_surface(const Vec3& p) const;
    /// Closer than `tolerance` to the surface and inside the trim (its border counts).
    bool contains(const Vec3& p, double tolerance) const;
    /// Whether parameters of the surface are inside the trim (its border counts).
    bool contains(double u, double v) const;
    /// Unit normal out of the material that the oriented face bounds, at the surface point nearest to p; zero at a
    /// pole.
    Vec3 normal_at(const Vec3& p) const;
    /// See point_on(); computed once.
    const std::optional<Vec3>& inner_point() const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// The six motions of a rigid body.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/geometry.h"

namespace featuremesh {

/// Three ways along the axes and three turns about them through the middle of some points, which turn what is farthest
/// from there by as much as the others move.
class RigidMotions {
  public:
    static constexpr std::size_t count = 6;
    using Six = std::array<double, count>;

    explicit RigidMotions(std::span<const Vec3> points);

    /// How far each motion moves a point along an axis.
    Six along(int axis, const Vec3& point) const;

    /// How far the motions together, by so much each, move a point.
    Vec3 moved(const Six& by, const Vec3& point) const;

    /// What forces at points are for each motion: their sum, and their moment about the middle.
    void add_force(const Vec3& force, const Vec3& point, Six& sums) const;

  private:
    Vec3 place(const Vec3& point) const { return (point - middle_) / radius_; }

    Vec3 middle_;
    double radius_ = 0;
};

/// Cholesky's of a symmetric matrix of six by six. A motion that is resisted next to nothing beside the ones before it
/// is one of these, and takes no part.
class SixFactor {
  public:
    using Six = RigidMotions::Six;
    using Square = std::array<Six, RigidMotions::count>;

    SixFactor() = default;
    explicit SixFactor(const Square& matrix);
    Six solve(Six right) const;

  private:
    Square factor_{};  // lower
};

}  // namespace featuremesh

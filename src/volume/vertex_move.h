// SPDX-License-Identifier: GPL-3.0-or-later
// Where a vertex makes the worst tet of its star the least flat.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "volume/tet_complex.h"

namespace featuremesh {

/// The triangles a point sees, each with positive volume (point, a, b, c). Also the outside of a cavity that is filled
/// from one point.
class StarShape {
  public:
    void clear() { faces_.clear(), is_on_boundary_ = false; }
    void add(const Vec3& a, const Vec3& b, const Vec3& c, const std::array<bool, 3>& is_on_boundary = {}) {
        faces_.push_back({{a, b, c}, is_on_boundary});
    }
    /// The point has its place on the boundary. Of needles, which have two corners there, the angle that these force
    /// does not count (`unforced_flatness`).
    void set_on_boundary(bool is_on_boundary) { is_on_boundary_ = is_on_boundary; }
    void gather(const TetComplex& complex, std::span<const int> star, int vertex);
    std::size_t size() const { return faces_.size(); }

    /// Flatness of the worst tet; stops early, with some value >= limit, once it reaches `limit`.
    double worst(const Vec3& point, double limit) const;

    /// Sum of the tets' burdens.
    double burden(const Vec3& point, double target) const;
    /// The same with the squares of the sines, so that the worst tets count more.
    double steep_burden(const Vec3& point, double target) const;

    /// Sum of the tets' radius ratios 3 r / R, and the way in which it grows; without volume a tet adds nothing.
    struct Ratios {
        double sum = 0;
        Vec3 gradient{};
    };
    Ratios radius_ratios(const Vec3& point) const;
    double sum_of_radius_ratios(const Vec3& point) const;

    /// Mean distance from the point.
    double mean_height(const Vec3& point) const;

    /// Deterministic hill climbing from `point`, which is moved; gives the flatness of the worst tet there. Stops at
    /// `good_enough`.
    double climb(Vec3& point, double good_enough) const;

  private:
    struct Face {
        std::array<Vec3, 3> corners;
        std::array<bool, 3> is_on_boundary;
    };
    double flatness_at(const Vec3& point, const Face& face) const;

    bool is_on_boundary_ = false;
    // the triangle that refused last is the likeliest to refuse again and moves to the front: results do not depend on
    // the order
    mutable std::vector<Face> faces_;
};

}  // namespace featuremesh

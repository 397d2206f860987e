// SPDX-License-Identifier: GPL-3.0-or-later
// How thick the material is below a point of the boundary.
#pragma once

#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"

namespace featuremesh {

/// Rays against a coarse triangulation of the part; the triangulation is a copy, the part's own shape is not touched.
class WallRays {
  public:
    /// `deflection` in mm: how far the triangles may be off the faces.
    WallRays(const Brep& brep, double deflection);

    /// Distance from a point of `face` along `direction` (unit, into the material) to the opposite wall, at most
    /// `limit`. Faces that share an edge with `face` are no opposite wall: in a wedge the distance would go to zero.
    double thickness(FaceId face, const Vec3& point, const Vec3& direction, double limit) const;

  private:
    struct Triangle {
        Vec3 a, b, c;
        FaceId face;
    };
    struct Node {
        Box box;
        std::int32_t first, count;  ///< triangles of a leaf; else the second child and 0
    };
    std::int32_t build(std::size_t begin, std::size_t end);
    bool is_neighbour(FaceId a, FaceId b) const;

    const double diagonal_, deflection_;
    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
    std::vector<std::vector<FaceId>> neighbours_;
    std::vector<bool> is_between_solids_;
};

}  // namespace featuremesh

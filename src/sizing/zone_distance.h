// SPDX-License-Identifier: GPL-3.0-or-later
// How far a point is from a zone.
#pragma once

#include <variant>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "sizing/size_zone.h"
#include "sizing/source_tree.h"

namespace featuremesh {

/// Exact for boxes, spheres and cylinders. Near faces and edges these are covered with balls (face_cover.h), so that it
/// is too short by the radius of a ball at most, which is about the zone's inner size.
class ZoneDistance {
  public:
    ZoneDistance(const Brep& brep, const SizeZone& zone);

    double at(const Vec3& p) const;  ///< mm; 0 inside
    /// Holds the zone; empty where it is near nothing that the part has.
    const Box& box() const { return box_; }

    /// Boxes that hold all points of one zone that are not in the other.
    friend std::vector<Box> where_different(const ZoneDistance& a, const ZoneDistance& b);

  private:
    struct Near {
        SourceTree entities;
        double reach;
    };
    RigidMotion to_zone_;
    std::variant<BoxZone, SphereZone, CylinderZone, Near> shape_;
    Box box_;
};

std::vector<Box> where_different(const ZoneDistance& a, const ZoneDistance& b);

}  // namespace featuremesh

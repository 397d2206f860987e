// SPDX-License-Identifier: GPL-3.0-or-later
// A place of the user's own in which a size is wanted.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"

namespace featuremesh {

/// From a corner at the origin along the axes.
struct BoxZone {
    Vec3 extent;  ///< mm
    bool operator==(const BoxZone&) const = default;
};
/// Around the origin.
struct SphereZone {
    double radius = 0;  ///< mm
    bool operator==(const SphereZone&) const = default;
};
/// Around the z axis, from z = 0 up.
struct CylinderZone {
    double radius = 0, height = 0;  ///< mm
    bool operator==(const CylinderZone&) const = default;
};
/// All that is not further than `reach` from faces, edges or vertices of the final shape.
struct NearZone {
    std::vector<Entity> entities;
    double reach = 0;  ///< mm
    bool operator==(const NearZone&) const = default;
};

/// Inside it the size is `inner` at most; outside it grows with the distance to `outer`, and from there on to the
/// global size as it does everywhere.
struct SizeZone {
    std::string name;       ///< as the user knows it
    RigidMotion placement;  ///< of boxes, spheres and cylinders in the part's space
    std::variant<BoxZone, SphereZone, CylinderZone, NearZone> shape;
    double inner = 0;  ///< mm
    double outer = 0;  ///< mm; 0: the global size
    double transition =
        0;  ///< mm over which it grows to `outer`, longer where the growth asks for that; 0: as the growth
    bool operator==(const SizeZone&) const = default;
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Whether one volume is another one moved, and how.
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

#include "core/geometry.h"
#include "core/message.h"
#include "difference/underlying_geometry.h"

namespace featuremesh {

/// What a volume is known by: points of its edges in the order of its faces, and the underlying surfaces of its faces.
struct VolumeOutline {
    std::vector<Vec3> points;
    std::vector<UnderlyingSurface> faces;
    Box box() const;
};
VolumeOutline outline_of(const TopoDS_Shape& volume);

/// Whether `motion` takes one to the other: every point and every underlying surface of either has its image in the
/// other.
bool is_image(const VolumeOutline& from, const VolumeOutline& to, const RigidMotion& motion, const Sameness& sameness);

/// The rigid motion that takes one to the other: the identity, a shift, the hint, or one derived from corresponding
/// points.
std::optional<RigidMotion> motion_between(const VolumeOutline& from, const VolumeOutline& to, const RigidMotion& hint,
                                          const Sameness& sameness);

bool same_motion(const RigidMotion& a, const RigidMotion& b, const Sameness& sameness);
/// "moved by (5, 0, 0) mm", "turned by 30 deg about (0, 0, 1) and moved by (1, 0, 0) mm".
Message describe(const RigidMotion& motion);

}  // namespace featuremesh

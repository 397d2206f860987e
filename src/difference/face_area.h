// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ids.h"

class TopoDS_Face;

namespace featuremesh {

class BoundaryModel;

/// Area of a face, mm^2. On planes, cylinders, cones, spheres and tori by Green's theorem along its border in the
/// parameter plane, some fifty times faster than the kernel's integration, which serves the other surfaces.
double area_of(const TopoDS_Face& face);
/// The same, in closed form for a plane between lines and circles.
double area_of(const BoundaryModel& model, FaceId face);

}  // namespace featuremesh

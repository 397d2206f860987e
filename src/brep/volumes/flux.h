// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes face by face.
#pragma once

#include "core/geometry.h"

class TopoDS_Face;
class TopoDS_Shape;

namespace featuremesh {

/// Signed volume, mm^3, of the cones from `apex` to the faces of the shape: positive where a face looks away from the
/// apex. Of a closed, oriented shell it is the volume inside, wherever the apex. To about 1e-9 of the cones' size, by
/// adaptive integration along the edges (Green's theorem in the parameter plane; planes in space).
///
/// The kernel's own VolumeProperties is no help here: it puts the apex where it likes, so that its results for open
/// shapes cannot be added, and with spline edges it is off by 1e-5 and more, differently when a face is split.
double flux(const TopoDS_Shape& faces, const Vec3& apex);
/// The same of one face about as wide as `size`, mm, as it is oriented; zero for one that no material ends at.
double flux(const TopoDS_Face& face, const Vec3& apex, double size);

}  // namespace featuremesh

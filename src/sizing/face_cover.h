// SPDX-License-Identifier: GPL-3.0-or-later
// Covers a face with balls of the size that is wanted there.
#pragma once

#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "sizing/size_provider.h"
#include "sizing/source_ball.h"

class BRepAdaptor_Surface;

namespace featuremesh {

/// By the two fundamental forms.
SurfacePoint surface_point(const BRepAdaptor_Surface& surface, double u, double v);

/// Appends the balls; none where nothing below `limit` (mm) is wanted. The face is halved in its parameters until the
/// pieces are about two of the wanted edge lengths long.
void cover_face(const Brep& brep, FaceId face, std::span<const FaceWish> wishes, double limit,
                std::vector<SourceBall>& out);

}  // namespace featuremesh

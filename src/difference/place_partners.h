// SPDX-License-Identifier: GPL-3.0-or-later
// Where the faces, edges and vertices of one shape lie in another one, by place alone.
#pragma once

#include <vector>

#include "core/geometry.h"
#include "core/ids.h"
#include "difference/feature_difference.h"

namespace featuremesh {

struct PlacePartners {
    std::vector<std::vector<FaceId>> faces;  ///< by FaceId of the first shape: all of the second that overlap it
    std::vector<std::vector<EdgeId>> edges;  ///< likewise
    std::vector<VertexId> vertices;          ///< none where the second shape has no vertex there
};

/// Of two states of one part on the way to its final shape, such as before and after a pocket.
PlacePartners partners_in_place(const Brep& from, const Brep& to);

/// What became of every face by place alone, where the motion takes the first shape to the second one's place.
std::vector<FaceChange> faces_in_place(const Brep& from, const Brep& to, const RigidMotion& motion);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces of the new final shape an old one is now: by the feature and by what made it, not by its place alone.
#pragma once

#include <string>
#include <vector>

#include "core/ids.h"
#include "difference/feature_difference.h"
#include "difference/made_faces.h"

namespace featuremesh {

/// How it was told: by what made the face (sketch element, lateral face of the sweep, instance of the pattern), by its
/// place, or by the faces around it.
enum class FollowedBy { nothing, origin, place, neighbours };
std::string to_string(FollowedBy by);

struct FollowedFace {
    FaceId old_face;
    std::vector<FaceId> new_faces;  ///< ascending; several where it was split, none where it is gone or cannot be told
    FollowedBy by = FollowedBy::nothing;
    std::vector<FaceId> within;  ///< pieces that came to lie between two solids, where only one was beside the old face
};

/// For every face of the old final shape. Sketch elements tell what others have no name for; without them less is told.
std::vector<FollowedFace> follow_faces(const PartState& old_state, const SketchElements& old_elements,
                                       const PartState& new_state, const SketchElements& new_elements);

}  // namespace featuremesh

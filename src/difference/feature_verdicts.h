// SPDX-License-Identifier: GPL-3.0-or-later
// What happened to each feature, by its own volumes first and by its faces in the final shape then.
#pragma once

#include "core/geometry.h"
#include "difference/feature_difference.h"
#include "difference/underlying_geometry.h"

namespace featuremesh {

/// A motion with the features that made it; everything a carried region starts from.
struct MovedFeatures {
    RigidMotion motion;
    std::vector<std::string> features;
    std::vector<TopoDS_Shape> additive_volumes;  ///< as they were
    Box new_place;                               ///< of all volumes that moved
};

struct FeatureVerdicts {
    std::vector<FeatureChange> changes;  ///< in the order of the new tree, removed features where they were
    std::vector<MovedFeatures> moved;    ///< distinct motions in the order of the features
    bool everything_moved = false;       ///< by the first of `moved`
};

/// By the features' own volumes alone.
FeatureVerdicts compare_features(const PartState& old_state, const PartState& new_state, const Sameness& sameness);

/// Names the concerned faces and finds the features whose own volume is the same while their faces are not.
void add_face_verdicts(const PartState& old_state, const PartState& new_state, const std::vector<FaceChange>& faces,
                       std::vector<FeatureChange>& changes);

}  // namespace featuremesh

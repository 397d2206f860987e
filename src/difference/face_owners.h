// SPDX-License-Identifier: GPL-3.0-or-later
// Who owns the faces of a part: the cells know it where there are any, points on the faces tell it elsewhere.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cells/cell_model.h"
#include "core/ids.h"
#include "difference/feature_difference.h"
#include "difference/volume_faces.h"

namespace featuremesh {

/// Of one state. Answers without cells are found when they are asked for, and the same whenever that is. Not for
/// concurrent use.
class FaceOwners {
  public:
    explicit FaceOwners(const PartState& state);
    /// Sorted; a face on which no volume has one may be any feature's.
    std::vector<Owner> of(FaceId face) const;
    /// Only those of the features that are marked; none where they are others.
    std::vector<Owner> of(FaceId face, std::span<const char> is_wanted) const;

  private:
    const PartState& state_;
    std::optional<VolumeFaces> by_points_;
};

/// Of all faces, by FaceId.
std::vector<std::vector<Owner>> owners_of_faces(const PartState& state);
/// In the order of the entities, faces and edges: the labels of the features that own it, each once. An edge has the
/// owners of all its faces. None for other entities, and where no feature's volume has the face.
std::vector<std::vector<std::string>> labels_of_owners(const PartState& state, std::span<const Entity> entities);
/// Of all faces, by FaceId: the names of the features that own it, each once.
std::vector<std::vector<std::string>> names_of_owners(const PartState& state);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Tets whose four corners lie on two opposite walls: nothing of them can bend within the wall.
#pragma once

#include <array>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "mesh/mesh.h"
#include "surface/projection.h"

namespace featuremesh {

/// Tells tets between opposite walls: two faces without a common edge that look away from one another.
class OppositeWalls {
  public:
    OppositeWalls(const Brep& brep, const Mesh& mesh);
    /// Whether every node lies on one of two opposite walls, and each wall has a node that is not on the other one. May
    /// be asked by several threads.
    bool are_spanned_by(const std::array<NodeId, 4>& nodes) const;

  private:
    bool are_opposite(FaceId a, NodeId on_a, FaceId b, NodeId on_b) const;
    Vec3 normal(FaceId face, NodeId node) const;

    const Brep& brep_;
    const Mesh& mesh_;
    Projector projector_;
    std::vector<std::vector<FaceId>> neighbours_;  // by face
    mutable std::mutex mutex_;                     // of the projector, and of those that were asked for
    mutable std::map<std::pair<FaceId, NodeId>, Vec3> normals_;
};

}  // namespace featuremesh

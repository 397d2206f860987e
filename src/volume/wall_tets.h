// SPDX-License-Identifier: GPL-3.0-or-later
// Tets whose four corners lie on two opposite walls: nothing of them can bend within the wall.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/run_context.h"
#include "features/brep.h"
#include "mesh/mesh.h"
#include "surface/projection.h"
#include "volume/seam_region.h"
#include "volume/tet_complex.h"

namespace featuremesh {

/// Tells tets between opposite walls: two faces without a common edge that look away from one another.
class OppositeWalls {
  public:
    OppositeWalls(const Brep& brep, const Mesh& mesh, const Projector& projector);
    /// Whether every node lies on one of two opposite walls, and each wall has a node that is not on the other one.
    bool are_spanned_by(const std::array<NodeId, 4>& nodes) const;

  private:
    bool are_opposite(FaceId a, NodeId on_a, FaceId b, NodeId on_b) const;
    Vec3 normal(FaceId face, NodeId node) const;

    const Brep& brep_;
    const Mesh& mesh_;
    const Projector& projector_;
    std::vector<std::vector<FaceId>> neighbours_;  // by face
};

/// Gives every tet that `is_wanted` a new vertex inside, or on the best of its inner edges, which may be moved but not
/// taken out again. Returns their number.
std::size_t split_tets(TetComplex& complex, const std::function<bool(const std::array<int, 4>&)>& is_wanted);

/// Splits the tets of a filled cavity that span opposite walls, and removes slivers there; none that spans them is
/// left. Returns their number.
std::size_t split_wall_tets(SeamRegion& region, const OppositeWalls& walls, double target_dihedral_deg,
                            RunContext& context);

}  // namespace featuremesh

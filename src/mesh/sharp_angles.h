// SPDX-License-Identifier: GPL-3.0-or-later
// Where the CAD shape itself is sharp, so that no mesh of it can have large angles.
#pragma once

#include <cstdint>
#include <vector>

#include "core/ids.h"
#include "mesh/mesh.h"
#include "mesh/short_sides.h"

namespace featuremesh {

/// The CAD edges whose material angle and the face corners whose angle, as meshed, are below `angle_deg` degrees.
class SharpAngles {
  public:
    SharpAngles(const Mesh& mesh, double angle_deg);

    /// The tet touches a sharp edge or corner, spans from one of the two faces at a sharp edge to the other, or has a
    /// side far shorter than the others that the shape forces (ShortSides).
    bool force(TetId tet) const;

  private:
    void find_sharp_segments(double angle_deg);
    void find_sharp_corners(double angle_deg);
    void find_wedge_faces(const std::vector<char>& is_sharp_segment);
    bool lies_on(NodeId node, FaceId face) const;

    const Mesh& mesh_;
    ShortSides short_sides_;
    std::vector<char> is_sharp_node_;
    std::vector<std::pair<FaceId, FaceId>> wedges_;                ///< the faces at each sharp edge, smaller first
    std::vector<std::pair<std::int32_t, std::int32_t>> on_wedge_;  ///< node and wedge face, sorted
};

}  // namespace featuremesh

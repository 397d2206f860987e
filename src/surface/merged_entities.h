// SPDX-License-Identifier: GPL-3.0-or-later
// CAD vertices, edges and faces that are too near one another for any mesh to tell them apart.
#pragma once

#include <string>
#include <vector>

#include "features/brep.h"

namespace featuremesh {

/// Vertices of one solid in the same place within Tolerances::negligible() share a node. Then an edge may be a point,
/// two edges may be one chain (a solid that touches itself along an edge; the long sides of a sliver), and a face whose
/// edges are so in pairs has no triangles.
struct MergedEntities {
    explicit MergedEntities(const Brep& brep);

    std::vector<VertexId> vertex_of;  ///< by vertex: the one that has the node, mostly itself
    std::vector<EdgeId> edge_of;      ///< by edge: the one that has the chain, mostly itself
    std::vector<char> is_point;       ///< by edge: it has no chain
    std::vector<char> is_flat;        ///< by face: it has no triangles

    /// What the user should know of it.
    std::vector<std::string> warnings() const;
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes of CAD entities that are merged with others.
#pragma once

#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "mesh/mesh.h"
#include "surface/merged_entities.h"

namespace featuremesh {

/// A node on a vertex, edge or face that has no elements of its own there.
struct SharedNode {
    Entity entity;
    NodeId node;
};

/// Those of all that is merged, where details below so many mm are ignored, by ascending entity and
/// node: of a vertex, the node that it shares; of an edge, the nodes at its ends and those of other edges along it; of
/// a face without triangles, the nodes of its border. None for an edge or a face that has elements all over.
std::vector<SharedNode> shared_nodes(const Mesh& mesh, const Brep& brep, const MergedEntities& merged,
                                     double ignored_below);

}  // namespace featuremesh

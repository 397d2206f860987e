// SPDX-License-Identifier: GPL-3.0-or-later
// The named invariants of a mesh, used by the program at module exits and by the tests.
#pragma once

#include <vector>

#include "core/dimension.h"
#include "core/ids.h"
#include "core/message.h"
#include "core/run_context.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// What the mesh is checked against; empty vectors are not checked.
struct Expectation {
    Dimension dimension = Dimension::solids;  ///< of the mesh's elements
    std::vector<char> is_free_face;           ///< by FaceId: its triangles are elements beside tets
    std::vector<char> is_free_edge;           ///< by EdgeId: its segments are elements beside tets and triangles
    std::vector<double> solid_volumes;        ///< mm^3, by SolidId
    double volume_tolerance = 0.05;           ///< share; coarse meshes of curved parts cut chords
    std::vector<std::array<SolidId, 2>>
        solids_beside_face;  ///< by FaceId: solid behind (against the normal) and before it, or none
    /// By node: whether an element around it is new or gone. Where a valid mesh was updated, elements without such a
    /// node are as they were, place and neighbours: triangles are compared with tets only where all three nodes are
    /// unproven; 4-node tets and segments are measured, and mid-side nodes and Jacobians looked at, only where one is
    /// (see docs/design/keeping.md). Empty: everything.
    std::vector<char> is_unproven;
    std::vector<TetId> unproven_tets;  ///< all with an unproven node, ascending; none: they are searched for
};

/// Every broken invariant, one message a kind that names nodes, tets and faces; empty for a valid mesh. Checked: sizes
/// of all arrays, ids in range, distinct numbers, positive tets, every triangle in the one or two tets that the solids
/// beside its face say, no boundary of the tets without a triangle, closed boundary per solid, segments on triangles'
/// sides, volumes per solid, mid-side nodes shared by all elements around a side, positive Jacobian of 10-node tets. A
/// mesh of solids without tets is checked as a surface: closed around every solid. Of a mesh of faces, and on faces
/// without solids, triangles have an area, leave no gap in their face but at its edges' segments, and are folded
/// nowhere; a mesh of edges has no triangles, and an edge without faces no gap.
std::vector<Message> broken_invariants(const Mesh& mesh, const Expectation& expected, RunContext& context);
std::vector<Message> broken_invariants(const Mesh& mesh, const Expectation& expected = {});

}  // namespace featuremesh

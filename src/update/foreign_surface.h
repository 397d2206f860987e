// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of another maker's mesh, matched with the vertices, edges and faces of a shape.
#pragma once

#include <vector>

#include "core/geometry.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "update/entity_finder.h"

namespace featuremesh {

struct MatchedTriangle {
    std::array<NodeId, 3> nodes;  ///< right-hand normal that of the face as it is oriented in the shape
    FaceId face;
    std::array<TetId, 2> tets;  ///< behind it and, between two solids, before it
    Number number = 0;          ///< in the foreign mesh, 0 for none
};
struct MatchedSegment {
    std::array<NodeId, 2> nodes;  ///< in the direction of growing edge parameter
    EdgeId edge;
};

/// Why tets of the foreign mesh cannot stay.
struct Misfits {
    std::size_t nodes_off_surface = 0;  ///< on the mesh's boundary and further from the shape's than FreeCAD looks
    std::size_t overlaps = 0;           ///< triangles with more than two tets, or two that overlap there
    std::size_t triangles_on_no_face = 0;
    std::size_t sides_on_no_edge = 0;  ///< where triangles of different faces meet, and not along an edge of theirs
    std::vector<EdgeId> open_edges;    ///< not followed by a chain of sides
    std::vector<FaceId> open_faces;    ///< not covered by triangles
};

/// A mid-side node off the edge or face its side lies on (straight sides on a curved face), and where it would be.
struct MovedMid {
    NodeId node;
    Vec3 point;
};

struct ForeignSurface {
    std::vector<PointPlace> places;  ///< by node; dimension 3 off the boundary
    std::vector<char> is_misfit;     ///< by node: what touches it cannot stay
    std::vector<MatchedTriangle> triangles;
    std::vector<MatchedSegment> segments;
    std::vector<MovedMid> moved_mids;  ///< no misfits: their elements can stay with other mid-side nodes
    Misfits misfits;
};

/// `mesh` has tets of positive volume; what it knows of CAD entities is not looked at. Nodes are on an entity that is
/// no further than `tolerance`.
ForeignSurface match_surface(const Brep& brep, const Mesh& mesh, double tolerance, RunContext& context);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// What bounds the part of a CAD face that is not meshed yet, in the face's chart.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "mesh/mesh.h"
#include "surface/chart.h"
#include "surface/edge_chains.h"

namespace featuremesh {

/// A piece of the boundary, points by their index in FaceBoundary; what is to be filled lies on its left.
struct BoundarySegment {
    int a = 0, b = 0;
    EdgeId edge;            ///< none for the side of a kept triangle
    std::size_t piece = 0;  ///< of the edge's chain
    bool is_pole = false;   ///< part of a degenerated edge: all its points are one node
};

/// The boundary of what is to be filled. A node on a seam has two points, a pole several.
struct FaceBoundary {
    std::vector<Vec2> points;
    std::vector<NodeId> nodes;              ///< by point
    std::vector<BoundarySegment> segments;  ///< closed loops
    std::vector<BoundarySegment> inner;     ///< edges inside the face, to be filled left and right of them
    std::vector<int> lone_points;           ///< inside, without triangles yet: kept nodes, and those of vertices

    bool is_complete() const { return segments.empty(); }
};

/// Throws MeshError that names the face when its loops are not closed in the chart, or the kept triangles do not fit
/// them.
FaceBoundary find_boundary(const Brep& brep, FaceId face, const Chart& chart, const EdgeChains& chains,
                           const Mesh& mesh, std::span<const TriangleId> kept_triangles,
                           std::span<const NodeId> kept_nodes);

}  // namespace featuremesh

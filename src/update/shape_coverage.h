// SPDX-License-Identifier: GPL-3.0-or-later
// Where a mesh's boundary leaves edges and faces of a shape bare, as points on them.
#pragma once

#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "update/foreign_surface.h"

namespace featuremesh {

struct EdgeRange {
    double first, last;  ///< edge parameters
};
EdgeRange range_of(const Brep& brep, EdgeId edge);

/// Appends points of a piece of the edge, both its ends included, not further apart than `spacing`.
void sample_edge(const Brep& brep, EdgeId edge, EdgeRange piece, double spacing, std::vector<Vec3>& points);

/// Appends points not further apart than `spacing` wherever a face has no triangle near, and the faces where that is
/// so.
void sample_open_faces(const Brep& brep, const Mesh& mesh, const std::vector<MatchedTriangle>& triangles,
                       double spacing, std::vector<FaceId>& open, std::vector<Vec3>& points, const RunContext& context);

/// By corner node: the longest side of the tets around it, mm.
std::vector<double> longest_sides(const Mesh& mesh);
/// Mean over all sides of all tets, mm.
double mean_side(const Mesh& mesh);

}  // namespace featuremesh

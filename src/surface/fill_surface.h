// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the CAD edges and faces that are not meshed yet.
#pragma once

#include <string>
#include <vector>

#include "core/run_context.h"
#include "features/brep.h"
#include "mesh/mesh.h"
#include "sizing/sizing_field.h"
#include "surface/merged_entities.h"

namespace featuremesh {

struct SurfaceReport {
    std::size_t new_nodes = 0, new_triangles = 0;
    double min_angle_deg = 180;                 ///< smallest angle of a new triangle
    std::vector<std::string> warnings;          ///< e.g. a face that had to be meshed finer than asked
};

struct SurfaceResult {
    Mesh mesh;
    SurfaceReport report;
};

/// Takes a mesh with kept nodes, segments and triangles (or nothing), 4-node; gives it back in front, bit for bit, with a node on every CAD vertex,
/// a chain of segments on every CAD edge and triangles on every CAD face. Conforming: faces share the nodes of their edges.
/// Throws MeshError that names the face. `known`: of this very shape, where somebody has looked for them.
SurfaceResult fill_surface(const Brep& brep, const SizingField& sizing, Mesh kept, RunContext& context,
                           const MergedEntities* known = nullptr);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the CAD edges and faces that are not meshed yet.
#pragma once

#include <vector>

#include "brep/brep.h"
#include "core/message.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "sizing/sizing_field.h"
#include "surface/merged_entities.h"

namespace featuremesh {

/// What becomes of edges so near one another that their chains, divided each by itself, would cross in a face between
/// them.
enum class NarrowFaces {
    opposite_nodes,  ///< the nodes of both edges opposite one another: long triangles, but few
    shorter,         ///< likewise, with half the length there
    own_chains       ///< pieces are halved until they cross no more
};

struct SurfaceOptions {
    const MergedEntities* known = nullptr;  ///< of this very shape, where somebody has looked for them
    NarrowFaces narrow = NarrowFaces::opposite_nodes;
};

struct SurfaceReport {
    std::size_t new_nodes = 0, new_triangles = 0;
    double min_angle_deg = 180;       ///< smallest angle of a new triangle
    int fillings = 0;                 ///< until nothing crossed, and strips had nodes opposite one another
    bool has_opposite_nodes = false;  ///< another choice of NarrowFaces gives another surface
    bool may_be_halved = false;       ///< so does NarrowFaces::shorter: some chains would cross by themselves
    std::vector<Message> warnings;    ///< e.g. a face that had to be meshed finer than asked
};

/// How much of a mesh there is.
struct MeshExtent {
    std::size_t nodes, segments, triangles;
    Number next_node_number, next_element_number;
};

struct SurfaceResult {
    Mesh mesh;
    SurfaceReport report;
    MeshExtent kept;  ///< what was there before
};
/// What was there before the filling.
Mesh taken_back(SurfaceResult filled);

/// Takes a mesh with kept nodes, segments and triangles (or nothing), 4-node; gives it back in front, bit for bit, with
/// a node on every CAD vertex, a chain of segments on every CAD edge and triangles on every CAD face. Conforming: faces
/// share the nodes of their edges. Throws MeshError that names the face.
SurfaceResult fill_surface(const Brep& brep, const SizingField& sizing, Mesh kept, RunContext& context,
                           const SurfaceOptions& options = {});

}  // namespace featuremesh

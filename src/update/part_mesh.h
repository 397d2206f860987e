// SPDX-License-Identifier: GPL-3.0-or-later
// The main job: a part is meshed, and its mesh is updated.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/dimension.h"
#include "core/geometry.h"
#include "difference/feature_difference.h"
#include "features/feature_tree.h"
#include "features/raw_document.h"
#include "mesh/mesh.h"
#include "sizing/sizing_field.h"
#include "update/made_for.h"
#include "update/options.h"
#include "update/report.h"
#include "update/shared_nodes.h"

namespace featuremesh {

/// A part with its mesh; never changes.
struct PartMesh {
    PartState part;
    RawDocument document;  ///< as read, for the saved state
    MeshOptions options;   ///< as asked, but for the narrow faces that could not be refined
    SizingField sizing;    ///< that the mesh was made with
    Mesh mesh;
    std::vector<std::int32_t> node_origin;  ///< by node: its index in the mesh before the update, -1 for a new one
    std::vector<std::int32_t> tet_origin;   ///< by tet, likewise; by triangle or segment where those fill the part
    std::vector<Vec3> active_points;        ///< start positions that survived without being kept, for pictures
    MadeFor made_for = {};                  ///< what kept nodes were made for, where that is not what is wanted now
    std::vector<SizeSource> adopted_sizes =
        {};  ///< of another maker's mesh that this one comes from: updates go on in its sizes where they are finer
    std::vector<SharedNode> shared_nodes = {};  ///< of what has no elements of its own, as it is too small
};

struct PartMeshResult {
    std::shared_ptr<const PartMesh> part_mesh;
    Report report;
};

/// The feature tree, the final shape and the cells of a document. What features did as in `known`, the tree of another
/// state, is not looked into again. Throws InputError when there is no solid.
PartState read_part(const RawDocument& document, RunContext& context, const FeatureTree* known = nullptr,
                    Dimension dimension = Dimension::from_shape);
/// The same without cells, which a mesh does not need (see cells_without_fuse). `before`: the state before an edit.
PartState read_part_to_mesh(const RawDocument& document, RunContext& context, const PartState* before = nullptr,
                            Dimension dimension = Dimension::from_shape);

/// About how many elements the options ask for: tets, or triangles or segments where those are meshed.
double estimate_part(const RawDocument& document, const MeshOptions& options, RunContext& context);

/// Meshes the part from scratch, with numbers from `next` on.
PartMeshResult mesh_part(RawDocument document, const MeshOptions& options, RunContext& context, NextNumbers next = {});

/// Meshes the new state of the part, keeping what did not change. The old state stays as it is.
PartMeshResult update_part(const PartMesh& old, RawDocument document, const MeshOptions& options, RunContext& context);

/// Makes another maker's mesh of the part ours: what fits the part's shape stays bit for bit with its numbers, the rest
/// is filled anew and reported. Of `foreign` the nodes, tets, numbers and counters count; its triangles and segments
/// only give theirs their numbers. options.order is its order. Where its edges are clearly shorter than the wanted size
/// they are the wanted size from then on, until a mesh is made from scratch. Throws InputError when nothing of it fits,
/// or it has no tets, and for a part without solids.
PartMeshResult adopt_part(RawDocument document, const MeshOptions& options, const Mesh& foreign, RunContext& context);

/// Rebuilds the state of a part whose mesh was saved. Throws StateError when mesh and part do not fit.
std::shared_ptr<const PartMesh> restore_part(RawDocument document, const MeshOptions& options, Mesh mesh,
                                             RunContext& context, MadeFor made_for = {},
                                             std::vector<SizeSource> adopted_sizes = {});

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// What of an old mesh survives in the new state of the part.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "difference/feature_difference.h"
#include "mesh/mesh.h"
#include "sizing/sizing_field.h"
#include "surface/merged_entities.h"
#include "update/made_for.h"
#include "update/report.h"

namespace featuremesh {

/// How what the user asks for compares with what he asked for before.
enum class AskedSizes {
    same,
    same_lengths,  ///< at other entities, or at those of other numbers
    other_lengths,
};
AskedSizes compare_asked_sizes(const SizingOptions& before, const SizingOptions& now);

struct KeepInput {
    const Mesh& old_mesh;
    const Brep& old_brep;
    const Brep& new_brep;
    const FeatureDifference& difference;
    const SizingField& old_sizing;
    const SizingField& new_sizing;
    const MadeFor& made_for;  ///< of the old mesh's nodes
    double margin;            ///< edge lengths between a kept node and the changed boundary
    AskedSizes asked = AskedSizes::same;
    double ignored_below = 0;  ///< mm, as in MeshOptions
};

/// Sides of kept elements that are on the shape, but straight (`StraightSides`).
struct KeptStraightSides {
    std::size_t sides = 0;
    double distance = 0;  ///< mm: no mid-side node is further from the shape
    std::vector<Entity> places;
};

struct Kept {
    /// 4-node: the corner nodes, segments, triangles and tets that stay, on the entities of the new shape, with their
    /// numbers.
    Mesh mesh;
    /// The same as 10-node elements with their old mid-side nodes, where the old mesh is one; else none.
    std::shared_ptr<const Mesh> curved;
    std::vector<std::int32_t> node_origin, segment_origin, triangle_origin, tet_origin;  ///< indices in the old mesh
    std::vector<char> is_rim;     ///< by kept node: a tet around it was not kept
    std::vector<TetId> rim_tets;  ///< kept tets with such a node, ascending
    std::vector<Vec3> active;     ///< inner nodes that only serve as start positions
    std::vector<KeptByMotion> by_motion;
    MadeFor made_for;  ///< of the kept nodes
    KeptStraightSides straight;
    std::shared_ptr<const MergedEntities> merged;  ///< of the new shape; none where nobody has looked for them
};

/// A node stays under a motion when it is further from that motion's changed boundary than `margin` edge lengths, the
/// wanted size there is within a factor of 1.2 (1.01 where the user asks for other lengths) of the one it was made for,
/// and it is verified to lie on its entity of the new shape; of a straight side the point where its node would be. Tets
/// stay when their four nodes do, under one motion, and when their connected region is verified to be inside a new
/// solid; but where nodes go for their size, inner ones beside them that would keep few of their tets keep none. Of
/// what changed only that on its own underlying surface counts for a triangle, so that it may stay without its tet. A
/// solid whose faces are all as they were keeps its mesh, whatever happens in a solid beside it.
Kept keep(const KeepInput& input, RunContext& context);

}  // namespace featuremesh

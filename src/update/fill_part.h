// SPDX-License-Identifier: GPL-3.0-or-later
// The one operation of full meshes and updates alike: fills whatever of a part is not meshed yet.
#pragma once

#include <vector>

#include "core/run_context.h"
#include "features/brep.h"
#include "mesh/mesh.h"
#include "mesh/validation.h"
#include "sizing/sizing_field.h"
#include "surface/fill_surface.h"
#include "update/keep.h"
#include "update/options.h"
#include "volume/fill_solids.h"

namespace featuremesh {

constexpr double elements_that_bend = 2;  ///< across a wall: no tet may span it then

/// What a valid mesh of the part has.
Expectation expectation_of(const Brep& brep);

struct Filled {
    Mesh mesh;
    SurfaceReport surface;
    VolumeReport volume;
    std::vector<TetId> released;
    std::vector<NodeId> moved;
    std::vector<Vec3> used_active;
};

/// What to fill a full mesh from.
Kept nothing_kept(NextNumbers next);

/// Surface, volume, mid-side nodes and validation of all that is not kept. Where elements cannot follow the part, or
/// 10-node tets would be folded, with shorter edges there. Throws MeshError when no valid mesh can be made.
Filled fill_part(const Brep& brep, const SizingField& sizing, Kept kept, MeshOptions options, RunContext& context);

}  // namespace featuremesh

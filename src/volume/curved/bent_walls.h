// SPDX-License-Identifier: GPL-3.0-or-later
// Walls that are thinner than the sides of 10-node tets in them bend.
#pragma once

#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "sizing/sizing_field.h"
#include "surface/projection.h"

namespace featuremesh {

/// Where one wall bends towards the other by so much within a side that no place of the nodes inside helps (a bore
/// close to a face): edge lengths, mm, with which a side would bend by a quarter of the wall's thickness. The tet of
/// the first is in `place`. `mesh` has its mid-side nodes on the shape; tets before `first_tet` are not looked at.
struct BentWalls {
    std::vector<SizeSource> lengths;
    TetId place;
};
BentWalls find_bent_walls(const Brep& brep, const Projector& projector, const Mesh& mesh, std::size_t first_tet,
                          const RunContext& context);

}  // namespace featuremesh

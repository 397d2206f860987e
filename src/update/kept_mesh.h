// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh of what stays, put together from the old one.
#pragma once

#include "update/carried_nodes.h"
#include "update/keep.h"
#include "update/kept_entities.h"
#include "update/kept_surfaces.h"
#include "update/kept_tets.h"
#include "update/kept_triangles.h"

namespace featuremesh {

/// Takes the nodes of kept elements, kept tets, the triangles before them and those of kept surfaces, kept shells and
/// the segments between kept nodes, in their old order, with their numbers. Nothing active yet. `shells`: what stays of
/// free faces and edges; null where there are none.
Kept assemble(const CarriedNodes& nodes, const KeptEntities& entities, const KeptTets& tets,
              const KeptSurfaces& surfaces, const KeptShells* shells, RunContext& context);

}  // namespace featuremesh

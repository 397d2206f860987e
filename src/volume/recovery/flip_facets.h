// SPDX-License-Identifier: GPL-3.0-or-later
// Surface diagonals that Delaunay wants the other way.
#pragma once

#include "mesh/mesh.h"
#include "volume/cavity.h"
#include "volume/fill_cavity.h"
#include "volume/recovery/facet_split.h"

namespace featuremesh {

/// Where two missing facets of one CAD face make a quad whose other diagonal's triangles are there (four nodes on a
/// circle, mostly): that change of diagonal, as a split without added points.
FacetSplit flip_missing(const Cavity& cavity, const CavityFill& fill, const Mesh& mesh);

/// Where a tet without height lies under two facets of one CAD face, nodes in one plane to the last bits: the change of
/// diagonal that leaves it outside. So too for tets of less than `least_volume`, mm^3. Only for faces with one
/// solid beside them.
FacetSplit flip_flat(const Cavity& cavity, const CavityFill& fill, const Mesh& mesh, double least_volume = 0);

}  // namespace featuremesh

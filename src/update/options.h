// SPDX-License-Identifier: GPL-3.0-or-later
// What the user asks of a mesh.
#pragma once

#include "core/dimension.h"
#include "mesh/mesh.h"
#include "sizing/sizing_field.h"
#include "volume/fill_solids.h"

namespace featuremesh {

struct MeshOptions {
    SizingOptions sizing;
    VolumeOptions volume;
    int order = 1;  ///< 1: 4-node tets, 3-node triangles and 2-node segments; 2: with mid-side nodes
    Dimension dimension = Dimension::from_shape;
    double keep_margin = 0;    ///< a node is kept when the changed boundary is further off than this many edge lengths;
                               ///< 0: as the sizes need
    double ignore_below = -1;  ///< mm: smaller edges and strips get no elements of their own; 0: those below a
                               ///< two-hundredth of the size, or fewer where the part is refused so; negative: none
    double ignored_below = 0;  ///< mm: what that came to for a mesh
    double most_tets = 50e6;   ///< more than this are refused
    bool operator==(const MeshOptions&) const = default;
};

/// The first numbers that a document's history has not given away yet.
struct NextNumbers {
    Number node = 1, element = 1;
};

}  // namespace featuremesh

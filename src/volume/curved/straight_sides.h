// SPDX-License-Identifier: GPL-3.0-or-later
// The last resort where curved sides fold elements: sides as straight as those of elements without mid-side nodes.
#pragma once

#include <cstddef>
#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"

namespace featuremesh {

struct StraightSides {
    Mesh mesh;                   ///< empty where that does not help
    std::size_t sides = 0;       ///< on the shape, but straight
    double distance = 0;         ///< mm: no mid-side node is further from where it was on the shape
    std::vector<Entity> places;  ///< the edges and faces of these sides, ascending
};

struct FoldedElements {
    std::vector<TetId> tets;
    std::vector<TriangleId> triangles;  ///< of shells
};

/// The triangles of shells, from the one at `first` on, with a scaled Jacobian below `limit`.
std::vector<TriangleId> shell_triangles_below(const Brep& brep, const Mesh& mesh, std::size_t first, double limit);

/// Takes the bend from all sides of the elements `folded`, and from those of their neighbours that this folds in turn,
/// until no tet and no triangle of a shell is folded or nearly so. Straight elements are valid, so this ends.
StraightSides straighten(const Brep& brep, Mesh mesh, FoldedElements folded, RunContext& context);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles that run through each other: what no volume mesher can mend.
#pragma once

#include <array>
#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"

namespace featuremesh {

using TrianglePairs = std::vector<std::array<TriangleId, 2>>;

/// Pairs of triangles that have more in common than their shared nodes and side. Exact, but between bodies: there
/// triangles may also lie on one another over a gap in which CAD entities are the same.
struct Crossings {
    /// Of faces of one body, the first of them a new one (index at least `first_new`). Two triangles that lie in their
    /// planar CAD faces cross only when the shape does; such pairs are not looked for.
    TrianglePairs within;
    /// Of faces that have no body in common: solids or sheets that touch or overlap. Also of two kept triangles, the
    /// first of them the later one.
    TrianglePairs between;
};
Crossings crossing_triangles(const Brep& brep, const Mesh& mesh, std::size_t first_new, RunContext& context);

}  // namespace featuremesh

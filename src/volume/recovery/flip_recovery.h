// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary recovery by flips alone: no point is added.
#pragma once

#include <optional>
#include <vector>

#include "volume/cavity.h"
#include "volume/delaunay/triangulation.h"
#include "volume/fill_cavity.h"

namespace featuremesh {

struct FlippedTriangulation {
    std::optional<Triangulation> tets;  ///< with every facet
    std::vector<int> left;              ///< or the facets that could not be had, of the attempt that left the fewest
};

/// Brings the missing facets of a filling back: first their sides, then themselves, by taking out what they cross, a
/// face of two tets (2-3 flip) or an edge (any triangulation of its ring), where the tets that take its place have a
/// volume and cross less (George, Hecht and Saltel 1991; Si 2015). Facets and their sides that are there stay. Where
/// that fails it is tried again on a Delaunay triangulation of `levelled_points`.
FlippedTriangulation recover_by_flips(const Cavity& cavity, const CavityFill& fill, RunContext& context);

}  // namespace featuremesh

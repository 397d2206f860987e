// SPDX-License-Identifier: GPL-3.0-or-later
// Seeds that keep triangles of the boundary out of a Delaunay triangulation.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/run_context.h"
#include "volume/cavity.h"
#include "volume/delaunay/triangulation.h"
#include "volume/fill_cavity.h"

namespace featuremesh {

/// Points of the filling, ascending, without which these missing facets would all be there. A facet is Delaunay if some
/// ball with its corners on the sphere is empty; of the balls without a point of the cavity's own, each facet gets one
/// with the fewest seeds. None are named where a facet would take many, or every ball has a point of the cavity's own.
std::vector<int> seeds_in_the_way(const Cavity& cavity, const CavityFill& fill, std::span<const int> facets);

/// The Delaunay triangulation of the other points, which are numbered anew in their order; only the tets at those
/// dropped are made anew. None where that cannot be done.
std::optional<Triangulation> triangulation_without(std::span<const int> dropped, const Cavity& cavity,
                                                   const CavityFill& fill, RunContext& context);

}  // namespace featuremesh

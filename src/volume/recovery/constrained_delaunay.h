// SPDX-License-Identifier: GPL-3.0-or-later
// Tets that have every facet, if need be in pieces: the conforming constrained Delaunay triangulation.
#pragma once

#include <span>
#include <vector>

#include "core/geometry.h"
#include "core/run_context.h"
#include "volume/cavity.h"
#include "volume/delaunay/triangulation.h"
#include "volume/recovery/facet_split.h"

namespace featuremesh {

struct ConstrainedTriangulation {
    FacetSplit split;
    Triangulation triangulation;  ///< of the cavity's points, then those added, then the seeds
    bool is_given_up = false;     ///< far more points than the facets have would be added; all else is empty then
    std::vector<int> failed;      ///< facets that could not be had; all else is empty then
};

/// By CGAL's conforming constrained Delaunay triangulation (Si and Gaertner 2005, Diazzi et al. 2023) with each facet a
/// constraint of its own. Facets must not cut one another: see `crossing_facets`. How many points it may add grows with
/// `missing`, the number of facets that a Delaunay triangulation of the points does not have.
ConstrainedTriangulation constrained_delaunay(const Cavity& cavity, std::span<const Vec3> seeds, std::size_t missing,
                                              const RunContext& context = {});

/// Facets that cut or overlap others, or have no area; ascending.
std::vector<int> crossing_facets(const Cavity& cavity);
/// The same where a triangulation of the points has all facets but `missing`: those that it has do not cross each
/// other.
std::vector<int> crossing_facets(const Cavity& cavity, std::span<const int> missing);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay tets of points, and which of them lie in which region.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "core/run_context.h"
#include "volume/facet.h"

namespace featuremesh {

/// Tets that fill the convex hull of their points.
struct Triangulation {
    std::vector<std::array<int, 4>> tets;        ///< positive volume, or none by a hair: exact predicates
    std::vector<std::array<int, 4>> neighbours;  ///< [i][k] is opposite corner k; -1 at the hull
};

/// A Delaunay triangulation that more points can be added to.
class GrowingDelaunay {
  public:
    GrowingDelaunay();
    ~GrowingDelaunay();
    /// Points count on from those before. Throws MeshError when two points coincide.
    void insert(std::span<const Vec3> points, RunContext& context);
    /// The tets so far, none of points in one plane; `number_of` gives the points other numbers (empty: their own).
    Triangulation tets(const RunContext& context, std::span<const int> number_of = {}) const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

/// The Delaunay triangulation, without tets where all points lie in one plane; many points are divided into parts that
/// all threads triangulate. The same bytes for the same input, with any number of threads. Throws MeshError when two
/// points coincide.
Triangulation delaunay(std::span<const Vec3> points, RunContext& context);

/// Which of the facets are triangles of the tets, and where: (tet, corner opposite) seen from behind and from before,
/// -1 for none.
struct FacetPlaces {
    std::vector<int> facet_at;  ///< by 4 tet + corner: the facet there, or -1
    std::vector<int> missing;   ///< facets that are no triangle of the tets
};
FacetPlaces find_facets(const Triangulation& triangulation, std::size_t point_count, std::span<const Facet> facets,
                        RunContext& context);
/// The same on one thread.
FacetPlaces find_facets(const Triangulation& triangulation, std::size_t point_count, std::span<const Facet> facets);

/// Looks for the missing facets, which may have other corners than before; those still missing are left in the list.
void place_missing(const Triangulation& triangulation, std::size_t point_count, std::span<const Facet> facets,
                   FacetPlaces& places, RunContext& context);

/// By tet: the region it is in, or -1, labelled tet by tet from the facets up to the facets. Empty when a region leaks
/// into another.
std::vector<int> label_regions(const Triangulation& triangulation, std::span<const Facet> facets,
                               const FacetPlaces& places, RunContext& context);

}  // namespace featuremesh

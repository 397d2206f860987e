// SPDX-License-Identifier: GPL-3.0-or-later
// Tets between the facets of one cavity: seeds, Delaunay, labels of regions. No CAD.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "volume/cavity.h"
#include "volume/delaunay/lattice_seeds.h"
#include "volume/delaunay/triangulation.h"
#include "volume/tets/circumsphere.h"
#include "volume/tets/tet_complex.h"
#include "volume/wanted_size.h"

namespace featuremesh {

struct CavityFill {
    std::vector<Vec3> points;     ///< the cavity's, then those added
    Triangulation triangulation;  ///< of the points' convex hull
    FacetPlaces places;
    std::vector<int> regions;                   ///< by tet, -1 for none; empty as long as facets are missing
    bool is_leaky = false;                      ///< all facets are there, and yet regions run into one another
    std::shared_ptr<GrowingDelaunay> delaunay;  ///< of the points, where kept tets at the interface may have to go
    std::vector<int> point_of;                  ///< by its numbers: the point
    std::optional<std::vector<int>> relocated;  ///< the points that a recovery left inside, where there was one
    bool is_complete() const { return places.missing.empty() && !is_leaky; }
};

/// Fills what is between the facets as Delaunay has it. What `balls` hold is kept free of seeds.
CavityFill fill_cavity(const Cavity& cavity, std::span<const Ball> balls, std::span<const Vec3> active,
                       const WantedSize& size, RunContext& context);

/// The same for a cavity that has grown by a few nodes since: they are added to its triangulation. Seeds stay, and
/// nodes that are inside it now are seeds.
CavityFill grow_fill(const Cavity& cavity, std::span<const NodeId> old_nodes, const CavityFill& old,
                     RunContext& context);

/// The points of a fill that are not the cavity's own, and those of them that are among the active ones.
std::vector<Vec3> seeds_of(const Cavity& cavity, const CavityFill& fill);
std::vector<Vec3> seeds_among(std::span<const Vec3> active, const Cavity& cavity, const CavityFill& fill);

/// Finds the facets in a triangulation of the points and labels the regions between them.
CavityFill label_cavity(const Cavity& cavity, std::vector<Vec3> points, Triangulation triangulation,
                        RunContext& context);

/// The same where only facets that were missing have other corners now.
void label_turned(const Cavity& cavity, CavityFill& fill, RunContext& context);

/// The tets that lie in a region, for local operations; the cavity's own points are fixed.
TetComplex make_complex(const Cavity& cavity, const CavityFill& fill, const RunContext& context);

/// The circumspheres of the kept tets at the interface: as long as they are empty, the interface holds by itself. Those
/// with room for a node are left out: such tets are coarser than wanted or flat, and go if a node needs the room.
std::vector<Ball> interface_balls(const Mesh& mesh, const Cavity& cavity, const WantedSize& size);

/// Points that were put on the CAD faces may have turned tets over.
bool has_inverted_tet(const CavityFill& fill);

}  // namespace featuremesh

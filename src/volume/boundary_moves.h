// SPDX-License-Identifier: GPL-3.0-or-later
// Tets that no inner vertex can help are helped by vertices of the boundary.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/run_context.h"
#include "features/brep.h"
#include "mesh/mesh.h"
#include "surface/projection.h"
#include "volume/seam_region.h"
#include "volume/tet_complex.h"

namespace featuremesh {

/// A vertex inside a CAD face, or inside an edge between two faces, whose tets are all in the complex.
struct BoundaryVertex {
    int vertex;
    Entity on;
    std::array<double, 2> parameters;  ///< (t, 0) on an edge, (u, v) on a face
};

/// The region's nodes from `first_new` on that are on one face, or between two, with material on one side only, and
/// away from kept tets.
std::vector<BoundaryVertex> movable_vertices(const Brep& brep, const Mesh& mesh, const SeamRegion& region,
                                             std::size_t first_new);

struct BoundaryMoveOptions {
    double target_dihedral_deg = 30;
    double least_volume = 0;  ///< mm^3; no tet gets thinner than `thickness` allows
    bool is_for_curved_tets =
        false;  ///< where the surface is curved nothing moves: other sides may fold tets that follow it
};

/// Moves such vertices along their face or edge, and free ones, where that helps the worst tet of their star, worst
/// tets first; half or a quarter of the way where all of it is not worth it for the star as a whole. The star's volume
/// stays within half a percent, so that triangles cut off no more of a curved face. They keep their side, and their
/// angles stay as good, or good enough. Afterwards those of stars with a poor mean radius ratio move where that is
/// larger and no bad angle worse. Updates the places and parameters of `vertices`; gives the tets that changed.
std::vector<int> move_on_boundary(TetComplex& complex, std::span<BoundaryVertex> vertices, const Projector& projector,
                                  const BoundaryMoveOptions& options, RunContext& context);

/// Moves one corner of a tet, which is one of `vertices` or free, to where this tet reaches the target, or nearer to
/// that, whatever it does to the angles of the others. False where there is no such place.
bool move_for_tet(TetComplex& complex, std::span<BoundaryVertex> vertices, int vertex, int tet,
                  const Projector& projector, const BoundaryMoveOptions& options, RunContext& context);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Points added to facets, and what becomes of the mesh's segments and triangles.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "surface/projection.h"
#include "volume/cavity.h"

namespace featuremesh {

struct FacetSplit {
    struct Added {
        Vec3 point;
        std::array<int, 2> edge{-1, -1};  ///< the edge of facets it is on, as cavity nodes
        int facet = -1;                   ///< or the facet it is in
    };
    /// A piece of a facet that was cut; turned as the facet is. Corners beyond the cavity's own nodes are the added
    /// points, in their order.
    struct Piece {
        std::array<int, 3> corners;
        int facet;
    };
    std::vector<Added> added;
    std::vector<Piece> pieces;  ///< by facet, all pieces of all facets that are cut
};

/// Cuts the longest edge of each of the facets in the middle, and with it all facets around that edge.
FacetSplit halve_longest_edges(const Cavity& cavity, std::span<const int> facets);

/// Kept tets that have a cut edge or a cut triangle, ascending: they must go before the split can be applied. `near`,
/// if there is any: all kept tets with a node of the cavity are among them, ascending.
std::vector<TetId> tets_in_the_way(const FacetSplit& split, const Cavity& cavity, const Mesh& mesh,
                                   std::span<const std::uint8_t> is_released,
                                   std::optional<std::span<const TetId>> near = {});

/// Puts the added points on the exact CAD edge or face (those within `on_entity`, mm, stay where they are) and cuts the
/// mesh's segments and triangles: the first piece takes the place of what is cut, the others are appended, all with new
/// numbers. Gives back the new nodes, by added point.
std::vector<NodeId> apply_split(const FacetSplit& split, const Cavity& cavity, const Projector& projector,
                                double on_entity, Mesh& mesh, const RunContext& context);

}  // namespace featuremesh

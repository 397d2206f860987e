// SPDX-License-Identifier: GPL-3.0-or-later
// What of the solids is not meshed yet, found from the triangles of the CAD faces and the tets that are kept.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"
#include "mesh/mesh.h"
#include "volume/facet.h"

namespace featuremesh {

/// The boundary of the space to fill, with node indices of its own.
struct Cavity {
    std::vector<NodeId> nodes;  ///< the mesh's nodes, ascending
    std::vector<Vec3> points;   ///< mm, by cavity node
    std::vector<Facet> facets;
    std::vector<TriangleId> triangle_of_facet;  ///< none at the interface
    std::vector<TetId> tet_of_facet;            ///< the kept tet behind the interface, else none
};

/// Triangles with a solid beside them that no kept tet covers there, and facets of kept tets that no other kept tet and
/// no triangle matches. One linear pass over the tets, unless `near` is given; the rest costs what the cavity costs.
/// `solids_beside_face` as Brep::solids_beside_faces; `is_released` by TetId marks tets that count as not there (empty:
/// none); `may_be_open` by node marks all nodes that the cavity can have (empty: unknown, they are searched for);
/// `near` are all tets with such a node, ascending (none: searched for).
Cavity find_cavity(const Mesh& mesh, std::span<const std::array<SolidId, 2>> solids_beside_face,
                   std::span<const std::uint8_t> is_released = {}, std::span<const char> may_be_open = {},
                   std::optional<std::span<const TetId>> near = {});

/// Facets with an edge around which the boundary of a region does not close; ascending.
std::vector<int> open_facets(const Cavity& cavity);

/// Splits a cavity into parts that can be filled one apart from the other: they share no node, and no solid within one
/// another's box.
std::vector<Cavity> separate_cavities(Cavity cavity);

}  // namespace featuremesh

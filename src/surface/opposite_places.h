// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes opposite one another on the two sides of a wall or slit that is far thinner than its triangles are wide.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "surface/chart.h"
#include "surface/face_boundary.h"
#include "surface/seeds.h"

namespace featuremesh {

struct OppositePlaces {
    /// By face with new triangles: parameters (u, v) on its surface of the places opposite the nodes of a smaller face,
    /// or of one that is kept, where whole triangles of that are nearer than a two-hundredth of their sides. A face
    /// that has such places gives none.
    std::vector<std::vector<std::array<double, 2>>> on_faces;
    /// Edges of two such faces, that nearness apart along the rim of the wall.
    std::vector<std::array<EdgeId, 2>> edges;
};

/// Of faces of one body without a common vertex. The triangles before `first_new` are kept.
OppositePlaces find_opposite_places(const Brep& brep, const Mesh& mesh, std::size_t first_new, RunContext& context);

/// Nodes at these places of the chart, where the domain has room for them, stay where they are; the other seeds keep
/// off them. `wanted`: side length at each place, mm.
void put_first(std::span<const Vec2> places, std::span<const double> wanted, const FaceBoundary& boundary,
               const ChartDomain& domain, Seeds& seeds);

}  // namespace featuremesh

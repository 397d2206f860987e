// SPDX-License-Identifier: GPL-3.0-or-later
// Cavities that cannot be filled, and at which CAD faces that shows.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/errors.h"
#include "core/ids.h"
#include "mesh/mesh.h"
#include "volume/cavity.h"
#include "volume/fill_cavity.h"
#include "volume/obstacle.h"

namespace featuremesh {

/// The faces whose triangles these facets of the cavity are; none where none is a triangle.
std::vector<Entity> faces_of(const Mesh& mesh, const Cavity& cavity, std::span<const int> facets);

/// The faces that most of a tet's corners lie on; corners count in the cavity's points, and those inside after them.
std::vector<FaceId> nearest_faces(const Brep& brep, const Mesh& mesh, const Cavity& cavity,
                                  const std::array<int, 4>& tet);

/// Where the cavity's boundary does not close, if anywhere.
std::optional<Obstacle> if_open(const Mesh& mesh, const Cavity& cavity);

/// For a cavity of nodes in one plane, which misses these facets.
Obstacle in_one_plane(const Mesh& mesh, const Cavity& cavity, std::span<const int> missing);

/// Throws MeshError with the names of the faces where two nodes are in one place.
void require_distinct(const Brep& brep, const Mesh& mesh, const Cavity& cavity);

/// For these facets, which cut one another.
Obstacle cut_one_another(const Mesh& mesh, const Cavity& cavity, std::span<const int> crossing);

/// For the facets that the fills miss.
Obstacle unrecovered(const Mesh& mesh, std::span<const Cavity> cavities, std::span<const CavityFill> fills);

}  // namespace featuremesh

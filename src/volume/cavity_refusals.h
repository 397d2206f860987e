// SPDX-License-Identifier: GPL-3.0-or-later
// Cavities that cannot be filled, by the names of the CAD faces where that shows.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "features/brep.h"
#include "volume/cavity.h"

namespace featuremesh {

/// "Face1, Face3": the faces whose triangles these facets of the cavity are; "the surface" where none is a triangle.
std::string names_of_faces(const Mesh& mesh, const Cavity& cavity, std::span<const int> facets);

/// The faces that most of a tet's corners lie on; corners count in the cavity's points, and those inside after them.
std::vector<FaceId> nearest_faces(const Brep& brep, const Mesh& mesh, const Cavity& cavity,
                                  const std::array<int, 4>& tet);

/// Throws MeshError with the names of the faces where the cavity's boundary does not close.
void require_closed(const Mesh& mesh, const Cavity& cavity);

/// Throws MeshError with the names of the faces where two nodes are in one place.
void require_distinct(const Brep& brep, const Mesh& mesh, const Cavity& cavity);

/// Throws MeshError for these facets, which cut one another.
[[noreturn]] void throw_crossing(const Mesh& mesh, const Cavity& cavity, std::span<const int> crossing);

}  // namespace featuremesh

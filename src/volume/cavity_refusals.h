// SPDX-License-Identifier: GPL-3.0-or-later
// Cavities that cannot be filled, by the names of the CAD faces where that shows.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/errors.h"
#include "features/brep.h"
#include "volume/cavity.h"
#include "volume/fill_cavity.h"

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

/// For these facets, which cut one another.
MeshError cut_one_another(const Mesh& mesh, const Cavity& cavity, std::span<const int> crossing);

/// For the facets that the fills miss.
MeshError unrecovered(const Mesh& mesh, std::span<const Cavity> cavities, std::span<const CavityFill> fills);

}  // namespace featuremesh

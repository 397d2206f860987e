// SPDX-License-Identifier: GPL-3.0-or-later
// What is said about a filled surface.
#pragma once

#include <vector>

#include "brep/brep.h"
#include "core/message.h"
#include "mesh/mesh.h"
#include "surface/triangle_crossings.h"

namespace featuremesh {

/// The pairs of faces whose triangles cross, most often first, and where the first of these triangles is; a few.
std::vector<Message> faces_that_cross(const Mesh& mesh, const TrianglePairs& crossings);
std::vector<Message> places_of_crossings(const Mesh& mesh, const TrianglePairs& crossings);

/// What may not be meant so: solids or sheets that touch (`between`, as in Crossings), shells and beams inside a solid
/// that does not know them, faces and edges that are not meshed.
std::vector<Message> warnings_of(const Brep& brep, const Mesh& mesh, const TrianglePairs& between);

}  // namespace featuremesh

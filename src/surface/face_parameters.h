// SPDX-License-Identifier: GPL-3.0-or-later
// Where the nodes of a face and of its border are on its surface.
#pragma once

#include <array>
#include <optional>

#include "brep/brep.h"
#include "core/ids.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// The parameters (u, v) on the face of a point of an edge of its border, by the edge's curve in the face. None where
/// the edge is not of the face. On a seam one of two places.
std::optional<std::array<double, 2>> parameters_on(const Brep& brep, FaceId face, EdgeId edge, double t);
/// The same of a node inside the face, on one of its edges or on a vertex. None for other nodes.
std::optional<std::array<double, 2>> parameters_on(const Brep& brep, FaceId face, const Mesh& mesh, NodeId node);

}  // namespace featuremesh

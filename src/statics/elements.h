// SPDX-License-Identifier: GPL-3.0-or-later
// 4- and 10-node tets as finite elements: shape functions where they are integrated.
#pragma once

#include <array>

#include "mesh/mesh.h"

namespace featuremesh {

/// The volume that a point of integration stands for, mm^3, and the gradients of the nodes' shape functions there,
/// 1/mm.
struct IntegrationPoint {
    double volume = 0;
    std::array<Vec3, 10> gradients;
};

/// An element as it is integrated: a 4-node tet at its middle, a 10-node tet at four points, as CalculiX's C3D4 and
/// C3D10.
struct Element {
    int node_count = 4, point_count = 1;
    std::array<NodeId, 10> nodes;  ///< corners, then mid-side nodes in the order of Mesh::tet_mids
    std::array<IntegrationPoint, 4> points;
};

Element element_at(const Mesh& mesh, std::size_t tet);

/// Values of the shape functions of an element of so many nodes at one of its points of integration.
std::array<double, 10> shape_values(int node_count, int point);

/// How a linear field with given values at the four points of integration of a 10-node tet continues to its corners:
/// the value there is `own` times that of the nearest point plus `other` times those of the rest.
struct CornerWeights {
    double own, other;
};
CornerWeights corner_weights();

/// The other way round: how a linear field with given values at the corners continues to those four points.
CornerWeights inner_weights();

}  // namespace featuremesh

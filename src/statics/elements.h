// SPDX-License-Identifier: GPL-3.0-or-later
// 4- and 10-node tets as finite elements: shape functions where they are integrated.
#pragma once

#include <array>

#include "core/geometry.h"
#include "core/ids.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// The volume that a point of integration stands for, mm^3, and the gradients of the nodes' shape functions there,
/// 1/mm.
template <std::size_t node_count>
struct IntegrationPoint {
    double volume = 0;
    std::array<Vec3, node_count> gradients;
};

/// An element as it is integrated.
template <std::size_t node_count, std::size_t point_count>
struct Element {
    std::array<NodeId, node_count> nodes;  ///< corners, then mid-side nodes in the order of Mesh::tet_mids
    std::array<IntegrationPoint<node_count>, point_count> points;
};

/// A 4-node tet at its middle, as CalculiX's C3D4.
Element<4, 1> linear_element(const Mesh& mesh, std::size_t tet);
/// A 10-node tet at four points, as CalculiX's C3D10.
Element<10, 4> quadratic_element(const Mesh& mesh, std::size_t tet);

/// Calls `work` with the element that a tet is.
template <class Work>
void with_element(const Mesh& mesh, std::size_t tet, const Work& work) {
    mesh.order == 2 ? work(quadratic_element(mesh, tet)) : work(linear_element(mesh, tet));
}

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

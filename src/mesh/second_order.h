// SPDX-License-Identifier: GPL-3.0-or-later
// 10-node tets: numbering of sides, straight mid-side nodes, and the proof that an element is not folded.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// Corners of the six sides in the order of Mesh::tet_mids (Abaqus C3D10).
inline constexpr std::array<std::array<int, 2>, 6> tet_sides{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};
/// Corners of the four faces, normals outward, face i opposite corner i.
inline constexpr std::array<std::array<int, 3>, 4> tet_faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The corners of the facet, normal outward.
template <class T>
std::array<T, 3> facet_opposite(const std::array<T, 4>& tet, int corner) {
    const auto& [a, b, c] = tet_faces[static_cast<std::size_t>(corner)];
    return {tet[static_cast<std::size_t>(a)], tet[static_cast<std::size_t>(b)], tet[static_cast<std::size_t>(c)]};
}
/// Whether the corners, brought into ascending order, are an odd permutation.
template <class T>
bool is_odd(const std::array<T, 3>& c) {
    return ((c[0] > c[1]) + (c[0] > c[2]) + (c[1] > c[2])) % 2 == 1;
}

/// The 20 Bernstein coefficients of det J of a 10-node tet (cubic), nodes as 4 corners and 6 mid-sides.
/// Johnen, Remacle and Geuzaine 2013. All positive means valid everywhere.
std::array<double, 20> jacobian_coefficients(const std::array<Vec3, 10>& nodes);

/// The smallest of them; minus infinity, in less time, where one of the corners' is no larger than `limit`.
double smallest_coefficient(const std::array<Vec3, 10>& nodes, double limit);

/// How the sum of the coefficients, weighted, changes with the nodes.
std::array<Vec3, 10> jacobian_gradient(const std::array<Vec3, 10>& nodes, const std::array<double, 20>& weights);

/// Lower bound of det J over the element divided by 6 V of its straight tet; sharpened by subdivision until bound and
/// samples agree within 1e-3 or the sign is certain.
double min_scaled_jacobian(const std::array<Vec3, 10>& nodes);

/// The same of a 6-node triangle (3 corners, mid-sides 01, 12, 20): lower bound, over the element, of its normal's part
/// along the normal of the straight triangle, divided by that one. Positive: it is folded nowhere.
double min_scaled_jacobian(const std::array<Vec3, 6>& nodes);

/// The six points of one triangle.
std::array<Vec3, 6> triangle_nodes(const Mesh& mesh, TriangleId triangle);

/// The ten points of one tet.
std::array<Vec3, 10> tet_nodes(const Mesh& mesh, TetId tet);

/// Whether a side's mid-side node is off the middle of its corners.
bool has_curved_side(const Mesh& mesh, TetId tet);

/// By mid-side node, from the first one on, the corners of the side that it is on.
std::vector<std::array<NodeId, 2>> ends_of_mids(const Mesh& mesh);

/// Gives every side of a 4-node mesh that has no mid-side node yet one at its middle. Sides of kept elements keep
/// theirs. The nodes' entities are those of the segments and triangles the side belongs to, else the solid. Returns the
/// new nodes.
std::vector<NodeId> add_mid_side_nodes(Mesh& mesh, const Mesh* kept = nullptr, const RunContext& context = {});

}  // namespace featuremesh

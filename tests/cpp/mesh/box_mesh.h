// SPDX-License-Identifier: GPL-3.0-or-later
// A box of n x n x n cubes, six tets each (Kuhn), with faces, edges and numbers as a mesh of a CAD box has them.
#pragma once

#include <algorithm>
#include <iterator>
#include <map>

#include "mesh/mesh.h"
#include "mesh/second_order.h"
#include "mesh/validation.h"

namespace featuremesh {

/// Planes x=0, x=1, y=0, y=1, z=0, z=1 of the unit box are faces 0 to 5; the edge between faces i < j is 6 i + j.
inline Mesh box_mesh(int n) {
    Mesh mesh;
    const auto index = [n](int i, int j, int k) { return static_cast<std::int32_t>((i * (n + 1) + j) * (n + 1) + k); };
    const auto planes = [n](int i, int j, int k) {
        std::vector<int> on;
        const int c[3] = {i, j, k};
        for (int axis = 0; axis < 3; ++axis) {
            if (c[axis] == 0) on.push_back(2 * axis);
            if (c[axis] == n) on.push_back(2 * axis + 1);
        }
        return on;
    };
    std::vector<std::vector<int>> node_planes;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
            for (int k = 0; k <= n; ++k) {
                const auto on = planes(i, j, k);
                Entity entity{3, 0};
                if (on.size() == 1) entity = {2, on[0]};
                if (on.size() == 2) entity = {1, 6 * on[0] + on[1]};
                if (on.size() == 3) entity = {0, 4 * (i > 0) + 2 * (j > 0) + (k > 0)};
                mesh.add_node({double(i) / n, double(j) / n, double(k) / n}, entity);
                node_planes.push_back(on);
            }
    std::vector<std::array<NodeId, 4>> tets;
    std::array<int, 3> order{0, 1, 2};
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k) {
                std::sort(order.begin(), order.end());
                do {
                    int c[3] = {i, j, k};
                    std::array<NodeId, 4> tet{NodeId(index(i, j, k))};
                    for (int step = 0; step < 3; ++step) {
                        ++c[order[step]];
                        tet[step + 1] = NodeId(index(c[0], c[1], c[2]));
                    }
                    if (signed_volume(mesh.point(tet[0]), mesh.point(tet[1]), mesh.point(tet[2]), mesh.point(tet[3])) <
                        0)
                        std::swap(tet[2], tet[3]);
                    tets.push_back(tet);
                } while (std::next_permutation(order.begin(), order.end()));
            }
    const auto common_plane = [&](std::initializer_list<NodeId> nodes) {
        for (int plane = 0; plane < 6; ++plane)
            if (std::all_of(nodes.begin(), nodes.end(), [&](NodeId node) {
                    const auto& on = node_planes[node.index()];
                    return std::find(on.begin(), on.end(), plane) != on.end();
                }))
                return plane;
        return -1;
    };
    std::map<std::array<std::int32_t, 2>, EdgeId> segments;
    for (const auto& tet : tets)
        for (const auto& face : tet_faces) {
            const std::array<NodeId, 3> t{tet[face[0]], tet[face[1]], tet[face[2]]};
            const int plane = common_plane({t[0], t[1], t[2]});
            if (plane < 0) continue;
            for (int s = 0; s < 3; ++s) {
                const NodeId a = std::min(t[s], t[(s + 1) % 3]), b = std::max(t[s], t[(s + 1) % 3]);
                std::vector<int> on;
                std::set_intersection(node_planes[a.index()].begin(), node_planes[a.index()].end(),
                                      node_planes[b.index()].begin(), node_planes[b.index()].end(),
                                      std::back_inserter(on));
                if (on.size() == 2) segments[{a.value, b.value}] = EdgeId(6 * on[0] + on[1]);
            }
            mesh.add_triangle(t, FaceId(plane));
        }
    for (const auto& [nodes, edge] : segments) mesh.add_segment({NodeId(nodes[0]), NodeId(nodes[1])}, edge);
    for (const auto& tet : tets) mesh.add_tet(tet, SolidId(0));
    mesh.corner_count = mesh.points.size();
    return mesh;
}

inline Expectation box_expectation() {
    Expectation expected;
    expected.solid_volumes = {1.0};
    expected.volume_tolerance = 1e-9;
    expected.solids_beside_face.assign(6, {SolidId(0), SolidId()});
    return expected;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Which corners make the faces and edges of a tet, all in even permutations so that orientation is kept.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

namespace featuremesh {

using Tet = std::array<int, 4>;

/// (i, opposite_face[i]) is an even permutation of the corners.
inline constexpr std::array<std::array<int, 3>, 4> opposite_face{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// (i, j, opposite_edge[i][j]) is an even permutation of the corners.
inline constexpr std::array<std::array<std::array<int, 2>, 4>, 4> opposite_edge{{
    {{{0, 0}, {2, 3}, {3, 1}, {1, 2}}},
    {{{3, 2}, {0, 0}, {0, 3}, {2, 0}}},
    {{{1, 3}, {3, 0}, {0, 0}, {0, 1}}},
    {{{2, 1}, {0, 2}, {1, 0}, {0, 0}}},
}};

inline constexpr std::array<std::array<int, 2>, 6> edge_corners{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// Place of a vertex in a tet that has it.
inline int corner_of(const Tet& tet, int vertex) {
    return tet[0] == vertex ? 0 : tet[1] == vertex ? 1 : tet[2] == vertex ? 2 : 3;
}

/// The face of a tet with these neighbours that leads to `tet`.
inline int face_towards(const std::array<int, 4>& neighbours, int tet) { return corner_of(neighbours, tet); }

/// The vertices, ascending.
inline Tet sorted(Tet tet) {
    std::sort(tet.begin(), tet.end());
    return tet;
}

/// The three vertices of a face, ascending.
inline std::array<int, 3> sorted_face(const Tet& tet, int face) {
    const auto& corner = opposite_face[face];
    std::array<int, 3> v{tet[corner[0]], tet[corner[1]], tet[corner[2]]};
    if (v[0] > v[1]) std::swap(v[0], v[1]);
    if (v[1] > v[2]) std::swap(v[1], v[2]);
    if (v[0] > v[1]) std::swap(v[0], v[1]);
    return v;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// The connectivity that the local operations work on. No CGAL, no CAD.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry.h"

namespace featuremesh {

/// What may be done to a vertex. `kept` ones may move, but are not taken out; so are those on a CAD edge or face, which
/// only move along it.
enum class Mobility : std::uint8_t { free, fixed, kept, on_edge, on_face };
inline bool is_on_boundary(Mobility m) { return m != Mobility::free && m != Mobility::kept; }

/// Tets with neighbours, for local operations. Vertices are ints here: they count within one cavity.
struct TetComplex {
    std::vector<Vec3> points;
    std::vector<Mobility> mobility;              ///< by vertex; `fixed` for the boundary and what is kept
    std::vector<std::array<int, 4>> tets;        ///< positive volume; tets[i][0] < 0 marks a removed one
    std::vector<std::array<int, 4>> neighbours;  ///< neighbours[i][k] is opposite vertex k; -1 at the cavity's
                                                 ///< boundary
    std::vector<int> regions;                    ///< by tet: the solid; faces between regions are
                                                 ///< never flipped away
    std::vector<int> tet_of_vertex;              ///< any one live tet of the vertex; -1 for none
    bool is_free(int vertex) const { return mobility[static_cast<std::size_t>(vertex)] == Mobility::free; }
};

inline std::array<Vec3, 4> corners_of(const TetComplex& complex, const std::array<int, 4>& tet) {
    const auto& p = complex.points;
    return {p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]};
}

template <std::size_t count>
std::array<bool, count> are_on_boundary(const TetComplex& complex, const std::array<int, count>& vertices) {
    std::array<bool, count> are;
    for (std::size_t i = 0; i < count; ++i) are[i] = is_on_boundary(complex.mobility[vertices[i]]);
    return are;
}

/// Finds neighbours and tet_of_vertex from points and tets. A triangle between two regions counts as boundary (-1 for
/// both tets). Throws MeshError where a triangle has more than two tets.
void connect(TetComplex& complex);

/// What is wrong with the complex, one line each (at most ten): neighbours that do not know each other or share other
/// triangles, faces between regions that are linked, tets without positive volume, tet_of_vertex that points elsewhere.
/// Empty when all is well.
std::vector<std::string> find_flaws(const TetComplex& complex);

}  // namespace featuremesh

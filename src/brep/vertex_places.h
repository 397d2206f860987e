// SPDX-License-Identifier: GPL-3.0-or-later
// Where a vertex is, among the places that its tolerance allows.
#pragma once

#include <array>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"

class TopoDS_Edge;
class TopoDS_Face;
class TopoDS_Vertex;

namespace featuremesh {

/// Whether its tolerance is more than what the kernel gives every vertex.
bool is_loose(const TopoDS_Vertex& vertex);

/// How far a point lies beyond the start (or the end) of an edge, along the edge there, mm; negative inside. FreeCAD
/// finds the nodes of an edge by their distance from what lies between its ends.
double distance_beyond_end(const TopoDS_Edge& edge, bool is_start, const Vec3& p);

/// The point of every vertex, mm. Where an edge ends before its loose vertex, the place nearest to the vertex from
/// which all its edges are met between their ends, as far as the kernel tells points apart, if there is one within the
/// vertex's tolerance and as good a point of all its faces: averaged projections onto the half-spaces behind the ends
/// (Cimmino). `ends` by edge, none for an edge without a vertex; `faces_of` by edge.
std::vector<Vec3> vertex_places(const std::vector<TopoDS_Vertex>& vertices, const std::vector<TopoDS_Edge>& edges,
                                const std::vector<std::array<VertexId, 2>>& ends, const std::vector<TopoDS_Face>& faces,
                                const std::vector<std::vector<FaceId>>& faces_of);

}  // namespace featuremesh

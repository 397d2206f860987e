// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh as arrays.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"

namespace featuremesh {

using Number = std::int64_t;

/// A conforming mesh of 4-node or 10-node tets with the triangles of every CAD face and the segments of every CAD edge.
///
/// Corner nodes come first (`corner_count` of them), mid-side nodes after. An incremental step keeps the kept nodes,
/// segments, triangles and tets in front, in their order. Numbers are what the user sees in FreeCAD; they are never
/// given twice.
struct Mesh {
    int order = 1;
    std::size_t corner_count = 0;

    // Nodes
    std::vector<Vec3> points;                       ///< mm
    std::vector<Entity> entities;                   ///< the CAD entity of lowest dimension that the node lies on
    std::vector<std::array<double, 2>> parameters;  ///< (t, 0) on an edge, (u, v) on a face, zero otherwise
    std::vector<Number> node_numbers;

    // Segments along CAD edges, in the direction of growing edge parameter
    std::vector<std::array<NodeId, 2>> segments;
    std::vector<NodeId> segment_mids;  ///< empty for order 1
    std::vector<EdgeId> segment_edges;
    std::vector<Number> segment_numbers;

    // Triangles on CAD faces; the right-hand normal is that of the face as it is oriented in the shape
    std::vector<std::array<NodeId, 3>> triangles;
    std::vector<std::array<NodeId, 3>> triangle_mids;  ///< of sides 01, 12, 20; empty for order 1
    std::vector<FaceId> triangle_faces;
    std::vector<Number> triangle_numbers;

    // Tets with positive volume: dot(cross(b-a, c-a), d-a) > 0
    std::vector<std::array<NodeId, 4>> tets;
    std::vector<std::array<NodeId, 6>> tet_mids;  ///< of sides 01, 12, 02, 03, 13, 23 (Abaqus C3D10); empty for order 1
    std::vector<SolidId> tet_solids;
    std::vector<Number> tet_numbers;

    Number next_node_number = 1;
    Number next_element_number = 1;  ///< segments, triangles and tets share one count, as FreeCAD's do

    std::size_t node_count() const { return points.size(); }
    const Vec3& point(NodeId n) const { return points[n.index()]; }
    /// Appends a node with the next number; keep corner nodes in front of mid-side nodes.
    NodeId add_node(const Vec3& p, Entity entity, std::array<double, 2> parameter = {0, 0}) {
        points.push_back(p);
        entities.push_back(entity);
        parameters.push_back(parameter);
        node_numbers.push_back(next_node_number++);
        return NodeId(points.size() - 1);
    }
    void add_segment(std::array<NodeId, 2> nodes, EdgeId edge) {
        segments.push_back(nodes);
        segment_edges.push_back(edge);
        segment_numbers.push_back(next_element_number++);
    }
    void add_triangle(std::array<NodeId, 3> nodes, FaceId face) {
        triangles.push_back(nodes);
        triangle_faces.push_back(face);
        triangle_numbers.push_back(next_element_number++);
    }
    void add_tet(std::array<NodeId, 4> nodes, SolidId solid) {
        tets.push_back(nodes);
        tet_solids.push_back(solid);
        tet_numbers.push_back(next_element_number++);
    }
};

}  // namespace featuremesh

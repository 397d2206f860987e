// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of one face while they are being improved: a triangulation of a part of the chart's plane, with
// measures from the surface.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry.h"
#include "surface/chart.h"

namespace featuremesh {

/// Strictly, with a margin against rounding.
bool is_counterclockwise(Vec2 a, Vec2 b, Vec2 c);

/// The triangles' neighbours contradict one another, as they may where a face's border crosses itself within rounding.
struct BrokenPatch {};

/// Every triangle is counterclockwise in the chart, so the triangles never overlap on the surface. Lengths and angles
/// are taken between `places`: points of the surface, or of the chart itself where that is isometric.
struct TrianglePatch {
    std::vector<Vec2> points;  ///< in the chart
    std::vector<Vec3> places;
    std::vector<char> is_fixed;                  ///< on the boundary, or kept
    std::vector<double> wanted;                  ///< length of the sides at each point, mm
    std::vector<std::int32_t> nodes;             ///< the mesh's node at a boundary point; -1 for a new point
    std::vector<std::array<int, 3>> triangles;   ///< first corner -1: removed
    std::vector<std::array<int, 3>> neighbours;  ///< across the side opposite each corner; -1 at the boundary
    std::vector<int> triangle_of;                ///< one triangle at each point; -1 for none

    /// Whether two points are the same node: a pole, or the two copies of a seam.
    bool are_one_node(int p, int q) const {
        return nodes[static_cast<std::size_t>(p)] >= 0 &&
               nodes[static_cast<std::size_t>(p)] == nodes[static_cast<std::size_t>(q)];
    }
    /// A triangle with a side along a pole exists in the chart only.
    bool is_at_pole(int t) const {
        const auto& c = corners(t);
        return are_one_node(c[0], c[1]) || are_one_node(c[1], c[2]) || are_one_node(c[2], c[0]);
    }
    bool is_removed(int t) const { return triangles[static_cast<std::size_t>(t)][0] < 0; }
    const Vec2& point(int p) const { return points[static_cast<std::size_t>(p)]; }
    const Vec3& place(int p) const { return places[static_cast<std::size_t>(p)]; }
    const std::array<int, 3>& corners(int t) const { return triangles[static_cast<std::size_t>(t)]; }
    /// Position of point p among the corners of t.
    int corner_index(int t, int p) const {
        const auto& c = corners(t);
        return c[0] == p ? 0 : c[1] == p ? 1 : 2;
    }
    int neighbour(int t, int i) const { return neighbours[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)]; }
    /// Position, in triangle n, of the corner opposite its side to t.
    int opposite_index(int n, int t) const {
        const auto& list = neighbours[static_cast<std::size_t>(n)];
        return list[0] == t ? 0 : list[1] == t ? 1 : 2;
    }

    /// Whether the side opposite corner i of t can be turned within the chart: its two triangles form a strictly convex
    /// quadrilateral, and the new side joins two nodes.
    bool can_flip(int t, int i) const;
    void flip(int t, int i);
    /// The triangles around p, counterclockwise; for a boundary point from one boundary side to the other. Throws
    /// BrokenPatch when they go round and round elsewhere.
    void star(int p, std::vector<int>& triangles_around) const;
    /// Puts a new point into the triangle and returns it.
    int split_triangle(int t, Vec2 point, Vec3 place);
    /// Puts a new point on the side opposite corner i of t, which must not be at the boundary, and returns it.
    int split_side(int t, int i, Vec2 point, Vec3 place);
    /// Removes an inner point with three triangles.
    void remove_of_three(int p);
    /// Drops what was removed.
    void compact();

  private:
    void replace_neighbour(int t, int from, int to);
    int add_triangle(std::array<int, 3> corners, std::array<int, 3> around);
};

}  // namespace featuremesh

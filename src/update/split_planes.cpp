// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/split_planes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"
#include "core/messages.h"
#include "mesh/side_table.h"

namespace featuremesh {

namespace {

constexpr std::size_t many_edges = 10;
constexpr double thin_deg = 15;
/// Of the angle between the normals of two triangles in one plane, but for rounding.
constexpr double least_cosine = 1 - 1e-12;

/// CAD edges with two triangles in one plane at each of their segments.
std::size_t count_edges_within_planes(const Mesh& mesh) {
    SideTable segment_at(mesh.corner_count);
    std::size_t edge_count = 0;
    for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
        segment_at.value(mesh.segments[s][0], mesh.segments[s][1]) = static_cast<std::int32_t>(s);
        edge_count = std::max(edge_count, mesh.segment_edges[s].index() + 1);
    }
    enum class Edge : std::uint8_t { unknown, within_plane, between_planes };
    std::vector<Edge> edges(edge_count, Edge::unknown);
    std::vector<Vec3> first_normal(mesh.segments.size());
    std::vector<int> triangle_count(mesh.segments.size(), 0);
    for (const auto& triangle : mesh.triangles) {
        const auto& [a, b, c] = triangle;
        const Vec3 normal = normalized(cross(mesh.point(b) - mesh.point(a), mesh.point(c) - mesh.point(a)));
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t found = segment_at.find(triangle[i], triangle[(i + 1) % 3]);
            if (found < 0) continue;
            const auto segment = static_cast<std::size_t>(found);
            if (triangle_count[segment]++ == 0) {
                first_normal[segment] = normal;
                continue;
            }
            Edge& edge = edges[mesh.segment_edges[segment].index()];
            const bool is_flat = triangle_count[segment] == 2 && dot(first_normal[segment], normal) >= least_cosine;
            if (!is_flat)
                edge = Edge::between_planes;
            else if (edge == Edge::unknown)
                edge = Edge::within_plane;
        }
    }
    return static_cast<std::size_t>(std::count(edges.begin(), edges.end(), Edge::within_plane));
}

}  // namespace

std::optional<Message> warning_of_split_planes(const Mesh& mesh, const QualityReport& quality) {
    if (!quality.worst.is_valid() || quality.min_dihedral >= thin_deg) return {};
    const std::size_t edges = count_edges_within_planes(mesh);
    if (edges < many_edges) return {};
    return say<Code::planes_are_split>(edges);
}

}  // namespace featuremesh

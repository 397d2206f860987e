// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/split_planes.h"

#include <algorithm>
#include <array>
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
/// Sine of the angle up to which FreeCAD's *Refine shape* takes two planes for one.
constexpr double most_sine = 1e-7;

bool are_in_one_plane(const Vec3& normal, const Vec3& other) {
    return dot(normal, other) > 0 && length(cross(normal, other)) < most_sine;
}

/// CAD edges with two triangles in one plane at each of their segments.
class EdgesWithinPlanes {
  public:
    explicit EdgesWithinPlanes(const Mesh& mesh) : mesh_(mesh), segment_at_(mesh.corner_count) {
        std::size_t edge_count = 0;
        for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
            segment_at_.value(mesh.segments[s][0], mesh.segments[s][1]) = static_cast<std::int32_t>(s);
            edge_count = std::max(edge_count, mesh.segment_edges[s].index() + 1);
        }
        sides_.resize(edge_count);
        normals_.resize(mesh.segments.size());
        triangle_counts_.resize(mesh.segments.size());
        for (const auto& triangle : mesh.triangles) add(triangle);
    }

    std::size_t count() const {
        return static_cast<std::size_t>(std::count(sides_.begin(), sides_.end(), Sides::in_one_plane));
    }

    /// By node whether it is on one.
    std::vector<char> nodes() const {
        std::vector<char> are_on_one(mesh_.node_count(), 0);
        for (std::size_t s = 0; s < mesh_.segments.size(); ++s)
            if (sides_[mesh_.segment_edges[s].index()] == Sides::in_one_plane)
                for (const NodeId n : mesh_.segments[s]) are_on_one[n.index()] = 1;
        return are_on_one;
    }

  private:
    enum class Sides : std::uint8_t { unknown, in_one_plane, in_two };

    void add(const std::array<NodeId, 3>& triangle) {
        const auto& [a, b, c] = triangle;
        const Vec3 normal = normalized(cross(mesh_.point(b) - mesh_.point(a), mesh_.point(c) - mesh_.point(a)));
        for (std::size_t i = 0; i < 3; ++i)
            if (const std::int32_t s = segment_at_.find(triangle[i], triangle[(i + 1) % 3]); s >= 0)
                add_side(static_cast<std::size_t>(s), normal);
    }

    void add_side(std::size_t segment, const Vec3& normal) {
        const int before = triangle_counts_[segment]++;
        if (before == 0) {
            normals_[segment] = normal;
            return;
        }
        Sides& sides = sides_[mesh_.segment_edges[segment].index()];
        if (before > 1 || !are_in_one_plane(normals_[segment], normal))
            sides = Sides::in_two;
        else if (sides == Sides::unknown)
            sides = Sides::in_one_plane;
    }

    const Mesh& mesh_;
    SideTable segment_at_;
    std::vector<Sides> sides_;          // by edge
    std::vector<Vec3> normals_;         // by segment, of its first triangle
    std::vector<int> triangle_counts_;  // by segment, so far
};

/// Are most of the thin tets those that have a side on such nodes?
bool are_at(const std::vector<char>& nodes, const Mesh& mesh) {
    std::size_t thin = 0, thin_there = 0;
    for (const auto& tet : mesh.tets) {
        const auto& [a, b, c, d] = tet;
        if (dihedral_range(mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(d)).smallest_deg >= thin_deg)
            continue;
        ++thin;
        thin_there += std::count_if(tet.begin(), tet.end(), [&](NodeId n) { return nodes[n.index()] != 0; }) >= 2;
    }
    return 2 * thin_there >= thin;
}

}  // namespace

std::optional<Message> warning_of_split_planes(const Mesh& mesh, const QualityReport& quality) {
    if (!quality.worst.is_valid() || quality.min_dihedral >= thin_deg) return {};
    const EdgesWithinPlanes edges(mesh);
    if (edges.count() < many_edges || !are_at(edges.nodes(), mesh)) return {};
    return say<Code::planes_are_split>(edges.count());
}

}  // namespace featuremesh

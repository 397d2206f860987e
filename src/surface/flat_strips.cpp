// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/flat_strips.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/geometry.h"
#include "surface/edge_chains.h"

namespace featuremesh {

namespace {

constexpr double flat_cosine = 0.97;           // of the angle between the planes of two triangles
constexpr double least_angle = 2. / 3 * M_PI;  // at the node across the strip: less than 0.29 of the piece wide

using Piece = std::pair<std::uint64_t, EdgeId>;  ///< the key of its nodes, and its edge

/// A piece as a side of a triangle.
struct Side {
    std::uint64_t key;
    EdgeId edge;
    std::size_t triangle;
    NodeId first, last, across;
};

std::vector<Side> sides_on_edges(const Mesh& mesh) {
    std::vector<Piece> pieces;
    for (std::size_t s = 0; s < mesh.segments.size(); ++s)
        pieces.emplace_back(node_pair_key(mesh.segments[s][0], mesh.segments[s][1]), mesh.segment_edges[s]);
    std::sort(pieces.begin(), pieces.end());
    const auto is_on_edge = [&](NodeId n) { return mesh.entities[n.index()].dim <= 1; };
    std::vector<Side> sides;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& corners = mesh.triangles[t];
            const NodeId first = corners[k], last = corners[(k + 1) % 3];
            if (!is_on_edge(first) || !is_on_edge(last)) continue;
            const std::uint64_t key = node_pair_key(first, last);
            const auto piece = std::lower_bound(pieces.begin(), pieces.end(), Piece{key, EdgeId(0)});
            if (piece != pieces.end() && piece->first == key)
                sides.push_back({key, piece->second, t, first, last, corners[(k + 2) % 3]});
        }
    std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key < b.key; });
    return sides;
}

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

/// Whether the two triangles are in about one plane and their angles across the piece more than half a turn together.
bool is_missed(const Mesh& mesh, const Side& strip, const Side& beyond) {
    const Vec3 a = mesh.point(strip.first), b = mesh.point(strip.last);
    const Vec3 p = mesh.point(strip.across), q = mesh.point(beyond.across);
    const double at_strip = angle_between(a - p, b - p);
    if (at_strip < least_angle || at_strip + angle_between(a - q, b - q) <= M_PI) return false;
    const Vec3 n = cross(b - a, p - a), m = cross(q - a, b - a);
    return dot(n, m) > flat_cosine * length(n) * length(m);
}

}  // namespace

std::vector<std::array<EdgeId, 2>> edges_of_flat_strips(const Mesh& mesh, std::size_t first_new) {
    const std::vector<Side> sides = sides_on_edges(mesh);
    std::vector<std::array<EdgeId, 2>> found;
    for (const Side& strip : sides) {
        const Entity other = mesh.entities[strip.across.index()];
        if (strip.triangle < first_new || other.dim != 1 || other == entity_of(strip.edge)) continue;
        const auto of_piece = std::equal_range(sides.begin(), sides.end(), strip,
                                               [](const Side& a, const Side& b) { return a.key < b.key; });
        if (std::any_of(of_piece.first, of_piece.second, [&](const Side& beyond) {
                return beyond.triangle != strip.triangle && is_missed(mesh, strip, beyond);
            }))
            found.push_back({strip.edge, EdgeId(std::size_t(other.index))});
    }
    return found;
}

}  // namespace featuremesh

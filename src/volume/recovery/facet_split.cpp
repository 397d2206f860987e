// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/facet_split.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/sorted_pair.h"
#include "mesh/second_order.h"

namespace featuremesh {

namespace {

using NodePair = std::array<NodeId, 2>;

NodePair pair_of(const FacetSplit::Added& added, const Cavity& cavity) {
    return sorted_pair(cavity.nodes[added.edge[0]], cavity.nodes[added.edge[1]]);
}

/// The added points by the edge they are on.
std::map<NodePair, std::vector<int>> points_by_edge(const FacetSplit& split, const Cavity& cavity) {
    std::map<NodePair, std::vector<int>> by_edge;
    for (std::size_t i = 0; i < split.added.size(); ++i)
        if (split.added[i].edge[0] >= 0) by_edge[pair_of(split.added[i], cavity)].push_back(static_cast<int>(i));
    return by_edge;
}

/// Cuts the triangle (a, b, c) at given points of its sides (-1: not cut), keeping its turn.
void cut_triangle(std::array<int, 3> corners, std::array<int, 3> mids, int facet,
                  std::vector<FacetSplit::Piece>& pieces) {
    const auto count = std::count_if(mids.begin(), mids.end(), [](int m) { return m >= 0; });
    if (count == 0) return;
    const auto rotate_until = [&](auto is_right) {
        while (!is_right()) {
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
            std::rotate(mids.begin(), mids.begin() + 1, mids.end());
        }
    };
    const auto add = [&](int a, int b, int c) { pieces.push_back({{a, b, c}, facet}); };
    if (count == 3) {
        for (int k = 0; k < 3; ++k) add(corners[k], mids[k], mids[(k + 2) % 3]);
        return add(mids[0], mids[1], mids[2]);
    }
    if (count == 1) {
        rotate_until([&] { return mids[0] >= 0; });
        add(corners[0], mids[0], corners[2]);
        return add(mids[0], corners[1], corners[2]);
    }
    rotate_until([&] { return mids[2] < 0; });
    add(mids[0], corners[1], mids[1]);
    add(corners[0], mids[0], mids[1]);
    add(corners[0], mids[1], corners[2]);
}

/// A segment with added points on it.
struct CutSegment {
    std::size_t segment;
    std::vector<int> points;
};

std::vector<CutSegment> cut_segments_of(const FacetSplit& split, const Cavity& cavity, const Mesh& mesh) {
    std::vector<CutSegment> cut;
    const auto by_edge = points_by_edge(split, cavity);
    if (by_edge.empty()) return cut;
    for (std::size_t i = 0; i < mesh.segments.size(); ++i) {
        const auto found = by_edge.find(sorted_pair(mesh.segments[i][0], mesh.segments[i][1]));
        if (found != by_edge.end()) cut.push_back({i, found->second});
    }
    return cut;
}

/// By added point: the CAD edge whose segment or a CAD face whose triangles have it.
std::vector<Entity> entities_of_points(const FacetSplit& split, const std::vector<CutSegment>& cut,
                                       const Cavity& cavity, const Mesh& mesh) {
    std::vector<Entity> entities(split.added.size());
    const int given = static_cast<int>(cavity.points.size());
    for (const auto& piece : split.pieces)
        for (const int c : piece.corners)
            if (c >= given)
                entities[c - given] = entity_of(mesh.triangle_faces[cavity.triangle_of_facet[piece.facet].index()]);
    for (const CutSegment& segment : cut)
        for (const int point : segment.points) entities[point] = entity_of(mesh.segment_edges[segment.segment]);
    return entities;
}

/// A point nearer to its entity than `on_entity` stays, so that exact decisions about it hold.
NodeId add_node(const Vec3& point, Entity entity, const Projector& projector, double on_entity, Mesh& mesh) {
    if (entity.dim == 1) {
        const OnEdge on = projector.nearest(EdgeId(entity.index), point);
        return mesh.add_node(on.distance < on_entity ? point : on.point, entity, {on.t, 0});
    }
    const OnFace on = projector.nearest(FaceId(entity.index), point);
    return mesh.add_node(on.distance < on_entity ? point : on.point, entity, on.uv);
}

void cut_segments(const FacetSplit& split, std::vector<CutSegment> cut, const std::vector<NodeId>& nodes, Mesh& mesh) {
    for (auto& [i, along] : cut) {
        const NodeId first = mesh.segments[i][0], last = mesh.segments[i][1];
        const Vec3 direction = mesh.point(last) - mesh.point(first);
        std::sort(along.begin(), along.end(), [&](int a, int b) {
            return dot(direction, split.added[a].point) < dot(direction, split.added[b].point);
        });
        mesh.segments[i][1] = nodes[along.front()];
        mesh.segment_numbers[i] = mesh.next_element_number++;
        for (std::size_t k = 0; k < along.size(); ++k)
            mesh.add_segment({nodes[along[k]], k + 1 < along.size() ? nodes[along[k + 1]] : last},
                             mesh.segment_edges[i]);
    }
}

void cut_triangles(const FacetSplit& split, const Cavity& cavity, const std::vector<NodeId>& nodes, Mesh& mesh) {
    const int given = static_cast<int>(cavity.points.size());
    int cut = -1;
    bool is_reversed = false;
    for (const auto& piece : split.pieces) {
        const std::size_t triangle = cavity.triangle_of_facet[piece.facet].index();
        const bool is_first = piece.facet != cut;
        if (is_first) is_reversed = is_odd(mesh.triangles[triangle]) != is_odd(cavity.facets[piece.facet].corners);
        std::array<NodeId, 3> corners;
        for (int k = 0; k < 3; ++k)
            corners[k] = piece.corners[k] < given ? cavity.nodes[piece.corners[k]] : nodes[piece.corners[k] - given];
        if (is_reversed) std::swap(corners[1], corners[2]);
        if (is_first) {
            mesh.triangles[triangle] = corners;
            mesh.triangle_numbers[triangle] = mesh.next_element_number++;
        } else {
            mesh.add_triangle(corners, mesh.triangle_faces[triangle]);
        }
        cut = piece.facet;
    }
}

}  // namespace

FacetSplit halve_longest_edges(const Cavity& cavity, std::span<const int> facets) {
    FacetSplit split;
    std::map<std::array<int, 2>, int> point_on;
    for (const int facet : facets) {
        const auto& c = cavity.facets[facet].corners;
        int longest = 0;
        for (int k = 1; k < 3; ++k)
            if (distance(cavity.points[c[k]], cavity.points[c[(k + 1) % 3]]) >
                distance(cavity.points[c[longest]], cavity.points[c[(longest + 1) % 3]]))
                longest = k;
        const auto edge = sorted_pair(c[longest], c[(longest + 1) % 3]);
        if (!point_on.emplace(edge, static_cast<int>(cavity.points.size() + split.added.size())).second) continue;
        split.added.push_back({(cavity.points[edge[0]] + cavity.points[edge[1]]) * 0.5, edge, -1});
    }
    for (std::size_t i = 0; i < cavity.facets.size(); ++i) {
        const auto& c = cavity.facets[i].corners;
        std::array<int, 3> mids;
        for (int k = 0; k < 3; ++k) {
            const auto found = point_on.find(sorted_pair(c[k], c[(k + 1) % 3]));
            mids[k] = found == point_on.end() ? -1 : found->second;
        }
        cut_triangle(c, mids, static_cast<int>(i), split.pieces);
    }
    return split;
}

std::vector<TetId> tets_in_the_way(const FacetSplit& split, const Cavity& cavity, const Mesh& mesh,
                                   std::span<const std::uint8_t> is_released,
                                   std::optional<std::span<const TetId>> near) {
    std::set<NodePair> edges;
    std::set<std::array<NodeId, 3>> triangles;
    std::vector<std::uint8_t> is_touched(mesh.node_count(), 0);
    const auto touch = [&](NodeId n) { is_touched[n.index()] = 1; };
    for (const auto& added : split.added)
        if (added.edge[0] >= 0) {
            const NodePair pair = pair_of(added, cavity);
            edges.insert(pair), touch(pair[0]), touch(pair[1]);
        }
    for (const auto& piece : split.pieces) {
        const auto& c = cavity.facets[piece.facet].corners;
        std::array<NodeId, 3> nodes{cavity.nodes[c[0]], cavity.nodes[c[1]], cavity.nodes[c[2]]};
        std::sort(nodes.begin(), nodes.end());
        triangles.insert(nodes);
        for (const NodeId n : nodes) touch(n);
    }
    const auto is_cut = [&](std::array<NodeId, 4> tet) {
        std::sort(tet.begin(), tet.end());
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j)
                if (edges.contains({tet[i], tet[j]})) return true;
        return triangles.contains({tet[1], tet[2], tet[3]}) || triangles.contains({tet[0], tet[2], tet[3]}) ||
               triangles.contains({tet[0], tet[1], tet[3]}) || triangles.contains({tet[0], tet[1], tet[2]});
    };
    std::vector<TetId> found;
    const std::size_t count = near ? near->size() : mesh.tets.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t t = near ? (*near)[i].index() : i;
        if (!is_released.empty() && is_released[t]) continue;
        int touched = 0;
        for (const NodeId n : mesh.tets[t]) touched += is_touched[n.index()];
        if (touched >= 2 && is_cut(mesh.tets[t])) found.push_back(TetId(t));
    }
    return found;
}

std::vector<NodeId> apply_split(const FacetSplit& split, const Cavity& cavity, const Projector& projector,
                                double on_entity, Mesh& mesh, const RunContext& context) {
    std::vector<CutSegment> cut = cut_segments_of(split, cavity, mesh);
    const std::vector<Entity> entities = entities_of_points(split, cut, cavity, mesh);
    std::vector<NodeId> nodes;
    for (std::size_t i = 0; i < split.added.size(); ++i) {
        context.check_cancelled();
        nodes.push_back(add_node(split.added[i].point, entities[i], projector, on_entity, mesh));
    }
    cut_segments(split, std::move(cut), nodes, mesh);
    cut_triangles(split, cavity, nodes, mesh);
    mesh.corner_count = mesh.points.size();
    return nodes;
}

}  // namespace featuremesh

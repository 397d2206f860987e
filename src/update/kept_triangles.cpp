// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/kept_triangles.h"

#include <algorithm>

#include "core/geometry.h"
#include "core/ids.h"
#include "core/sort_once.h"
#include "difference/feature_difference.h"
#include "update/kept_tets.h"

namespace featuremesh {

namespace {

std::vector<VertexId> vertices_of(const Brep& brep, FaceId face) {
    std::vector<VertexId> vertices(brep.vertices_inside(face).begin(), brep.vertices_inside(face).end());
    for (const EdgeId edge : brep.edges_of(face))
        for (const VertexId end : brep.ends_of(edge))
            if (end.is_valid()) vertices.push_back(end);
    sort_once(vertices);
    return vertices;
}

bool has_same_border(const KeepInput& input, FaceId was, FaceId is) {
    if (input.old_brep.edges_of(was).size() != input.new_brep.edges_of(is).size()) return false;
    std::vector<VertexId> images;
    for (const VertexId v : vertices_of(input.old_brep, was))
        images.push_back(input.difference.regions[0].new_vertex_of[v.index()]);
    std::sort(images.begin(), images.end());
    return images == vertices_of(input.new_brep, is);
}

std::size_t place_of(FaceId face) { return face.index(); }
std::size_t place_of(const Brep& brep, EdgeId edge) { return brep.face_count() + edge.index(); }

/// Calls visit(node, place) for every node of every triangle on a free face and segment on a free edge, as often as it
/// is in one.
template <class Visit>
void for_each_node(const Mesh& mesh, const Brep& brep, Visit visit) {
    for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
        if (!brep.is_free(mesh.segment_edges[s])) continue;
        for (const NodeId n : mesh.segments[s]) visit(n.index(), place_of(brep, mesh.segment_edges[s]));
        if (mesh.order == 2) visit(mesh.segment_mids[s].index(), place_of(brep, mesh.segment_edges[s]));
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!brep.is_free(mesh.triangle_faces[t])) continue;
        for (const NodeId n : mesh.triangles[t]) visit(n.index(), place_of(mesh.triangle_faces[t]));
        if (mesh.order == 2)
            for (const NodeId n : mesh.triangle_mids[t]) visit(n.index(), place_of(mesh.triangle_faces[t]));
    }
}

std::vector<char> nodes_of_free(const KeepInput& input) {
    std::vector<char> is_of(input.old_mesh.node_count(), 0);
    for_each_node(input.old_mesh, input.old_brep, [&](std::size_t n, std::size_t) { is_of[n] = 1; });
    return is_of;
}

/// By motion and old node: whether it would be near what changed under that.
using NearChanges = std::vector<std::vector<char>>;

NearChanges find_near_changes(const KeepInput& input, RunContext& context) {
    const auto& regions = input.difference.regions;
    const std::size_t nodes = input.old_mesh.node_count();
    NearChanges is_near(regions.size(), std::vector<char>(nodes, 0));
    const std::vector<char> is_asked = nodes_of_free(input);
    parallel_for(context, nodes, 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n)
            for (std::size_t r = 0; is_asked[n] && r < regions.size(); ++r) {
                const Vec3 p = regions[r].motion.apply(input.old_mesh.points[n]);
                const double limit = input.margin * input.new_sizing.at(p);
                is_near[r][n] = regions[r].changed.is_within(limit, p);
            }
    });
    return is_near;
}

std::vector<std::int32_t> motions_of_entities(const KeepInput& input, const NearChanges& is_near,
                                              std::span<const char> is_untouched) {
    std::vector<std::vector<std::size_t>> counts(is_untouched.size(), std::vector<std::size_t>(is_near.size(), 0));
    for_each_node(input.old_mesh, input.old_brep, [&](std::size_t n, std::size_t entity) {
        for (std::size_t r = 0; r < is_near.size(); ++r) counts[entity][r] += std::size_t(is_near[r][n]);
    });
    std::vector<std::int32_t> motions;
    for (std::size_t e = 0; e < counts.size(); ++e) {
        const auto least = std::min_element(counts[e].begin(), counts[e].end());
        motions.push_back(is_untouched[e] ? 0 : std::int32_t(least - counts[e].begin()));
    }
    return motions;
}

}  // namespace

std::vector<std::int32_t> motions_without_tets(const KeepInput& input, std::span<const char> is_untouched,
                                               RunContext& context) {
    std::vector<std::int32_t> motions(input.old_mesh.node_count(), 0);
    if (input.difference.regions.size() < 2) return motions;
    const NearChanges is_near = find_near_changes(input, context);
    const std::vector<std::int32_t> of_entity = motions_of_entities(input, is_near, is_untouched);
    constexpr std::int32_t open = -1, divided = -2;
    std::vector<std::int32_t> wanted(motions.size(), open);
    for_each_node(input.old_mesh, input.old_brep, [&](std::size_t n, std::size_t entity) {
        wanted[n] = wanted[n] == open || wanted[n] == of_entity[entity] ? of_entity[entity] : divided;
    });
    const std::vector<char> in_untouched = nodes_on(input, is_untouched);
    for (std::size_t n = 0; n < motions.size(); ++n) {
        if (wanted[n] > 0) motions[n] = wanted[n];
        if (wanted[n] > 0 || wanted[n] == open || in_untouched[n] || !is_near[0][n]) continue;
        for (std::size_t r = 1; r < is_near.size() && motions[n] == 0; ++r)
            if (!is_near[r][n]) motions[n] = std::int32_t(r);
    }
    return motions;
}

std::vector<char> untouched_entities(const KeepInput& input) {
    const Brep& was = input.old_brep;
    std::vector<char> is_untouched(was.face_count() + was.edge_count(), 0);
    if (was.has_free_edges())
        for (const EdgeChange& change : edge_changes(input.difference, was, input.new_brep))
            if (change.verdict == BoundaryVerdict::kept && was.is_free(change.old_edge))
                is_untouched[place_of(was, change.old_edge)] = 1;
    for (const FaceChange& change : input.difference.faces)
        if (change.verdict == BoundaryVerdict::kept && was.is_free(change.old_face) &&
            has_same_border(input, change.old_face, change.new_face))
            is_untouched[place_of(change.old_face)] = 1;
    return is_untouched;
}

std::vector<char> nodes_on(const KeepInput& input, std::span<const char> is_untouched) {
    std::vector<char> is_on(input.old_mesh.node_count(), 0);
    for_each_node(input.old_mesh, input.old_brep,
                  [&](std::size_t n, std::size_t entity) { is_on[n] |= is_untouched[entity]; });
    return is_on;
}

KeptShells::KeptShells(const KeepInput& input, std::span<const std::int32_t> motions, std::span<const char> near_change,
                       std::span<const char> is_untouched)
    : is_kept_(input.old_mesh.triangles.size(), 0), is_used_(input.old_mesh.node_count(), 0) {
    const Mesh& old = input.old_mesh;
    for (std::size_t t = 0; t < is_kept_.size(); ++t) {
        const FaceId face = old.triangle_faces[t];
        if (!input.old_brep.is_free(face)) continue;
        const std::int32_t motion = motions[old.triangles[t][0].index()];
        const bool minds_changes = !near_change.empty() && !is_untouched[place_of(face)];
        const auto stays = [&](NodeId n) {
            return motions[n.index()] == motion && !(minds_changes && near_change[n.index()]);
        };
        const auto all_stay = [&](const auto& nodes) { return std::all_of(nodes.begin(), nodes.end(), stays); };
        if (motion == dropped || !all_stay(old.triangles[t]) || (old.order == 2 && !all_stay(old.triangle_mids[t])))
            continue;
        is_kept_[t] = 1;
        for (const NodeId n : old.triangles[t]) is_used_[n.index()] = 1;
        if (old.order == 2)
            for (const NodeId n : old.triangle_mids[t]) is_used_[n.index()] = 1;
    }
    for (std::size_t s = 0; s < old.segments.size(); ++s) {
        if (!input.old_brep.is_free(old.segment_edges[s])) continue;
        const auto use = [&](NodeId n) { is_used_[n.index()] |= motions[n.index()] != dropped; };
        for (const NodeId n : old.segments[s]) use(n);
        if (old.order == 2) use(old.segment_mids[s]);
    }
}

}  // namespace featuremesh

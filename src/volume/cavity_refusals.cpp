// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/cavity_refusals.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "core/geometry.h"
#include "core/messages.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

std::vector<Entity> faces_of(const Mesh& mesh, const Cavity& cavity, std::span<const int> facets) {
    std::set<FaceId> faces;
    for (const int facet : facets)
        if (const TriangleId t = cavity.triangle_of_facet[facet]; t.is_valid())
            faces.insert(mesh.triangle_faces[t.index()]);
    return as_parameter(faces);
}

std::vector<FaceId> nearest_faces(const Brep& brep, const Mesh& mesh, const Cavity& cavity,
                                  const std::array<int, 4>& tet) {
    std::map<FaceId, int> counts;
    for (const int corner : tet) {
        if (corner >= static_cast<int>(cavity.nodes.size())) continue;
        for (const FaceId face : brep.faces_at(mesh.entities[cavity.nodes[corner].index()])) ++counts[face];
    }
    int most = 0;
    for (const auto& [face, count] : counts) most = std::max(most, count);
    std::vector<FaceId> nearest;
    for (const auto& [face, count] : counts)
        if (count == most) nearest.push_back(face);
    return nearest;
}

namespace {

/// Half the longest edge of each of the facets that are triangles.
std::vector<SizeSource> half_lengths_at(const Cavity& cavity, std::span<const int> facets) {
    std::vector<SizeSource> halves;
    for (const int facet : facets) {
        if (!cavity.triangle_of_facet[facet].is_valid()) continue;
        const auto& [i, j, k] = cavity.facets[facet].corners;
        const Vec3 &a = cavity.points[i], &b = cavity.points[j], &c = cavity.points[k];
        halves.push_back({(a + b + c) / 3, 0.5 * std::max({distance(a, b), distance(b, c), distance(c, a)})});
    }
    return halves;
}

}  // namespace

std::optional<Obstacle> if_open(const Mesh& mesh, const Cavity& cavity) {
    const std::vector<int> open = open_facets(cavity);
    if (open.empty()) return {};
    const std::vector<Entity> place = faces_of(mesh, cavity, open);
    return Obstacle{say<Code::surface_not_closed>(place), place};
}

Obstacle in_one_plane(const Mesh& mesh, const Cavity& cavity, std::span<const int> missing) {
    const std::vector<Entity> place = faces_of(mesh, cavity, missing);
    return {say<Code::nodes_in_one_plane>(place), place, half_lengths_at(cavity, missing)};
}

void require_distinct(const Brep& brep, const Mesh& mesh, const Cavity& cavity) {
    std::vector<std::size_t> order(cavity.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto place = [&](std::size_t i) {
        const Vec3& p = cavity.points[i];
        return std::tuple(p.x, p.y, p.z);
    };
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return std::pair(place(a), a) < std::pair(place(b), b); });
    std::set<FaceId> faces;
    Vec3 last;
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (place(order[i - 1]) != place(order[i])) continue;
        last = cavity.points[order[i]];
        for (const std::size_t n : {order[i - 1], order[i]})
            for (const FaceId face : brep.faces_at(mesh.entities[cavity.nodes[n].index()])) faces.insert(face);
    }
    if (!faces.empty()) throw MeshError(say<Code::shape_touches_itself>(faces, last));
}

Obstacle cut_one_another(const Mesh& mesh, const Cavity& cavity, std::span<const int> crossing) {
    const Vec3& point = cavity.points[std::size_t(cavity.facets[std::size_t(crossing.front())].corners[0])];
    const std::vector<Entity> place = faces_of(mesh, cavity, crossing);
    return {say<Code::triangles_cut>(place, point), place, half_lengths_at(cavity, crossing)};
}

Obstacle unrecovered(const Mesh& mesh, std::span<const Cavity> cavities, std::span<const CavityFill> fills) {
    Obstacle obstacle;
    std::set<Entity> faces;  // two cavities may meet the same
    for (std::size_t i = 0; i < cavities.size(); ++i) {
        const std::vector<int>& missing = fills[i].places.missing;
        if (fills[i].is_complete()) continue;
        const std::vector<Entity> own = faces_of(mesh, cavities[i], missing);
        faces.insert(own.begin(), own.end());
        for (const SizeSource& half : half_lengths_at(cavities[i], missing)) obstacle.shorter.push_back(half);
    }
    obstacle.place.assign(faces.begin(), faces.end());
    obstacle.message = say<Code::triangles_not_met>(obstacle.place);
    return obstacle;
}

}  // namespace featuremesh

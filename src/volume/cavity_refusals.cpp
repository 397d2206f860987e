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
#include "core/numbers_in_words.h"

namespace featuremesh {

std::string names_of_faces(const Mesh& mesh, const Cavity& cavity, std::span<const int> facets) {
    std::set<FaceId> faces;
    for (const int facet : facets)
        if (const TriangleId t = cavity.triangle_of_facet[facet]; t.is_valid())
            faces.insert(mesh.triangle_faces[t.index()]);
    std::string names;
    for (const FaceId face : faces) names += (names.empty() ? "" : ", ") + name_of(entity_of(face));
    return names.empty() ? "the surface" : names;
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
    const std::string place = names_of_faces(mesh, cavity, open);
    return Obstacle{"the surface mesh does not close at " + place + "; check the shape there, or try another size",
                    place};
}

Obstacle in_one_plane(const Mesh& mesh, const Cavity& cavity, std::span<const int> missing) {
    const std::string place = names_of_faces(mesh, cavity, missing);
    return {"all nodes to fill between lie in one plane, at " + place + "; mesh the part finer", place,
            half_lengths_at(cavity, missing)};
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
    if (faces.empty()) return;
    std::string names;
    std::size_t listed = 0;
    for (const FaceId face : faces)
        if (listed++ < 6) names += (names.empty() ? "" : ", ") + name_of(entity_of(face));
    throw MeshError("the shape touches itself: nodes of " + names + " lie in the same place, such as " +
                    in_words(last) + "; repair it there (Part: Check geometry)");
}

Obstacle cut_one_another(const Mesh& mesh, const Cavity& cavity, std::span<const int> crossing) {
    const Vec3& point = cavity.points[std::size_t(cavity.facets[std::size_t(crossing.front())].corners[0])];
    const std::string place = names_of_faces(mesh, cavity, crossing);
    return {"triangles of " + place + " near " + in_words(point) +
                " cut one another; the shape may touch or cut itself there: repair it, or mesh finer there",
            place, half_lengths_at(cavity, crossing)};
}

Obstacle unrecovered(const Mesh& mesh, std::span<const Cavity> cavities, std::span<const CavityFill> fills) {
    Obstacle obstacle;
    for (std::size_t i = 0; i < cavities.size(); ++i) {
        const std::vector<int>& missing = fills[i].places.missing;
        if (fills[i].is_complete()) continue;
        obstacle.place += (obstacle.place.empty() ? "" : ", ") + names_of_faces(mesh, cavities[i], missing);
        for (const SizeSource& half : half_lengths_at(cavities[i], missing)) obstacle.shorter.push_back(half);
    }
    obstacle.message = "the volume mesh cannot be made to meet the triangles of " + obstacle.place +
                       "; mesh finer there, or check the shape for faces that cut or touch one another";
    return obstacle;
}

}  // namespace featuremesh

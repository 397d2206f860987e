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

void require_closed(const Mesh& mesh, const Cavity& cavity) {
    const std::vector<int> open = open_facets(cavity);
    if (open.empty()) return;
    throw MeshError("the surface mesh does not close at " + names_of_faces(mesh, cavity, open) +
                    "; check the shape there, or try another size");
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

MeshError cut_one_another(const Mesh& mesh, const Cavity& cavity, std::span<const int> crossing) {
    const Vec3& place = cavity.points[std::size_t(cavity.facets[std::size_t(crossing.front())].corners[0])];
    return MeshError("triangles of " + names_of_faces(mesh, cavity, crossing) + " near " + in_words(place) +
                     " cut one another; the shape may touch or cut itself there: repair it, or mesh finer there");
}

MeshError unrecovered(const Mesh& mesh, std::span<const Cavity> cavities, std::span<const CavityFill> fills) {
    std::string faces;
    for (std::size_t i = 0; i < cavities.size(); ++i)
        if (!fills[i].is_complete())
            faces += (faces.empty() ? "" : ", ") + names_of_faces(mesh, cavities[i], fills[i].places.missing);
    return MeshError("the volume mesh cannot be made to meet the triangles of " + faces +
                     "; mesh finer there, or check the shape for faces that cut or touch one another");
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/thin_tets.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "brep/brep.h"
#include "core/ids.h"
#include "core/messages.h"
#include "core/numbers_in_words.h"
#include "mesh/short_sides.h"
#include "update/split_planes.h"

namespace featuremesh {

namespace {

/// Thinner tets than this tell of details of the part that no mesh of the wanted size can follow.
constexpr double thin_deg = 2;

Entity lowest_entity(const Mesh& mesh, TetId tet) {
    Entity lowest;
    for (const NodeId n : mesh.tets[tet.index()]) lowest = std::min(lowest, mesh.entities[n.index()]);
    return lowest;
}

/// "Edge12 (4e-05 mm long)", "Edge3 and Edge7 (0.0001 mm apart)", by length.
class ForcingDetails {
    using Entities = std::vector<Entity>;  // an edge, or the two that are near

  public:
    explicit ForcingDetails(const Mesh& mesh) : mesh_(mesh), short_sides_(mesh) {
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            const auto side = short_sides_.forced_side(TetId(t));  // hardly any has one, and angles cost more
            if (!side) continue;
            const auto& [a, b, c, d] = mesh.tets[t];
            if (dihedral_range(mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(d)).smallest_deg < thin_deg)
                add((*side)[0], (*side)[1]);
        }
    }

    std::size_t tet_count() const { return tet_count_; }
    bool force(TetId tet) const { return short_sides_.forced_side(tet).has_value(); }

    std::vector<Message> listed() const {
        constexpr std::size_t most = 4;
        std::vector<std::pair<double, Entities>> details;
        for (const auto& [entities, length] : length_of_) details.emplace_back(length, entities);
        std::sort(details.begin(), details.end());
        std::vector<Message> lines;
        for (const auto& [length, entities] : details) {
            if (lines.size() == most) {
                lines.push_back(say<Code::and_others>());
                break;
            }
            const Length shown{rounded(length, 2)};
            lines.push_back(entities.size() == 1 ? say<Code::edge_of_length>(entities, shown)
                                                 : say<Code::pair_apart>(entities[0], entities[1], shown));
        }
        return lines;
    }

  private:
    void add(NodeId a, NodeId b) {
        ++tet_count_;
        const std::int32_t segment = short_sides_.segment_at(a, b);
        const auto [low, high] = std::minmax(mesh_.entities[a.index()], mesh_.entities[b.index()]);
        const Entities between =
            segment >= 0 ? as_parameter(mesh_.segment_edges[static_cast<std::size_t>(segment)]) : Entities{low, high};
        const double length = distance(mesh_.point(a), mesh_.point(b));
        const auto [it, is_new] = length_of_.try_emplace(between, length);
        if (!is_new) it->second = std::min(it->second, length);
    }

    const Mesh& mesh_;
    ShortSides short_sides_;
    std::map<Entities, double> length_of_;
    std::size_t tet_count_ = 0;
};

/// The faces that each corner of the tet is on.
std::array<std::set<FaceId>, 4> faces_at_corners(const Mesh& mesh, TetId tet) {
    std::array<std::set<FaceId>, 4> faces;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const NodeId n : mesh.triangles[t])
            for (std::size_t i = 0; i < 4; ++i)
                if (mesh.tets[tet.index()][i] == n) faces[i].insert(mesh.triangle_faces[t]);
    return faces;
}

/// The edges and vertices of a face.
std::set<Entity> border_of(const Mesh& mesh, const ShortSides& sides, FaceId face) {
    std::set<Entity> border;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.triangle_faces[t] != face) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const NodeId a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
            if (mesh.entities[a.index()].dim == 0) border.insert(mesh.entities[a.index()]);
            const std::int32_t segment = sides.segment_at(a, b);
            if (segment >= 0) border.insert(entity_of(mesh.segment_edges[static_cast<std::size_t>(segment)]));
        }
    }
    return border;
}

/// Have they a vertex in common and no edge? Then the faces touch each other there.
bool touch(const std::set<Entity>& one, const std::set<Entity>& other) {
    std::vector<Entity> common;
    std::set_intersection(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(common));
    return !common.empty() && common.back().dim == 0;
}

/// Two faces that touch each other and between which the tet lies; empty where there are none.
std::vector<Entity> touching_faces(const Mesh& mesh, TetId tet) {
    const auto at_corners = faces_at_corners(mesh, tet);
    const ShortSides sides(mesh);
    std::map<FaceId, std::set<Entity>> borders;
    for (const auto& faces : at_corners)
        for (const FaceId face : faces)
            if (borders.count(face) == 0) borders[face] = border_of(mesh, sides, face);
    for (const auto& [a, border_of_a] : borders)
        for (const auto& [b, border_of_b] : borders) {
            const auto is_on = [a = a, b = b](const auto& faces) { return faces.count(a) > 0 || faces.count(b) > 0; };
            if (a < b && std::all_of(at_corners.begin(), at_corners.end(), is_on) && touch(border_of_a, border_of_b))
                return {entity_of(a), entity_of(b)};
        }
    return {};
}

}  // namespace

std::vector<Message> warnings_of_thin_tets(const Mesh& mesh, const QualityReport& quality) {
    std::vector<Message> lines;
    if (auto line = warning_of_split_planes(mesh, quality)) lines.push_back(std::move(*line));
    if (!quality.worst.is_valid() || quality.min_dihedral >= thin_deg) return lines;
    const ForcingDetails details(mesh);
    if (details.tet_count() > 0)
        lines.push_back(say<Code::details_force_angles>(details.tet_count(), details.listed()));
    if (details.force(quality.worst)) return lines;
    const double angle = rounded(quality.min_dihedral, 2);
    const std::vector<Entity> faces = touching_faces(mesh, quality.worst);
    lines.push_back(faces.empty() ? say<Code::smallest_angle>(angle, lowest_entity(mesh, quality.worst))
                                  : say<Code::faces_touch>(faces[0], faces[1], angle));
    return lines;
}

}  // namespace featuremesh

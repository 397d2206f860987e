// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_warnings.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "brep/solid_probe.h"
#include "core/dimension.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/messages.h"

namespace featuremesh {

namespace {

/// So many pairs are told of.
constexpr std::size_t most_pairs = 4;

template <class Pairs, class Say>
std::vector<Message> first_of(const Pairs& pairs, Say say_pair) {
    std::vector<Message> lines;
    for (const auto& pair : pairs) {
        if (lines.size() == most_pairs) {
            lines.push_back(say<Code::and_others>());
            break;
        }
        lines.push_back(say_pair(pair));
    }
    return lines;
}

/// Two faces whose triangles cross, how often, and the first triangle of the first of them that does.
struct FacePair {
    FaceId first, second;
    TriangleId where;
    std::size_t crossings = 0;
};

/// The pairs of faces whose triangles cross, most often first: faces that lie on one another before those that only
/// meet in an edge.
std::vector<FacePair> pairs_of(const Mesh& mesh, const TrianglePairs& crossings) {
    std::map<std::pair<FaceId, FaceId>, FacePair> found;
    for (const auto& [t, u] : crossings) {
        const auto [f, g] = std::minmax(mesh.triangle_faces[t.index()], mesh.triangle_faces[u.index()]);
        ++found.try_emplace({f, g}, FacePair{f, g, t}).first->second.crossings;
    }
    std::vector<FacePair> pairs;
    for (const auto& entry : found) pairs.push_back(entry.second);
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const auto& a, const auto& b) { return a.crossings > b.crossings; });
    return pairs;
}

}  // namespace

std::vector<Message> faces_that_cross(const Mesh& mesh, const TrianglePairs& crossings) {
    return first_of(pairs_of(mesh, crossings), [](const FacePair& pair) {
        return pair.first == pair.second ? say<Code::with_itself>(pair.first)
                                         : say<Code::pair>(pair.first, pair.second);
    });
}

std::vector<Message> places_of_crossings(const Mesh& mesh, const TrianglePairs& crossings) {
    return first_of(pairs_of(mesh, crossings), [&](const FacePair& pair) {
        const auto& [a, b, c] = mesh.triangles[pair.where.index()];
        const Vec3 place = (mesh.point(a) + mesh.point(b) + mesh.point(c)) / 3;
        return pair.first == pair.second ? say<Code::with_itself_near>(pair.first, place)
                                         : say<Code::pair_near>(pair.first, pair.second, place);
    });
}

namespace {

Message warning_of_contact(const Brep& brep, const Mesh& mesh, const TrianglePairs& crossings) {
    const std::vector<Message> faces = faces_that_cross(mesh, crossings);
    const auto is_shell = [&](TriangleId t) { return brep.is_free(mesh.triangle_faces[t.index()]); };
    if (std::any_of(crossings.begin(), crossings.end(),
                    [&](const auto& pair) { return is_shell(pair[0]) || is_shell(pair[1]); }))
        return say<Code::sheets_touch>(faces);
    std::set<std::pair<SolidId, SolidId>> solids;
    for (const auto& [t, u] : crossings) {
        const auto solid = [&](TriangleId triangle) {
            const auto beside = brep.solids_beside(mesh.triangle_faces[triangle.index()]);
            return beside[0].is_valid() ? beside[0] : beside[1];
        };
        solids.insert(std::minmax(solid(t), solid(u)));
    }
    const auto say_pair = [](const auto& pair) { return say<Code::pair>(pair.first, pair.second); };
    return say<Code::solids_touch>(first_of(solids, say_pair), faces);
}

/// Shells and beams whose first element has its middle inside a solid that does not know them.
std::vector<Message> warnings_of_enclosed(const Brep& brep, const Mesh& mesh) {
    std::vector<std::unique_ptr<SolidProbe>> probes(brep.solid_count());
    std::vector<Message> places;
    const auto look = [&](Entity entity, const Vec3& p) {
        for (std::size_t s = 0; s < probes.size(); ++s) {
            if (!probes[s]) probes[s] = std::make_unique<SolidProbe>(brep, SolidId(s));
            if (probes[s]->containment_of(p) != Containment::inside) continue;
            places.push_back(say<Code::one_in_other>(entity, SolidId(s)));
            return;
        }
    };
    std::vector<char> is_seen_face(brep.face_count(), 0), is_seen_edge(brep.edge_count(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const FaceId face = mesh.triangle_faces[t];
        if (!brep.is_free(face) || std::exchange(is_seen_face[face.index()], 1)) continue;
        const auto& [a, b, c] = mesh.triangles[t];
        look(entity_of(face), (mesh.point(a) + mesh.point(b) + mesh.point(c)) / 3);
    }
    for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
        const EdgeId edge = mesh.segment_edges[s];
        if (!brep.is_free(edge) || std::exchange(is_seen_edge[edge.index()], 1)) continue;
        look(entity_of(edge), (mesh.point(mesh.segments[s][0]) + mesh.point(mesh.segments[s][1])) / 2);
    }
    if (places.empty()) return {};
    return {say<Code::shells_in_solids>(places)};
}

/// What lies beside the solids of a compound, or beside its faces where those are meshed.
std::vector<Message> warnings_of_loose(const Brep& brep) {
    if (brep.dimension() == Dimension::edges) return {};
    std::vector<Entity> loose;
    for (std::size_t f = 0; f < brep.face_count(); ++f)
        if (!brep.is_meshed(FaceId(f))) loose.push_back(entity_of(FaceId(f)));
    for (std::size_t e = 0; e < brep.edge_count(); ++e)
        if (brep.faces_of(EdgeId(e)).empty() && !brep.is_meshed(EdgeId(e))) loose.push_back(entity_of(EdgeId(e)));
    if (loose.empty()) return {};
    if (brep.dimension() == Dimension::faces) return {say<Code::loose_beside_faces>(loose)};
    return {say<Code::loose_beside_solids>(loose)};
}

}  // namespace

std::vector<Message> warnings_of(const Brep& brep, const Mesh& mesh, const TrianglePairs& between) {
    std::vector<Message> warnings;
    if (!between.empty()) warnings.push_back(warning_of_contact(brep, mesh, between));
    for (const std::vector<Message>& more : {warnings_of_enclosed(brep, mesh), warnings_of_loose(brep)})
        warnings.insert(warnings.end(), more.begin(), more.end());
    return warnings;
}

}  // namespace featuremesh

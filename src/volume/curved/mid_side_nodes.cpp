// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/curved/mid_side_nodes.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/errors.h"
#include "core/geometry.h"
#include "core/messages.h"
#include "mesh/second_order.h"
#include "surface/face_parameters.h"
#include "surface/projection.h"
#include "volume/curved/bent_walls.h"
#include "volume/curved/curved_tet_repair.h"

namespace featuremesh {
namespace {

/// The parameter of a segment's end: chains run from the edge's first parameter to its last, so an end on a vertex is
/// the first or the last one, unless the edge goes on there (MergedEntities::vertices_on).
double parameter_at(const Mesh& mesh, std::size_t segment, bool is_start, const Projector& projector,
                    double negligible) {
    const NodeId node = mesh.segments[segment][is_start ? 0 : 1];
    if (mesh.entities[node.index()].dim == 1) return mesh.parameters[node.index()][0];
    const EdgeId edge = mesh.segment_edges[segment];
    const double end = projector.range(edge)[is_start ? 0 : 1];
    const double off = distance(projector.on_edge(edge, end), mesh.point(node));
    if (off <= negligible) return end;
    const OnEdge nearest = projector.nearest(edge, mesh.point(node));
    return nearest.distance + negligible < off ? nearest.t : end;
}

/// So many mid-side nodes are placed with one projector, on one thread.
constexpr std::size_t mids_per_chunk = 512;

void place_on_edges(const Brep& brep, const std::vector<bool>& is_new, Mesh& mesh, RunContext& context) {
    const double negligible = brep.tolerances().negligible();
    parallel_for(context, mesh.segments.size(), mids_per_chunk, [&](std::size_t begin, std::size_t end) {
        const Projector projector(brep);
        for (std::size_t i = begin; i < end; ++i) {
            const NodeId mid = mesh.segment_mids[i];
            if (!is_new[mid.index()]) continue;
            const EdgeId edge = mesh.segment_edges[i];
            const double t = projector.half_way(edge, parameter_at(mesh, i, true, projector, negligible),
                                                parameter_at(mesh, i, false, projector, negligible));
            mesh.points[mid.index()] = projector.on_edge(edge, t);
            mesh.parameters[mid.index()] = {t, 0};
        }
    });
}

/// Parameters on the face of a node of the triangle, to start a projection from.
std::optional<std::array<double, 2>> start_parameters(const Mesh& mesh, std::size_t triangle) {
    for (NodeId n : mesh.triangles[triangle])
        if (mesh.entities[n.index()] == entity_of(mesh.triangle_faces[triangle])) return mesh.parameters[n.index()];
    return std::nullopt;
}

/// Parameters half way along a side with both ends inside the face or on its border.
std::optional<std::array<double, 2>> half_way(const Brep& brep, const Mesh& mesh, const std::array<NodeId, 2>& side,
                                              const Projector& projector, FaceId face) {
    const auto from = parameters_on(brep, face, mesh, side[0]), to = parameters_on(brep, face, mesh, side[1]);
    if (!from || !to) return std::nullopt;
    return projector.half_way(face, *from, *to);
}

/// The point of the face nearest to the middle of a side between nodes of its border. Far away is not believed: the
/// parameters of a face may bend between its borders, and a node of a seam has two places, so least where there is one.
OnFace nearest_from_border(const Projector& projector, FaceId face, const Vec3& middle,
                           const std::optional<std::array<double, 2>>& start, double side) {
    const double far = projector.closes(face) ? 0.1 : 0.3;
    const OnFace near = projector.nearest(face, middle, start);
    if (!start || near.distance <= far * side) return near;
    const OnFace other = projector.nearest(face, middle);
    return other.distance < near.distance ? other : near;
}

/// The point of the face nearest to the middle of a side. Where the face bends so much that this point is towards one
/// end of the side, the point of the face as far from one end as from the other.
OnFace above_middle(const Brep& brep, const Projector& projector, FaceId face, const Mesh& mesh,
                    const std::array<NodeId, 2>& side, const std::optional<std::array<double, 2>>& start) {
    constexpr double most_slide = 0.05, enough = 0.01;
    constexpr int most_steps = 20;
    const Vec3 &a = mesh.point(side[0]), &b = mesh.point(side[1]);
    const Vec3 middle = 0.5 * (a + b), along = b - a;
    const auto slide_of = [&](const OnFace& on) { return dot(on.point - middle, along) / squared_length(along); };
    OnFace best =
        start || !projector.needs_search(face)
            ? projector.nearest(face, middle, start)
            : nearest_from_border(projector, face, middle, half_way(brep, mesh, side, projector, face), length(along));
    if (std::abs(slide_of(best)) < most_slide) return best;
    // Newton's steps from one end may have gone astray
    const auto is_inside = [&](NodeId n) { return mesh.entities[n.index()] == entity_of(face); };
    const auto between =
        std::all_of(side.begin(), side.end(), is_inside) ? half_way(brep, mesh, side, projector, face) : std::nullopt;
    if (const OnFace other = projector.nearest(face, middle, between); other.distance < best.distance) best = other;
    double least = slide_of(best);
    if (std::abs(least) < most_slide) return best;
    OnFace on = best;
    if (between) on = {projector.on_face(face, *between), *between};
    for (int step = 0; step < most_steps && std::abs(least) > enough; ++step) {
        on = projector.nearest(face, on.point - slide_of(on) * along, on.uv);
        if (std::abs(slide_of(on)) < std::abs(least)) best = on, least = slide_of(on);
    }
    return best;
}

/// The side of the first triangle that has it, of every new mid-side node inside a face.
struct FaceSide {
    std::size_t triangle;
    int side;
};
std::vector<FaceSide> sides_in_faces(std::vector<bool> is_new, const Mesh& mesh) {
    std::vector<FaceSide> sides;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (int s = 0; s < 3; ++s) {
            const NodeId mid = mesh.triangle_mids[i][s];
            if (!is_new[mid.index()] || mesh.entities[mid.index()].dim != 2) continue;
            is_new[mid.index()] = false;
            sides.push_back({i, s});
        }
    return sides;
}

void place_on_faces(const Brep& brep, const std::vector<bool>& is_new, Mesh& mesh, RunContext& context) {
    const std::vector<FaceSide> sides = sides_in_faces(is_new, mesh);
    parallel_for(context, sides.size(), mids_per_chunk, [&](std::size_t begin, std::size_t end) {
        const Projector projector(brep);
        for (std::size_t k = begin; k < end; ++k) {
            const auto& [i, s] = sides[k];
            const auto& corners = mesh.triangles[i];
            const std::size_t mid = mesh.triangle_mids[i][s].index();
            const OnFace on = above_middle(brep, projector, mesh.triangle_faces[i], mesh,
                                           {corners[s], corners[(s + 1) % 3]}, start_parameters(mesh, i));
            mesh.points[mid] = on.point;
            mesh.parameters[mid] = on.uv;
        }
    });
}

/// The face with most corners of the tet, the first of several, or its solid, for messages.
std::vector<Entity> place_of(const Mesh& mesh, TetId tet) {
    const auto& corners = mesh.tets[tet.index()];
    std::map<FaceId, unsigned> corners_on;  // a bit for each
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (NodeId n : mesh.triangles[i])
            if (const auto found = std::find(corners.begin(), corners.end(), n); found != corners.end())
                corners_on[mesh.triangle_faces[i]] |= 1u << (found - corners.begin());
    if (corners_on.empty()) return as_parameter(mesh.tet_solids[tet.index()]);
    const auto fewer = [](const auto& a, const auto& b) { return std::popcount(a.second) < std::popcount(b.second); };
    return as_parameter(std::max_element(corners_on.begin(), corners_on.end(), fewer)->first);
}

/// How many tets in front are kept: the numbers of all behind are as new as the kept mesh's next one. One between them
/// that was turned or cut has such a number, too.
std::size_t kept_tet_count(const Mesh& mesh, const Mesh* kept) {
    if (!kept) return 0;
    const auto is_kept = [&](Number number) { return number < kept->next_element_number; };
    return std::size_t(mesh.tet_numbers.rend() -
                       std::find_if(mesh.tet_numbers.rbegin(), mesh.tet_numbers.rend(), is_kept));
}

struct Curved {
    Mesh mesh;
    std::vector<TetId> low, folded;  ///< below the target, and those of them that are no valid elements
    double smallest = 1;             ///< scaled Jacobian
    std::vector<bool> is_movable;    ///< by node
    std::vector<Vec3> placed;        ///< where the nodes were at first
};

/// Gives the mesh its mid-side nodes; which nodes are new.
std::vector<bool> place_mid_side_nodes(const Brep& brep, Mesh& mesh, const Mesh* kept, RunContext& context) {
    const std::vector<NodeId> added = add_mid_side_nodes(mesh, kept, context);
    std::vector<bool> is_new(mesh.points.size(), false);
    for (NodeId n : added) is_new[n.index()] = true;
    place_on_edges(brep, is_new, mesh, context);
    place_on_faces(brep, is_new, mesh, context);
    return is_new;
}

/// Gives the mesh its mid-side nodes and moves nodes until every element reaches the target, if that can be.
Curved curve(const Brep& brep, const Projector& projector, Mesh mesh, const Mesh* kept, RunContext& context) {
    // an element whose Jacobian varies more than this makes the solution worse
    constexpr double wanted_scaled_jacobian = 0.2;
    context.check_cancelled();
    std::vector<bool> is_movable(mesh.points.size(), true);
    if (kept)
        for (std::size_t n = 0; n < mesh.points.size(); ++n)
            is_movable[n] = mesh.node_numbers[n] >= kept->next_node_number;
    std::vector<bool> is_new = place_mid_side_nodes(brep, mesh, kept, context);
    std::copy(is_movable.begin(), is_movable.end(), is_new.begin());
    Curved result{std::move(mesh), {}, {}, 1, std::move(is_new), {}};
    result.placed = result.mesh.points;
    result.low = unfold_tets(result.mesh, projector, result.is_movable,
                             {wanted_scaled_jacobian, brep.tolerances().least_volume()}, context);
    for (const TetId t : result.low) {
        const double scaled_jacobian = min_scaled_jacobian(tet_nodes(result.mesh, t));
        result.smallest = std::min(result.smallest, scaled_jacobian);
        if (!(scaled_jacobian > 0)) result.folded.push_back(t);
    }
    return result;
}

/// Half of what the folded tets' sides are long.
std::vector<SizeSource> shorter_lengths(const Mesh& mesh, const std::vector<TetId>& folded) {
    std::vector<SizeSource> wanted;
    for (const TetId t : folded) {
        const auto& n = mesh.tets[t.index()];
        double longest = 0;
        for (const auto& [a, b] : tet_sides) longest = std::max(longest, distance(mesh.point(n[a]), mesh.point(n[b])));
        wanted.push_back(
            {0.25 * (mesh.point(n[0]) + mesh.point(n[1]) + mesh.point(n[2]) + mesh.point(n[3])), 0.5 * longest});
    }
    return wanted;
}

/// The new tets with a strongly bent side, when the corners alone are far from filling the part: then they are too few,
/// however well the curved sides fit.
std::vector<TetId> too_coarse(const Brep& brep, const Mesh& curved, std::size_t kept_tets, const RunContext& context) {
    constexpr double strong_bend = 0.17, least_share = 0.5;
    std::vector<TetId> bent;
    RoundWatch watch(context);
    for (std::size_t t = kept_tets; t < curved.tets.size(); ++t) {
        watch();
        const auto nodes = tet_nodes(curved, TetId(t));
        for (int s = 0; s < 6; ++s) {
            const Vec3 &a = nodes[tet_sides[s][0]], &b = nodes[tet_sides[s][1]];
            if (squared_length(nodes[4 + s] - (a + b) * 0.5) < strong_bend * strong_bend * squared_length(b - a))
                continue;
            bent.emplace_back(t);
            break;
        }
    }
    if (bent.empty()) return {};
    std::vector<double> volumes(brep.solid_count(), 0);
    for (std::size_t t = 0; t < curved.tets.size(); ++t) {
        watch();
        const auto& n = curved.tets[t];
        volumes[curved.tet_solids[t].index()] +=
            signed_volume(curved.point(n[0]), curved.point(n[1]), curved.point(n[2]), curved.point(n[3]));
    }
    for (std::size_t s = 0; s < volumes.size(); ++s)
        if (volumes[s] < least_share * brep.volume_of(SolidId(s))) return bent;
    return {};
}

/// Kept elements stay as they are, whatever they miss.
SecondOrder result_of(Curved curved, std::size_t kept_tets) {
    std::vector<TetId> low = curved.low;
    std::erase_if(low, [&](TetId t) { return t.index() < kept_tets; });
    std::vector<SizeSource> shorter = shorter_lengths(curved.mesh, low);
    std::vector<Entity> place = place_of(curved.mesh, curved.low.front());
    return {std::move(curved.mesh), std::move(shorter), std::move(place), curved.smallest};
}

}  // namespace

SecondOrder try_second_order(const Brep& brep, Mesh mesh, const Mesh* kept, RunContext& context) {
    RunContext::Step step(context, "surface");
    const Projector projector(brep);
    const std::size_t kept_tets = kept_tet_count(mesh, kept);
    Curved curved = curve(brep, projector, std::move(mesh), kept, context);
    if (const std::vector<TetId> bent = too_coarse(brep, curved.mesh, kept_tets, context); !bent.empty())
        return {{}, shorter_lengths(curved.mesh, bent), place_of(curved.mesh, bent.front()), 0};
    if (curved.low.empty()) return {std::move(curved.mesh), {}, {}, 1};
    if (curved.folded.empty()) return result_of(std::move(curved), kept_tets);
    SecondOrder failed{
        {}, shorter_lengths(curved.mesh, curved.folded), place_of(curved.mesh, curved.folded.front()), 0};
    if (!kept) failed.straight = straighten(brep, curved.mesh, {curved.folded, {}}, context);
    curved.mesh.points = std::move(curved.placed);
    BentWalls walls = find_bent_walls(brep, projector, curved.mesh, kept_tets, context);
    if (!walls.lengths.empty()) {
        failed.shorter = std::move(walls.lengths);
        failed.place = place_of(curved.mesh, walls.place);
    }
    return failed;
}

Mesh curved_without_tets(const Brep& brep, Mesh mesh, const Mesh* kept, RunContext& context) {
    RunContext::Step step(context, "surface");
    place_mid_side_nodes(brep, mesh, kept, context);
    return mesh;
}

Mesh curve_to_second_order(const Brep& brep, Mesh mesh, const Mesh* kept, RunContext& context) {
    SecondOrder result = try_second_order(brep, std::move(mesh), kept, context);
    if (!result.is_valid()) throw MeshError(say<Code::tets_folded>(result.shorter.size(), result.place));
    return std::move(result.mesh);
}

}  // namespace featuremesh

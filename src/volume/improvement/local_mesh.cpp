// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/improvement/local_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/directions.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

/// Below it a triangle costs more than a better tet is worth.
constexpr double good_triangle_deg = 15;
/// Cosine between a triangle's normals before and after.
constexpr double least_normal_cosine = 0.8;
constexpr double most_change_of_volume = 0.005;

double cosine_of_sharpest(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto cosine_at = [](const Vec3& p, const Vec3& q, const Vec3& r) {
        return dot(normalized(q - p), normalized(r - p));
    };
    return std::max({cosine_at(a, b, c), cosine_at(b, c, a), cosine_at(c, a, b)});
}

/// The other two corners, so that the triangle has the same sense with any vertex before them.
std::array<Vec3, 2> triangle_from(const TetComplex& complex, const Tet& tet, int face, int vertex) {
    const auto& c = opposite_face[face];
    int k = 0;
    while (tet[c[k]] != vertex) ++k;
    return {complex.points[tet[c[(k + 1) % 3]]], complex.points[tet[c[(k + 2) % 3]]]};
}

}  // namespace

LocalMesh::LocalMesh(TetComplex& complex, MovableSurface surface)
    : complex_(complex),
      surface_(std::move(surface)),
      editor_(complex),
      changed_at_(complex.points.size(), 1),
      tet_changed_at_(complex.tets.size(), 1),
      has_moved_(complex.points.size(), 0) {
    if (surface_.vertices.empty()) return;
    place_of_.assign(complex.points.size(), -1);
    for (std::size_t i = 0; i < surface_.vertices.size(); ++i) {
        const SurfaceVertex& of = surface_.vertices[i];
        place_of_[of.vertex] = static_cast<int>(i);
        complex_.mobility[of.vertex] = of.on.dim == 1 ? Mobility::on_edge : Mobility::on_face;
    }
}

std::vector<SurfaceVertex> LocalMesh::release_surface() {
    for (const SurfaceVertex& of : surface_.vertices) complex_.mobility[of.vertex] = Mobility::fixed;
    place_of_.clear();
    return std::exchange(surface_.vertices, {});
}

bool LocalMesh::gather(int vertex, Star& star) const {
    star.rim.clear();
    if (!is_on_surface(vertex))
        return complex_.mobility[vertex] != Mobility::fixed && gather_star(complex_, vertex, star.tets);
    if (complex_.tet_of_vertex[vertex] < 0) return false;
    // the tets at a vertex inside a face, or inside an edge between two, form one fan
    star.tets.assign(1, complex_.tet_of_vertex[vertex]);
    for (std::size_t i = 0; i < star.tets.size(); ++i) {
        const Tet& tet = complex_.tets[star.tets[i]];
        const int own = corner_of(tet, vertex);
        for (int face = 0; face < 4; ++face) {
            if (face == own) continue;
            const int next = complex_.neighbours[star.tets[i]][face];
            if (next < 0)
                star.rim.push_back(triangle_from(complex_, tet, face, vertex));
            else if (std::find(star.tets.begin(), star.tets.end(), next) == star.tets.end())
                star.tets.push_back(next);
        }
    }
    return true;
}

Price LocalMesh::price_of_moving(int vertex) const {
    if (const SurfaceVertex* of = surface_vertex(vertex))
        return of->is_kept && !has_moved(vertex) ? price_of_kept_surface_move : price_of_surface_move;
    return complex_.mobility[vertex] == Mobility::kept && !has_moved(vertex) ? price_of_kept_move : Price{};
}

std::vector<Vec3> LocalMesh::ways_from(int vertex, const Star& star, const Projector* projector) const {
    const SurfaceVertex* of = surface_vertex(vertex);
    if (!of) return directions_in_space();
    if (of->on.dim == 1) {
        const Vec3 tangent = projector->tangent(EdgeId(of->on.index), of->parameters[0]);
        return {tangent, -1.0 * tangent};
    }
    constexpr int ways = 12;
    const Vec3 normal = projector->normal(FaceId(of->on.index), of->parameters);
    const Vec3 to_other = star.rim.front()[0] - complex_.points[vertex];
    const Vec3 along = normalized(to_other - dot(to_other, normal) * normal), across = cross(normal, along);
    std::vector<Vec3> directions;
    for (int way = 0; way < ways; ++way) {
        const double angle = way * (2 * std::numbers::pi / ways);
        directions.push_back(std::cos(angle) * along + std::sin(angle) * across);
    }
    return directions;
}

Vec3 LocalMesh::along(int vertex, const Vec3& way, const Projector* projector) const {
    const SurfaceVertex* of = surface_vertex(vertex);
    return of ? projector->along(of->on, of->parameters, way) : way;
}

std::optional<Change::Move> LocalMesh::place_near(int vertex, const Vec3& aim, const Projector* projector) const {
    const SurfaceVertex* of = surface_vertex(vertex);
    if (!of) return Change::Move{vertex, aim, {}};
    const std::optional<OnEntity> there = projector->nearest_by_steps(of->on, aim, of->parameters);
    if (!there || (of->on.dim == 2 && !projector->is_inside_trim(FaceId(of->on.index), there->parameters))) return {};
    return Change::Move{vertex, there->point, there->parameters};
}

bool LocalMesh::keeps_triangles(int vertex, const Star& star, const Vec3& to) const {
    static const double good_cosine = std::cos(good_triangle_deg * std::numbers::pi / 180);
    const Vec3& from = complex_.points[vertex];
    double sharpest = -1, sharpest_before = -1;
    for (const auto& [a, b] : star.rim) {
        const Vec3 before = cross(a - from, b - from), after = cross(a - to, b - to);
        if (!(dot(before, after) > least_normal_cosine * length(before) * length(after))) return false;
        sharpest = std::max(sharpest, cosine_of_sharpest(to, a, b));
        sharpest_before = std::max(sharpest_before, cosine_of_sharpest(from, a, b));
    }
    return sharpest <= std::max(sharpest_before, good_cosine);
}

bool LocalMesh::keeps_volume(int vertex, const Star& star, const Vec3& to) const {
    if (star.rim.empty()) return true;
    double before = 0, after = 0;
    for (const int t : star.tets) {
        std::array<Vec3, 4> p = corners_of(complex_, complex_.tets[t]);
        before += signed_volume(p[0], p[1], p[2], p[3]);
        p[corner_of(complex_.tets[t], vertex)] = to;
        after += signed_volume(p[0], p[1], p[2], p[3]);
    }
    return std::abs(after - before) <= most_change_of_volume * before;
}

bool LocalMesh::is_held(int vertex, const Star& star) const {
    if (!surface_.is_for_curved_tets || !is_on_surface(vertex)) return false;
    constexpr double flat_cosine = 0.9999;
    std::vector<Vec3> normals;  // one of a plane, two at an edge
    for (const auto& [a, b] : star.rim) {
        const Vec3 normal = normalized(cross(a - complex_.points[vertex], b - complex_.points[vertex]));
        if (std::none_of(normals.begin(), normals.end(), [&](const Vec3& n) { return dot(n, normal) > flat_cosine; }))
            normals.push_back(normal);
    }
    return normals.size() > (surface_vertex(vertex)->on.dim == 1 ? 2u : 1u);
}

std::span<const int> LocalMesh::apply(const Change& change) {
    for (const Change::Move& move : change.moves) {
        complex_.points[move.vertex] = move.place;
        has_moved_[move.vertex] = 1;
        if (const int place = place_of(move.vertex); place >= 0)
            surface_.vertices[static_cast<std::size_t>(place)].parameters = move.parameters;
    }
    for (const Vec3& point : change.points) {
        complex_.mobility[editor_.add_vertex(point)] = change.mobility;
        changed_at_.push_back(0), has_moved_.push_back(1);
    }
    changed_ = change.bent;
    if (!change.removed.empty()) {
        const std::span<const int> added = editor_.replace(change.removed, change.added);
        changed_.insert(changed_.end(), added.begin(), added.end());
    }
    ++now_;
    tet_changed_at_.resize(complex_.tets.size());
    for (const int t : change.removed) tet_changed_at_[t] = now_;
    for (const int t : changed_) {
        tet_changed_at_[t] = now_;
        for (const int v : complex_.tets[t]) changed_at_[v] = now_;
    }
    return changed_;
}

bool LocalMesh::has_changed(const Footprint& footprint, std::uint32_t since) const {
    const auto tets = footprint.tets();
    return since < now_ && std::any_of(tets.begin(), tets.end(), [&](int t) { return tet_changed_at_[t] > since; });
}

}  // namespace featuremesh

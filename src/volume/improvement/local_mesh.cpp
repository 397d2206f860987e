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

/// Whether all angles of a triangle have a smaller cosine than that, or the same.
bool has_no_sharper_angle(const Vec3& p, const Vec3& a, const Vec3& b, double cosine) {
    const Vec3 to_a = a - p, to_b = b - p, side = b - a;
    const double by_a = length(to_a), by_b = length(to_b), by_side = length(side);
    return dot(to_a, to_b) <= cosine * by_a * by_b && -dot(to_a, side) <= cosine * by_a * by_side &&
           dot(to_b, side) <= cosine * by_b * by_side;
}

double cosine_of_sharpest(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = normalized(b - a), bc = normalized(c - b), ca = normalized(a - c);
    return -std::min({dot(ab, ca), dot(ab, bc), dot(bc, ca)});
}

/// The other two corners, so that the triangle has the same sense with any vertex before them.
LocalMesh::RimTriangle triangle_from(const TetComplex& complex, const Tet& tet, int face, int vertex) {
    const auto& c = opposite_face[face];
    int k = 0;
    while (tet[c[k]] != vertex) ++k;
    const Vec3 &a = complex.points[tet[c[(k + 1) % 3]]], &b = complex.points[tet[c[(k + 2) % 3]]];
    return {a, b, {}};
}

/// Cosine and sine of so many equal parts of a turn.
constexpr int ways_in_a_plane = 12;
std::array<std::array<double, 2>, ways_in_a_plane> parts_of_a_turn() {
    std::array<std::array<double, 2>, ways_in_a_plane> parts;
    for (int way = 0; way < ways_in_a_plane; ++way) {
        const double angle = way * (2 * std::numbers::pi / ways_in_a_plane);
        parts[static_cast<std::size_t>(way)] = {std::cos(angle), std::sin(angle)};
    }
    return parts;
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
    measure_rim(vertex, star);
    return true;
}

void LocalMesh::measure_rim(int vertex, Star& star) const {
    const Vec3& p = complex_.points[vertex];
    star.most_cosine = std::cos(good_triangle_deg * std::numbers::pi / 180);
    for (auto& [a, b, normal] : star.rim) {
        normal = normalized(cross(a - p, b - p));
        // where the vertex moves along a side an angle stays as it is but for rounding
        constexpr double rounding = 1e-9;
        star.most_cosine = std::max(star.most_cosine, cosine_of_sharpest(p, a, b) + rounding);
    }
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
    static const auto parts = parts_of_a_turn();
    const Vec3 normal = projector->normal(FaceId(of->on.index), of->parameters);
    const Vec3 to_other = star.rim.front().a - complex_.points[vertex];
    const Vec3 along = normalized(to_other - dot(to_other, normal) * normal), across = cross(normal, along);
    std::vector<Vec3> directions;
    for (const auto& [cosine, sine] : parts) directions.push_back(cosine * along + sine * across);
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
    if (!there) return {};
    return Change::Move{vertex, there->point, there->parameters};
}

bool LocalMesh::stays_within(const Change::Move& move, const Projector* projector) const {
    const SurfaceVertex* of = surface_vertex(move.vertex);
    return !of || of->on.dim != 2 || projector->is_inside_trim(FaceId(of->on.index), move.parameters);
}

bool LocalMesh::keeps_triangles(const Star& star, const Vec3& to) {
    return std::all_of(star.rim.begin(), star.rim.end(), [&](const RimTriangle& of) {
        const Vec3 after = cross(of.a - to, of.b - to);
        return dot(of.normal, after) > least_normal_cosine * length(after) &&
               has_no_sharper_angle(to, of.a, of.b, star.most_cosine);
    });
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
    constexpr double most_bent_cosine = 0.5;
    std::vector<Vec3> normals;  // one of a face, two at an edge
    for (const RimTriangle& of : star.rim)
        if (std::none_of(normals.begin(), normals.end(),
                         [&](const Vec3& n) { return dot(n, of.normal) > most_bent_cosine; }))
            normals.push_back(of.normal);
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

bool LocalMesh::has_changed(std::span<const int> tets, std::uint32_t since) const {
    return since < now_ && std::any_of(tets.begin(), tets.end(), [&](int t) { return tet_changed_at_[t] > since; });
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/boundary_moves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

#include "volume/needles.h"
#include "volume/shrinking_steps.h"
#include "volume/tet_measures.h"
#include "volume/tet_topology.h"
#include "volume/thicken.h"
#include "volume/vertex_move.h"

namespace featuremesh {

namespace {

constexpr int most_passes = 8;
/// Of the squared sine of the worst angle: a surface node is not moved for less.
constexpr double least_gain_on_boundary = 0.02;
/// Share of the sum of the star's radius ratios that is left: one angle is not worth all other shapes.
constexpr double least_kept_ratios = 0.5;
/// Below it a triangle costs more than a better tet is worth.
constexpr double good_triangle_deg = 15;
/// Cosine between a triangle's normals before and after.
constexpr double least_normal_cosine = 0.8;

double cosine_of_sharpest(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto cosine_at = [](const Vec3& p, const Vec3& q, const Vec3& r) {
        return dot(normalized(q - p), normalized(r - p));
    };
    return std::max({cosine_at(a, b, c), cosine_at(b, c, a), cosine_at(c, a, b)});
}

class BoundaryMover {
  public:
    BoundaryMover(TetComplex& complex, std::span<BoundaryVertex> vertices, const Projector& projector,
                  const BoundaryMoveOptions& options, RunContext& context)
        : complex_(complex),
          vertices_(vertices),
          projector_(projector),
          context_(context),
          target_(flatness_to_reach(options.target_dihedral_deg)),
          least_volume_(options.least_volume),
          is_for_curved_tets_(options.is_for_curved_tets),
          good_cosine_(std::cos(good_triangle_deg * std::numbers::pi / 180)),
          place_of_(complex.points.size(), -1),
          is_due_(complex.points.size(), 1) {
        for (std::size_t i = 0; i < vertices.size(); ++i) place_of_[vertices[i].vertex] = static_cast<int>(i);
    }

    std::vector<int> run() {
        std::vector<int> all;
        for (std::size_t t = 0; t < complex_.tets.size(); ++t)
            if (complex_.tets[t][0] >= 0) changed_.push_back(static_cast<int>(t));
        for (int pass = 0; pass < most_passes && !changed_.empty(); ++pass) {
            context_.progress(static_cast<double>(pass) / most_passes);
            for (const auto& [value, tet] : rank_changed()) {
                context_.check_cancelled();
                const Tet corners = complex_.tets[tet];
                for (const int v : corners)
                    if (may_move(v) && std::exchange(is_due_[v], 0) && move(v)) note_changed();
            }
            all.insert(all.end(), changed_.begin(), changed_.end());
        }
        raise_poor_stars();
        all.insert(all.end(), changed_.begin(), changed_.end());
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }

    /// To where this tet reaches the target, or nearer to that, whatever it does to the angles of the others.
    bool move_for(int vertex, int tet) {
        if (!may_move(vertex)) return false;
        BoundaryVertex inner{vertex, {}, {}};
        BoundaryVertex& of = place_of_[vertex] < 0 ? inner : vertices_[static_cast<std::size_t>(place_of_[vertex])];
        const Vec3 start = complex_.points[vertex];
        gather(vertex);
        if (has_needle() || (is_for_curved_tets_ && of.on.dim < 3 && !is_flat(of))) return false;
        shape_.gather(complex_, std::array{tet}, vertex);
        const double wanted =
            improved_flatness(unforced_flatness(complex_, complex_.tets[tet]), least_gain_on_boundary);
        const std::optional<Vec3> aim = climb(of, start, wanted);
        const std::optional<Place> there = aim ? place_near(of, *aim) : std::nullopt;
        if (!there || !keeps_triangles(start, there->point) || !keeps_bulk(vertex, start, there->point)) return false;
        complex_.points[vertex] = there->point;
        of.parameters = there->parameters;
        return true;
    }

  private:
    /// The changed tets that miss the target, the worst first.
    std::vector<std::pair<double, int>> rank_changed() {
        std::sort(changed_.begin(), changed_.end());
        changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
        std::vector<std::pair<double, int>> ranked;
        for (const int t : changed_)
            if (const double value = unforced_flatness(complex_, complex_.tets[t]); value > target_)
                ranked.emplace_back(-value, t);
        changed_.clear();
        std::sort(ranked.begin(), ranked.end());
        return ranked;
    }

    /// What failed once fails again until something near it has changed.
    void note_changed() {
        changed_.insert(changed_.end(), star_.begin(), star_.end());
        for (const int t : star_)
            for (const int v : complex_.tets[t]) is_due_[v] = 1;
    }

    /// The tets at a vertex inside a face, or inside an edge between two, form one fan.
    void gather(int vertex) {
        star_.assign(1, complex_.tet_of_vertex[vertex]);
        rim_.clear();
        for (std::size_t i = 0; i < star_.size(); ++i) {
            const Tet& tet = complex_.tets[star_[i]];
            const int own = corner_of(tet, vertex);
            for (int face = 0; face < 4; ++face) {
                if (face == own) continue;
                const int next = complex_.neighbours[star_[i]][face];
                if (next < 0)
                    rim_.push_back(triangle_from(tet, face, vertex));
                else if (std::find(star_.begin(), star_.end(), next) == star_.end())
                    star_.push_back(next);
            }
        }
        shape_.gather(complex_, star_, vertex);
    }

    /// The other two corners, so that the triangle has the same sense with any vertex before them.
    std::array<Vec3, 2> triangle_from(const Tet& tet, int face, int vertex) const {
        const auto& c = opposite_face[face];
        int k = 0;
        while (tet[c[k]] != vertex) ++k;
        return {complex_.points[tet[c[(k + 1) % 3]]], complex_.points[tet[c[(k + 2) % 3]]]};
    }

    /// Where most of a star is poor its worst angle is not all that counts, and in walls of one layer nothing else
    /// looks at the rest.
    void raise_poor_stars() {
        constexpr int most_sweeps = 8;
        std::fill(is_due_.begin(), is_due_.end(), 1);
        changed_.clear();
        bool is_any = true;
        for (int sweep = 0; sweep < most_sweeps && is_any; ++sweep) {
            is_any = false;
            for (BoundaryVertex& of : vertices_) {
                context_.check_cancelled();
                if (!std::exchange(is_due_[of.vertex], 0) || !raise(of)) continue;
                note_changed();
                is_any = true;
            }
        }
    }

    /// Along the face or edge, the way in which the sum of the star's radius ratios grows.
    bool raise(BoundaryVertex& of) {
        constexpr double poor = 0.6, longest_step = 0.15, curvature = 2, least_gain_of_sum = 0.02;
        constexpr int most_halvings = 2;
        gather(of.vertex);
        const Vec3 start = complex_.points[of.vertex];
        const StarShape::Ratios ratios = shape_.radius_ratios(start);
        const double count = static_cast<double>(shape_.size());
        if (ratios.sum >= poor * count || has_needle() || (is_for_curved_tets_ && !is_flat(of))) return false;
        const Vec3 way = along_entity(of, ratios.gradient);
        const double reach = shape_.mean_height(start), slope = length(way) * reach;
        double step = std::min(longest_step, slope / (curvature * count));
        for (int k = 0; k <= most_halvings && slope * step > 2 * least_gain_of_sum; ++k, step /= 2) {
            const std::optional<Place> there = place_near(of, start + way * (step * reach * reach / slope));
            if (!there || shape_.sum_of_radius_ratios(there->point) < ratios.sum + least_gain_of_sum ||
                is_worse(start, there->point) || !keeps_triangles(start, there->point) ||
                !keeps_bulk(of.vertex, start, there->point))
                continue;
            complex_.points[of.vertex] = there->point;
            of.parameters = there->parameters;
            return true;
        }
        return false;
    }

    bool is_worse(const Vec3& start, const Vec3& trial) const {
        const double worst = shape_.worst(trial, 2 * inverted_flatness);
        return worst > target_ && (worst > shape_.worst(start, 2 * inverted_flatness) ||
                                   shape_.steep_burden(trial, target_) > shape_.steep_burden(start, target_));
    }

    Vec3 along_entity(const BoundaryVertex& of, const Vec3& way) const {
        if (of.on.dim == 1) {
            const Vec3 along = projector_.tangent(EdgeId(of.on.index), of.parameters[0]);
            return dot(along, way) * along;
        }
        const Vec3 normal = projector_.normal(FaceId(of.on.index), of.parameters);
        return way - dot(normal, way) * normal;
    }

    double sharpest(const Vec3& point) const {
        double cosine = -1;
        for (const auto& [a, b] : rim_) cosine = std::max(cosine, cosine_of_sharpest(point, a, b));
        return cosine;
    }

    bool keeps_triangles(const Vec3& from, const Vec3& to) const {
        for (const auto& [a, b] : rim_) {
            const Vec3 before = cross(a - from, b - from), after = cross(a - to, b - to);
            if (!(dot(before, after) > least_normal_cosine * length(before) * length(after))) return false;
        }
        return sharpest(to) <= std::max(sharpest(from), good_cosine_);
    }

    /// The triangles lie in one plane, or in two at an edge.
    bool is_flat(const BoundaryVertex& of) const {
        constexpr double flat_cosine = 0.9999;
        std::vector<Vec3> normals;
        for (const auto& [a, b] : rim_) {
            const Vec3 normal = normalized(cross(a - complex_.points[of.vertex], b - complex_.points[of.vertex]));
            if (std::none_of(normals.begin(), normals.end(),
                             [&](const Vec3& n) { return dot(n, normal) > flat_cosine; }))
                normals.push_back(normal);
        }
        return normals.size() <= (of.on.dim == 1 ? 2u : 1u);
    }

    struct Bulk {
        double thinnest = 1, volume = 0;
    };
    /// Of the star's tets, with the vertex at `point`.
    Bulk bulk_with(int vertex, const Vec3& point) {
        Vec3& place = complex_.points[vertex];
        const Vec3 old = std::exchange(place, point);
        Bulk bulk;
        for (const int t : star_) {
            const auto& [a, b, c, d] = complex_.tets[t];
            bulk.thinnest = std::min(bulk.thinnest, thickness(complex_, complex_.tets[t], least_volume_));
            bulk.volume +=
                signed_volume(complex_.points[a], complex_.points[b], complex_.points[c], complex_.points[d]);
        }
        place = old;
        return bulk;
    }

    /// On a curved face other triangles cut off more of it, or less.
    bool keeps_bulk(int vertex, const Vec3& from, const Vec3& to) {
        constexpr double most_change = 0.005;
        const Bulk before = bulk_with(vertex, from), after = bulk_with(vertex, to);
        return after.thinnest >= before.thinnest &&
               std::abs(after.volume - before.volume) <= most_change * before.volume;
    }

    bool may_move(int vertex) const { return place_of_[vertex] >= 0 || complex_.is_fixed[vertex] == 0; }

    bool move(int vertex) {
        BoundaryVertex inner{vertex, {}, {}};
        return move(place_of_[vertex] < 0 ? inner : vertices_[static_cast<std::size_t>(place_of_[vertex])]);
    }

    bool move(BoundaryVertex& of) {
        const Vec3 start = complex_.points[of.vertex];
        gather(of.vertex);
        const double before = shape_.worst(start, 2 * inverted_flatness);
        if (before <= target_ || has_needle()) return false;
        if (is_for_curved_tets_ && of.on.dim < 3 && !is_flat(of)) return false;
        const double wanted = improved_flatness(before, least_gain_on_boundary);
        const std::optional<Vec3> aim = climb(of, start, wanted);
        if (!aim) return false;
        for (const double share : {1.0, 0.5, 0.25})
            if (take_place(of, start, start + share * (*aim - start), wanted)) return true;
        return false;
    }

    /// What helps a needle harms all others.
    bool has_needle() const {
        return std::any_of(star_.begin(), star_.end(), [&](int t) { return is_excused(complex_, complex_.tets[t]); });
    }

    struct Place {
        Vec3 point;
        std::array<double, 2> parameters;
    };

    /// Nearest to `aim` on what the vertex lies on.
    std::optional<Place> place_near(const BoundaryVertex& of, const Vec3& aim) const {
        if (of.on.dim == 3) return Place{aim, {}};
        if (of.on.dim == 1) {
            const OnEdge there = projector_.nearest(EdgeId(of.on.index), aim, of.parameters[0]);
            return Place{there.point, {there.t, 0}};
        }
        const FaceId face(of.on.index);
        const std::optional<OnFace> there = projector_.nearest_by_steps(face, aim, of.parameters);
        if (!there || !projector_.is_inside_trim(face, there->uv)) return {};
        return Place{there->point, there->uv};
    }

    /// Near `aim`, where that is worth it for the star as a whole.
    bool take_place(BoundaryVertex& of, const Vec3& start, const Vec3& aim, double wanted) {
        const std::optional<Place> there = place_near(of, aim);
        if (!there || !(shape_.worst(there->point, wanted) < wanted) || !keeps_triangles(start, there->point) ||
            !(shape_.steep_burden(there->point, target_) < shape_.steep_burden(start, target_)) ||
            shape_.sum_of_radius_ratios(there->point) < least_kept_ratios * shape_.sum_of_radius_ratios(start) ||
            !keeps_bulk(of.vertex, start, there->point))
            return false;
        complex_.points[of.vertex] = there->point;
        of.parameters = there->parameters;
        return true;
    }

    /// Along the axes and the diagonals of a cube.
    static std::vector<Vec3> ways_in_space() {
        std::vector<Vec3> ways;
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    if (x != 0 || y != 0 || z != 0) ways.push_back(normalized({double(x), double(y), double(z)}));
        return ways;
    }

    /// Unit vectors along the face or edge, or all round.
    std::vector<Vec3> ways_from(const BoundaryVertex& of, const Vec3& start) const {
        if (of.on.dim == 3) return ways_in_space();
        if (of.on.dim == 1) {
            const Vec3 along = projector_.tangent(EdgeId(of.on.index), of.parameters[0]);
            return {along, -1.0 * along};
        }
        constexpr int ways = 12;
        const Vec3 normal = projector_.normal(FaceId(of.on.index), of.parameters);
        const Vec3 to_other = rim_.front()[0] - start;
        const Vec3 side = normalized(to_other - dot(to_other, normal) * normal), across = cross(normal, side);
        std::vector<Vec3> directions;
        for (int way = 0; way < ways; ++way) {
            const double angle = way * (2 * std::numbers::pi / ways);
            directions.push_back(std::cos(angle) * side + std::sin(angle) * across);
        }
        return directions;
    }

    /// By shrinking steps, without regard to how the face or edge is curved.
    std::optional<Vec3> climb(const BoundaryVertex& of, const Vec3& start, double wanted) const {
        const std::vector<Vec3> ways = ways_from(of, start);
        Vec3 place = start;
        double best = shape_.worst(start, 2 * inverted_flatness);
        const double first_step = 0.2 * shape_.mean_height(start);
        const auto improve = [&](double step) {
            bool is_better = false;
            for (const Vec3& way : ways) {
                const Vec3 trial = place + step * way;
                const double value = shape_.worst(trial, best);
                if (value >= best || !keeps_triangles(start, trial)) continue;
                best = value, place = trial, is_better = true;
            }
            return is_better;
        };
        search_by_shrinking_steps(
            first_step, 0.02 * first_step, [&] { return !(best > target_); }, improve);
        return best < wanted ? std::optional(place) : std::nullopt;
    }

    TetComplex& complex_;
    std::span<BoundaryVertex> vertices_;
    const Projector& projector_;
    RunContext& context_;
    double target_, least_volume_;
    bool is_for_curved_tets_;
    double good_cosine_;
    std::vector<int> place_of_;         // by vertex, in vertices_; -1 for none
    std::vector<std::uint8_t> is_due_;  // by vertex
    std::vector<int> star_, changed_;
    std::vector<std::array<Vec3, 2>> rim_;  // of the star: its triangles on the boundary
    StarShape shape_;
};

bool is_outside(const Brep& brep, FaceId face) {
    const auto sides = brep.sides_of(face);
    return sides[0].is_valid() != sides[1].is_valid();
}

}  // namespace

std::vector<BoundaryVertex> movable_vertices(const Brep& brep, const Mesh& mesh, const SeamRegion& region,
                                             std::size_t first_new) {
    std::vector<BoundaryVertex> vertices;
    for (int v = 0; v < static_cast<int>(region.complex.points.size()); ++v) {
        const NodeId node = region.node_of(v);
        if (!node.is_valid() || node.index() < first_new || region.is_at_seam(v) || region.complex.tet_of_vertex[v] < 0)
            continue;
        const Entity on = mesh.entities[node.index()];
        if (on.dim != 1 && on.dim != 2) continue;
        const std::vector<FaceId> faces = brep.faces_at(on);
        if (faces.size() <= 2 && std::all_of(faces.begin(), faces.end(), [&](FaceId f) { return is_outside(brep, f); }))
            vertices.push_back({v, on, mesh.parameters[node.index()]});
    }
    return vertices;
}

std::vector<int> move_on_boundary(TetComplex& complex, std::span<BoundaryVertex> vertices, const Projector& projector,
                                  const BoundaryMoveOptions& options, RunContext& context) {
    if (vertices.empty()) return {};
    return BoundaryMover(complex, vertices, projector, options, context).run();
}

bool move_for_tet(TetComplex& complex, std::span<BoundaryVertex> vertices, int vertex, int tet,
                  const Projector& projector, const BoundaryMoveOptions& options, RunContext& context) {
    return BoundaryMover(complex, vertices, projector, options, context).move_for(vertex, tet);
}

}  // namespace featuremesh

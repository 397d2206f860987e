// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/opposite_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "brep/common_body.h"
#include "core/box_tree.h"
#include "core/distances.h"
#include "core/geometry.h"
#include "surface/projection.h"

namespace featuremesh {

namespace {

constexpr double nearness = 0.005;  // of the longest side of a triangle
constexpr double parallel_cosine = 0.9;
constexpr double spacing = 0.72, boundary_spacing = 0.3, same_place = 1e-3;  // of the wanted length

/// The triangles of a face: the new ones, and those kept between them.
struct Patch {
    std::vector<TriangleId> triangles;
    Box box;
    double area = 0, longest = 0;
    bool has_new = false;
};

class Finder {
  public:
    Finder(const Brep& brep, const Mesh& mesh, std::size_t first_new)
        : brep_(brep), mesh_(mesh), patches_(brep.face_count()) {
        Box changed;
        for (std::size_t t = first_new; t < mesh.triangles.size(); ++t) {
            Patch& patch = patches_[mesh.triangle_faces[t].index()];
            patch.has_new = true;
            for (const NodeId n : mesh.triangles[t]) changed.add(mesh.point(n));
        }
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            if (t >= first_new || changed.contains(mesh.point(mesh.triangles[t][0]))) add(TriangleId(t));
    }

    OppositePlaces find(RunContext& context) {
        std::vector<Box> boxes;
        for (const Patch& patch : patches_) boxes.push_back(patch.box.grown(nearness * patch.longest));
        const BoxTree tree(boxes);
        std::vector<std::size_t> order(patches_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(), [&](std::size_t f, std::size_t g) {
            return std::pair(patches_[f].has_new, patches_[f].area) < std::pair(patches_[g].has_new, patches_[g].area);
        });
        for (std::size_t rank = 0; rank < order.size(); ++rank) rank_[order[rank]] = rank;
        for (const std::size_t f : order) {
            context.check_cancelled();
            if (patches_[f].triangles.empty() || !found_.on_faces[f].empty()) continue;
            std::vector<FaceId> larger;
            tree.visit_where([&](const Box& box) { return box.overlaps(patches_[f].box); },
                             [&](std::int32_t g) {
                                 if (patches_[std::size_t(g)].has_new && rank_[std::size_t(g)] > rank_[f] &&
                                     may_be_opposite(FaceId(f), FaceId(g)))
                                     larger.emplace_back(g);
                             });
            std::sort(larger.begin(), larger.end());
            for (const FaceId g : larger) mark(FaceId(f), g);
        }
        return std::move(found_);
    }

  private:
    std::array<Vec3, 3> corners(TriangleId t) const {
        const auto& [a, b, c] = mesh_.triangles[t.index()];
        return {mesh_.point(a), mesh_.point(b), mesh_.point(c)};
    }
    static double longest_side(const std::array<Vec3, 3>& p) {
        return std::max({distance(p[0], p[1]), distance(p[1], p[2]), distance(p[2], p[0])});
    }
    static Vec3 normal(const std::array<Vec3, 3>& p) { return normalized(cross(p[1] - p[0], p[2] - p[0])); }

    void add(TriangleId t) {
        Patch& patch = patches_[mesh_.triangle_faces[t.index()].index()];
        const auto p = corners(t);
        patch.triangles.push_back(t);
        for (const Vec3& corner : p) patch.box.add(corner);
        patch.area += 0.5 * length(cross(p[1] - p[0], p[2] - p[0]));
        patch.longest = std::max(patch.longest, longest_side(p));
    }

    /// Faces of one body that do not meet.
    bool may_be_opposite(FaceId f, FaceId g) const {
        if (!have_common_body(brep_, f, g)) return false;
        for (const EdgeId e : brep_.edges_of(f))
            for (const VertexId end : brep_.ends_of(e)) {
                if (!end.is_valid()) continue;
                const std::vector<FaceId> at = brep_.faces_at(entity_of(end));
                if (std::find(at.begin(), at.end(), g) != at.end()) return false;
            }
        return true;
    }

    const BoxTree& triangles_of(FaceId face) {
        std::unique_ptr<BoxTree>& tree = trees_[face.index()];
        if (tree) return *tree;
        std::vector<Box> boxes;
        for (const TriangleId t : patches_[face.index()].triangles) {
            Box box;
            for (const Vec3& p : corners(t)) box.add(p);
            boxes.push_back(box);
        }
        tree = std::make_unique<BoxTree>(boxes);
        return *tree;
    }

    /// On the larger face, where whole triangles of the smaller one are near.
    void mark(FaceId smaller, FaceId larger) {
        std::map<NodeId, std::optional<std::array<double, 2>>> opposite;
        auto& places = found_.on_faces[larger.index()];
        const std::size_t before = places.size();
        std::set<NodeId> taken;
        for (const TriangleId t : patches_[smaller.index()].triangles) {
            const auto p = corners(t);
            const auto& nodes = mesh_.triangles[t.index()];
            const double reach = nearness * longest_side(p);
            bool is_near = true;
            for (std::size_t k = 0; k < 3 && is_near; ++k) {
                const auto [at, is_new] = opposite.try_emplace(nodes[k]);
                if (is_new) at->second = place_opposite(larger, p[k], normal(p), reach);
                is_near = at->second.has_value();
            }
            if (!is_near) continue;
            for (const NodeId n : nodes)
                if (taken.insert(n).second) places.push_back(*opposite.at(n));
        }
        if (places.size() > before) pair_edges(smaller, larger);
    }

    std::optional<std::array<double, 2>> place_opposite(FaceId face, const Vec3& p, const Vec3& direction,
                                                        double reach) {
        if (!is_before(face, p, direction, reach)) return {};
        const OnFace at = projector_.nearest(face, p);
        if (at.distance > reach || !projector_.is_inside_trim(face, at.uv)) return {};
        return at.uv;
    }

    /// Those of the one that run beside one of the other on a third face.
    void pair_edges(FaceId smaller, FaceId larger) {
        for (const EdgeId e : brep_.edges_of(smaller))
            for (const EdgeId g : brep_.edges_of(larger))
                if (have_common_face(e, g) && runs_beside(e, g)) found_.edges.push_back({e, g});
    }
    bool have_common_face(EdgeId e, EdgeId g) const {
        const auto faces = brep_.faces_of(g);
        const auto own = brep_.faces_of(e);
        return std::any_of(own.begin(), own.end(),
                           [&](FaceId face) { return std::find(faces.begin(), faces.end(), face) != faces.end(); });
    }
    bool runs_beside(EdgeId e, EdgeId g) const {
        if (brep_.is_degenerated(e) || brep_.is_degenerated(g)) return false;
        const auto [from, to] = projector_.range(e);
        constexpr int steps = 8;
        std::vector<Vec3> points;
        for (int i = 0; i <= steps; ++i) points.push_back(projector_.on_edge(e, from + (to - from) * i / steps));
        const double reach = nearness * patches_[brep_.faces_of(g).front().index()].longest;
        return std::any_of(points.begin(), points.end(),
                           [&](const Vec3& p) { return projector_.nearest(g, p).distance <= reach; });
    }

    bool is_before(FaceId face, const Vec3& p, const Vec3& direction, double reach) {
        if (!patches_[face.index()].box.grown(reach).contains(p)) return false;
        bool is_near = false;
        const Box around = Box{p, p}.grown(reach);
        triangles_of(face).visit_where([&](const Box& box) { return box.overlaps(around); },
                                       [&](std::int32_t i) {
                                           const auto q = corners(patches_[face.index()].triangles[std::size_t(i)]);
                                           const Vec3 n = normal(q);
                                           is_near |= std::abs(dot(n, direction)) > parallel_cosine &&
                                                      std::abs(dot(n, p - q[0])) <= reach;
                                       });
        return is_near;
    }

    const Brep& brep_;
    const Mesh& mesh_;
    const Projector projector_{brep_};
    std::vector<Patch> patches_;
    std::vector<std::unique_ptr<BoxTree>> trees_{patches_.size()};
    std::vector<std::size_t> rank_ = std::vector<std::size_t>(patches_.size(), 0);
    OppositePlaces found_{std::vector<std::vector<std::array<double, 2>>>(patches_.size()), {}};
};

Vec3 in_space(Vec2 p) { return {p.x, p.y, 0}; }

/// Distance in the chart from the boundary.
double clearance(Vec2 p, const FaceBoundary& boundary) {
    const auto point = [&](int i) { return in_space(boundary.points[static_cast<std::size_t>(i)]); };
    double least = std::numeric_limits<double>::infinity();
    const auto look_at = [&](const BoundarySegment& s) {
        least = std::min(least, squared_distance_to_segment(in_space(p), point(s.a), point(s.b)));
    };
    std::for_each(boundary.segments.begin(), boundary.segments.end(), look_at);
    std::for_each(boundary.inner.begin(), boundary.inner.end(), look_at);
    for (const int lone : boundary.lone_points) least = std::min(least, squared_length(in_space(p) - point(lone)));
    return std::sqrt(least);
}

bool is_in_any(const BoxTree& tree, const Vec3& p) {
    bool is_in = false;
    tree.visit_around(p, [&](std::int32_t) { is_in = true; });
    return is_in;
}

}  // namespace

OppositePlaces find_opposite_places(const Brep& brep, const Mesh& mesh, std::size_t first_new, RunContext& context) {
    return Finder(brep, mesh, first_new).find(context);
}

void put_first(std::span<const Vec2> places, std::span<const double> wanted, const FaceBoundary& boundary,
               const ChartDomain& domain, Seeds& seeds) {
    Seeds all;
    std::vector<Box> around;
    const auto take = [&](Vec2 p, double length, double keep_off) {
        all.points.push_back(p), all.wanted.push_back(length);
        around.push_back(Box{in_space(p), in_space(p)}.grown(keep_off * length));
    };
    for (std::size_t i = 0; i < seeds.fixed_count; ++i) take(seeds.points[i], seeds.wanted[i], boundary_spacing);
    const BoxTree fixed(around);
    std::vector<Box> at;
    for (std::size_t i = 0; i < places.size(); ++i)
        at.push_back(Box{in_space(places[i]), in_space(places[i])}.grown(same_place * wanted[i]));
    const BoxTree all_places(at);
    std::vector<char> is_taken(places.size(), 0);
    const auto is_taken_by_another = [&](std::size_t i) {  // opposite two faces that end above one another, say
        bool is_there = false;
        all_places.visit_around(in_space(places[i]),
                                [&](std::int32_t j) { is_there |= is_taken[std::size_t(j)] != 0; });
        return is_there;
    };
    void* hint = nullptr;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (domain.contains(places[i], hint) && clearance(places[i], boundary) > boundary_spacing * wanted[i] &&
            !is_in_any(fixed, in_space(places[i])) && !is_taken_by_another(i))
            take(places[i], wanted[i], spacing), is_taken[i] = 1;
    all.fixed_count = all.points.size();
    around.erase(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(seeds.fixed_count));
    const BoxTree opposite(around);
    for (std::size_t i = seeds.fixed_count; i < seeds.points.size(); ++i) {
        if (is_in_any(opposite, in_space(seeds.points[i]))) continue;
        all.points.push_back(seeds.points[i]), all.wanted.push_back(seeds.wanted[i]);
    }
    seeds = std::move(all);
}

}  // namespace featuremesh

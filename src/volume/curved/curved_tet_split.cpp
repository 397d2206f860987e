// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/curved/curved_tet_split.h"

#include <algorithm>
#include <array>

#include "core/geometry.h"
#include "mesh/quality.h"
#include "mesh/second_order.h"

namespace featuremesh {
namespace {

/// A split may not leave flatter tets than this, degrees.
constexpr double least_dihedral_deg = 4;
/// Over length: an arc of 75 degrees. A side bent more than this is the trouble, however the elements lie.
constexpr double strong_bend = 0.17;

class Splitting {
  public:
    Splitting(Mesh& mesh, const Mesh& curved, const KeptCounts& kept, double least_volume)
        : mesh_(mesh),
          curved_(curved),
          kept_(kept),
          least_volume_(least_volume),
          is_touched_(mesh.tets.size(), false),
          tets_at_(mesh.points.size()),
          triangles_at_(mesh.points.size()) {
        for (std::size_t t = 0; t < mesh.tets.size(); ++t)
            for (NodeId n : mesh.tets[t]) tets_at_[n.index()].push_back(t);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (NodeId n : mesh.triangles[t]) triangles_at_[n.index()].push_back(t);
    }

    bool run(TetId tet) {
        if (is_touched_[tet.index()]) return false;
        if (boundary_triangles(tet) >= 2 && largest_bend(tet) < strong_bend)
            return split_inside(tet) || split_a_side(tet);
        return split_a_side(tet) || split_inside(tet);
    }

  private:
    using Side = std::array<NodeId, 2>;

    int boundary_triangles(TetId tet) const {
        int count = 0;
        const auto& n = mesh_.tets[tet.index()];
        for (const auto& face : tet_faces) {
            const auto& candidates = triangles_at_[n[face[0]].index()];
            count += std::any_of(candidates.begin(), candidates.end(), [&](std::size_t t) {
                return has(mesh_.triangles[t], n[face[1]]) && has(mesh_.triangles[t], n[face[2]]);
            });
        }
        return count;
    }
    template <std::size_t count>
    static bool has(const std::array<NodeId, count>& nodes, NodeId n) {
        return std::find(nodes.begin(), nodes.end(), n) != nodes.end();
    }
    double volume_of(const std::array<NodeId, 4>& n) const {
        return signed_volume(mesh_.point(n[0]), mesh_.point(n[1]), mesh_.point(n[2]), mesh_.point(n[3]));
    }
    /// With volumes of the whole and of its part.
    bool loses_least_volume(double whole, double part) const { return part < least_volume_ && whole >= least_volume_; }
    bool is_sound(const std::array<NodeId, 4>& n, const std::array<NodeId, 4>& whole) const {
        const Vec3 &a = mesh_.point(n[0]), &b = mesh_.point(n[1]), &c = mesh_.point(n[2]), &d = mesh_.point(n[3]);
        const double volume = signed_volume(a, b, c, d);
        return volume > 0 && !loses_least_volume(volume_of(whole), volume) &&
               dihedral_range(a, b, c, d).smallest_deg > least_dihedral_deg;
    }

    bool split_inside(TetId tet) {
        const std::size_t t = tet.index();
        if (t < kept_.tets) return false;
        const auto corners = mesh_.tets[t];
        if (loses_least_volume(volume_of(corners), volume_of(corners) / 4)) return false;
        Vec3 center;
        for (NodeId n : corners) center += mesh_.point(n) * 0.25;
        const NodeId middle = mesh_.add_node(center, entity_of(mesh_.tet_solids[t]));
        for (int i = 0; i < 4; ++i) {
            auto part = corners;
            part[i] = middle;
            if (i == 0)
                mesh_.tets[t] = part;
            else
                add_tet(part, mesh_.tet_solids[t]);
        }
        is_touched_[t] = true;
        return true;
    }

    /// Touched from the start: the sides it took over must not be split again with the others of their star only.
    void add_tet(const std::array<NodeId, 4>& corners, SolidId solid) {
        tets_at_.resize(mesh_.points.size());
        for (NodeId n : corners) tets_at_[n.index()].push_back(mesh_.tets.size());
        mesh_.add_tet(corners, solid);
        is_touched_.push_back(true);
    }

    double largest_bend(TetId tet) const {
        const auto bent = boundary_sides(tet);
        return bent.empty() ? 0 : -bent.front().first;
    }

    /// The tet's sides on the boundary with minus their bend over their length, the most bent one first.
    std::vector<std::pair<double, int>> boundary_sides(TetId tet) const {
        std::vector<std::pair<double, int>> bent;
        const auto& corners = mesh_.tets[tet.index()];
        for (int s = 0; s < 6; ++s) {
            const NodeId mid = curved_.tet_mids[tet.index()][s];
            if (curved_.entities[mid.index()].dim == 3) continue;
            const Vec3 &a = mesh_.point(corners[tet_sides[s][0]]), &b = mesh_.point(corners[tet_sides[s][1]]);
            bent.emplace_back(-distance(curved_.point(mid), (a + b) * 0.5) / distance(a, b), s);
        }
        std::sort(bent.begin(), bent.end());
        return bent;
    }

    bool split_a_side(TetId tet) {
        const auto corners = mesh_.tets[tet.index()];
        const auto bent = boundary_sides(tet);
        return std::any_of(bent.begin(), bent.end(), [&](const auto& side) {
            return split_side({corners[tet_sides[side.second][0]], corners[tet_sides[side.second][1]]},
                              curved_.tet_mids[tet.index()][side.second]);
        });
    }

    bool split_side(Side side, NodeId curved_mid) {
        std::vector<std::size_t> tets, triangles, segments;
        for (std::size_t t : tets_at_[side[0].index()])
            if (has(mesh_.tets[t], side[1])) tets.push_back(t);
        for (std::size_t t : triangles_at_[side[0].index()])
            if (has(mesh_.triangles[t], side[1])) triangles.push_back(t);
        if (curved_.entities[curved_mid.index()].dim == 1)
            for (std::size_t s = 0; s < mesh_.segments.size(); ++s)
                if (has(mesh_.segments[s], side[0]) && has(mesh_.segments[s], side[1])) segments.push_back(s);
        const auto is_kept = [](const std::vector<std::size_t>& list, std::size_t count) {
            return std::any_of(list.begin(), list.end(), [&](std::size_t i) { return i < count; });
        };
        if (is_kept(tets, kept_.tets) || is_kept(triangles, kept_.triangles) || is_kept(segments, kept_.segments))
            return false;
        if (std::any_of(tets.begin(), tets.end(), [&](std::size_t t) { return is_touched_[t]; })) return false;
        return apply(side, curved_mid, tets, triangles, segments);
    }

    bool apply(Side side, NodeId curved_mid, const std::vector<std::size_t>& tets,
               const std::vector<std::size_t>& triangles, const std::vector<std::size_t>& segments) {
        const std::size_t m = curved_mid.index();
        const Number number_before = mesh_.next_node_number;
        const NodeId middle = mesh_.add_node(curved_.points[m], curved_.entities[m], curved_.parameters[m]);
        for (std::size_t t : tets)
            if (!is_sound(with(mesh_.tets[t], side[0], middle), mesh_.tets[t]) ||
                !is_sound(with(mesh_.tets[t], side[1], middle), mesh_.tets[t])) {
                mesh_.points.pop_back(), mesh_.entities.pop_back(), mesh_.parameters.pop_back(),
                    mesh_.node_numbers.pop_back();
                mesh_.next_node_number = number_before;
                return false;
            }
        for (std::size_t t : tets) {
            add_tet(with(mesh_.tets[t], side[0], middle), mesh_.tet_solids[t]);
            mesh_.tets[t] = with(mesh_.tets[t], side[1], middle);
            is_touched_[t] = true;
        }
        for (std::size_t t : triangles) {
            mesh_.add_triangle(with(mesh_.triangles[t], side[0], middle), mesh_.triangle_faces[t]);
            mesh_.triangles[t] = with(mesh_.triangles[t], side[1], middle);
        }
        for (std::size_t s : segments) {
            const auto [first, last] = mesh_.segments[s];
            mesh_.add_segment({middle, last}, mesh_.segment_edges[s]);
            mesh_.segments[s] = {first, middle};
        }
        return true;
    }

    template <std::size_t count>
    static std::array<NodeId, count> with(std::array<NodeId, count> nodes, NodeId old, NodeId now) {
        std::replace(nodes.begin(), nodes.end(), old, now);
        return nodes;
    }

    Mesh& mesh_;
    const Mesh& curved_;
    const KeptCounts kept_;
    const double least_volume_;
    std::vector<bool> is_touched_;
    std::vector<std::vector<std::size_t>> tets_at_, triangles_at_;
};

}  // namespace

std::size_t split_folded_tets(Mesh& mesh, const Mesh& curved, const std::vector<TetId>& folded, const KeptCounts& kept,
                              double least_volume) {
    Splitting splitting(mesh, curved, kept, least_volume);
    std::size_t added = 0;
    for (TetId t : folded) added += splitting.run(t);
    mesh.corner_count = mesh.points.size();
    return added;
}

}  // namespace featuremesh

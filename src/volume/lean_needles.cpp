// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/lean_needles.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "core/geometry.h"
#include "volume/tets/needles.h"
#include "volume/tets/tet_measures.h"

namespace featuremesh {

namespace {

template <std::size_t N>
bool holds(const std::array<NodeId, N>& corners, NodeId n) {
    return std::find(corners.begin(), corners.end(), n) != corners.end();
}

template <std::size_t N>
std::array<NodeId, N> replaced(std::array<NodeId, N> corners, NodeId from, NodeId to) {
    std::replace(corners.begin(), corners.end(), from, to);
    return corners;
}

/// The two triangles of a face at the side b, d, with their other corners.
struct Quad {
    TriangleId first, second;
    NodeId a, b, d, e;
};

/// The tets round a side on the surface, from the one at `a` to the one at `e`: tet i has path[i] and path[i + 1].
struct Fan {
    std::vector<TetId> tets;
    std::vector<NodeId> path;
};

class NeedleStrips {
  public:
    NeedleStrips(const Brep& brep, const Projector& projector, std::span<const TriangleId> triangles,
                 std::size_t first_tet, Mesh& mesh)
        : brep_(brep),
          projector_(projector),
          triangles_(triangles),
          first_tet_(first_tet),
          mesh_(mesh),
          reach_(brep.tolerances().contact()),
          least_volume_(brep.tolerances().least_volume()) {}

    std::size_t lean() {
        find_needle_nodes();
        if (nodes_.empty()) return 0;
        list_neighbours();
        std::vector<std::array<NodeId, 2>> wanted;
        for (const auto& [edge, own] : chains_at_needles()) {
            const auto [first, last] = brep_.ends_of(edge);
            if (first == last) continue;
            const std::vector<NodeId> sorted = nodes_along(edge, own);
            for (std::size_t i = 1; i < sorted.size() && sorted.size() > own.size(); ++i)
                wanted.push_back({sorted[i - 1], sorted[i]});
        }
        std::size_t turned = 0;
        for (const bool is_careful : {true, false}) {
            is_careful_ = is_careful;
            for (const auto& [a, b] : wanted) turned += lead(a, b) + lead(b, a);
        }
        return turned;
    }

  private:
    const Vec3& place(NodeId n) const { return mesh_.point(n); }
    bool is_outside(NodeId n) const { return mesh_.entities[n.index()].dim < 3; }
    bool is_on_edge(NodeId n) const { return mesh_.entities[n.index()].dim < 2; }

    /// Nodes on edges whose triangles are lower than what tells nodes apart.
    void find_needle_nodes() {
        for (const TriangleId t : triangles_) {
            const auto& [a, b, c] = mesh_.triangles[t.index()];
            const Vec3 u = place(b) - place(a), v = place(c) - place(a);
            const double longest = std::max({squared_length(u), squared_length(v), squared_length(u - v)});
            if (squared_length(cross(u, v)) >= reach_ * reach_ * longest) continue;
            for (const NodeId n : {a, b, c})
                if (is_on_edge(n)) nodes_.insert(n);
        }
    }

    void list_neighbours() {
        std::vector<char> is_needle(mesh_.node_count(), 0);
        for (const NodeId n : nodes_) is_needle[n.index()] = 1;
        for (const TriangleId t : triangles_)
            for (const NodeId n : mesh_.triangles[t.index()])
                if (is_needle[n.index()]) triangles_at_[n].push_back(t);
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
            for (const NodeId n : mesh_.tets[t])
                if (is_needle[n.index()]) tets_at_[n].push_back(TetId(t));
        for (const auto& [a, b] : mesh_.segments)
            if (is_needle[a.index()] || is_needle[b.index()]) segments_.insert(std::minmax(a, b));
    }

    /// By edge with such nodes, all its nodes.
    std::map<EdgeId, std::set<NodeId>> chains_at_needles() const {
        std::map<EdgeId, std::set<NodeId>> chains;
        for (std::size_t s = 0; s < mesh_.segments.size(); ++s)
            if (nodes_.count(mesh_.segments[s][0]) || nodes_.count(mesh_.segments[s][1]))
                chains[mesh_.segment_edges[s]];
        for (std::size_t s = 0; s < mesh_.segments.size(); ++s)
            if (const auto it = chains.find(mesh_.segment_edges[s]); it != chains.end())
                it->second.insert(mesh_.segments[s].begin(), mesh_.segments[s].end());
        return chains;
    }

    /// The edge's own nodes and others on it, in its order.
    std::vector<NodeId> nodes_along(EdgeId edge, const std::set<NodeId>& own) const {
        Box box;
        for (const NodeId n : own) box.add(place(n));
        box = box.grown(0.3 * box.diagonal() + reach_);
        std::vector<std::pair<double, NodeId>> found;
        const auto add = [&](NodeId n) {
            const OnEdge nearest = projector_.nearest(edge, place(n));
            if (nearest.distance < reach_) found.emplace_back(nearest.t, n);
        };
        for (const NodeId n : own) add(n);
        for (const NodeId n : nodes_)
            if (!own.count(n) && box.contains(place(n))) add(n);
        std::sort(found.begin(), found.end());
        // Rounding errors do not tell which of two is first.
        const double level = found.empty() ? 0 : 1e-9 * (found.back().first - found.front().first);
        for (std::size_t i = 1; i < found.size(); ++i)
            if (found[i].first - found[i - 1].first <= level) found[i].first = found[i - 1].first;
        std::sort(found.begin(), found.end());
        std::vector<NodeId> sorted;
        for (const auto& [t, n] : found) sorted.push_back(n);
        return sorted;
    }

    /// Turns sides of triangles until one side joins `from` and `to`. One turn is enough if only one side is between
    /// them. Else looks for a node beside `from` that has a side to `to`, and turns all sides between them there.
    std::size_t lead(NodeId from, NodeId to) {
        if (join(from, to)) return 1;
        const auto at_from = triangles_at_.find(from);
        if (at_from == triangles_at_.end()) return 0;
        std::set<std::pair<FaceId, NodeId>> beside;
        for (const TriangleId t : at_from->second)
            for (const NodeId n : mesh_.triangles[t.index()]) {
                if (n == to) return 0;
                if (n != from && distance(place(n), place(from)) < reach_)
                    beside.emplace(mesh_.triangle_faces[t.index()], n);
            }
        std::size_t turned = 0;
        for (const auto& [face, n] : beside)
            if (!triangles_with(n, to, face).empty()) turned += sweep(from, n, to, face);
        return turned;
    }

    std::size_t sweep(NodeId from, NodeId beside, NodeId to, FaceId face) {
        constexpr std::size_t most = 12;
        std::size_t turned = 0;
        while (turned < most) {
            const std::vector<TriangleId> first = triangles_with(from, beside, face);
            if (first.size() != 1) break;
            const NodeId middle = third(first[0], from, beside);
            if (middle == to) break;
            std::vector<TriangleId> next = triangles_with(beside, middle, face);
            std::erase(next, first[0]);
            if (next.size() != 1 || !join(from, third(next[0], beside, middle))) break;
            ++turned;
        }
        return turned;
    }

    std::vector<TriangleId> triangles_with(NodeId a, NodeId b, FaceId face) const {
        std::vector<TriangleId> found;
        if (const auto it = triangles_at_.find(a); it != triangles_at_.end())
            for (const TriangleId t : it->second)
                if (mesh_.triangle_faces[t.index()] == face && holds(mesh_.triangles[t.index()], a) &&
                    holds(mesh_.triangles[t.index()], b))
                    found.push_back(t);
        return found;
    }

    NodeId third(TriangleId t, NodeId a, NodeId b) const {
        const auto& corners = mesh_.triangles[t.index()];
        return *std::find_if(corners.begin(), corners.end(), [&](NodeId n) { return n != a && n != b; });
    }

    /// Turns the side between two triangles of a face at `a` and at `e`.
    bool join(NodeId a, NodeId e) {
        const std::optional<Quad> quad = quad_between(a, e);
        if (!quad) return false;
        const std::optional<Fan> fan = fan_of(*quad);
        if (!fan) return false;
        const std::vector<std::array<NodeId, 4>> tets = turned_tets(*quad, *fan);
        if (tets.empty()) return false;
        const SolidId solid = mesh_.tet_solids[fan->tets[0].index()];
        for (std::size_t i = 0; i < tets.size(); ++i) {
            const TetId tet(i < fan->tets.size() ? fan->tets[i].index() : mesh_.tets.size());
            if (i < fan->tets.size())
                mesh_.tets[tet.index()] = tets[i];
            else
                mesh_.add_tet(tets[i], solid);
            note(tets_at_, tets[i], tet);
        }
        turn(quad->first, quad->d, e);
        turn(quad->second, quad->b, a);
        return true;
    }

    /// One that was kept is a new one then: its number tells what it was.
    void turn(TriangleId triangle, NodeId from, NodeId to) {
        auto& corners = mesh_.triangles[triangle.index()];
        corners = replaced(corners, from, to);
        mesh_.triangle_numbers[triangle.index()] = mesh_.next_element_number++;
        note(triangles_at_, corners, triangle);
    }

    /// The lists may go on naming what a node has no longer.
    template <class Id, std::size_t N>
    static void note(std::map<NodeId, std::vector<Id>>& lists, const std::array<NodeId, N>& corners, Id id) {
        for (const NodeId n : corners)
            if (const auto it = lists.find(n);
                it != lists.end() && std::find(it->second.begin(), it->second.end(), id) == it->second.end())
                it->second.push_back(id);
    }

    std::optional<Quad> quad_between(NodeId a, NodeId e) const {
        const auto at_a = triangles_at_.find(a);
        if (at_a == triangles_at_.end()) return {};
        for (const TriangleId t : at_a->second) {
            const auto& corners = mesh_.triangles[t.index()];
            if (!holds(corners, a) || holds(corners, e)) continue;
            const std::size_t i = std::size_t(std::find(corners.begin(), corners.end(), a) - corners.begin());
            const NodeId b = corners[(i + 1) % 3], d = corners[(i + 2) % 3];
            const auto at_b = triangles_at_.find(b);
            if (at_b == triangles_at_.end() || segments_.contains(std::minmax(b, d))) continue;  // it may be a seam
            for (const TriangleId u : at_b->second) {
                const auto& other = mesh_.triangles[u.index()];
                if (u != t && mesh_.triangle_faces[u.index()] == mesh_.triangle_faces[t.index()] && holds(other, b) &&
                    holds(other, d) && holds(other, e))
                    return Quad{t, u, a, b, d, e};
            }
        }
        return {};
    }

    /// None where kept tets or two solids are at the side, or too many tets.
    std::optional<Fan> fan_of(const Quad& quad) const {
        constexpr std::size_t most = 8;
        const auto solids = brep_.solids_beside(mesh_.triangle_faces[quad.first.index()]);
        if (solids[0].is_valid() == solids[1].is_valid()) return {};
        std::vector<TetId> around;
        if (const auto it = tets_at_.find(quad.b); it != tets_at_.end())
            for (const TetId t : it->second) {
                if (!holds(mesh_.tets[t.index()], quad.b) || !holds(mesh_.tets[t.index()], quad.d)) continue;
                if (t.index() < first_tet_ || around.size() == most) return {};
                around.push_back(t);
            }
        Fan fan{{}, {quad.a}};
        while (fan.path.back() != quad.e) {
            const auto next = std::find_if(around.begin(), around.end(), [&](TetId t) {
                return holds(mesh_.tets[t.index()], fan.path.back()) &&
                       std::find(fan.tets.begin(), fan.tets.end(), t) == fan.tets.end();
            });
            if (next == around.end()) return {};
            fan.tets.push_back(*next);
            for (const NodeId n : mesh_.tets[next->index()])
                if (n != quad.b && n != quad.d && n != fan.path.back()) {
                    fan.path.push_back(n);
                    break;
                }
        }
        return fan.tets.size() == around.size() && fan.tets.size() > 1 ? std::optional(fan) : std::nullopt;
    }

    struct Worth {
        double volume, flatness;
    };
    Worth worth_of(const std::vector<std::array<NodeId, 4>>& tets) const {
        Worth worst{1e300, 0};
        for (const auto& [a, b, c, d] : tets) {
            const std::array<Vec3, 4> p{place(a), place(b), place(c), place(d)};
            worst.volume = std::min(worst.volume, signed_volume(p[0], p[1], p[2], p[3]));
            worst.flatness = std::max(worst.flatness,
                                      unforced_flatness(flatness(p[0], p[1], p[2], p[3]), p,
                                                        {is_outside(a), is_outside(b), is_outside(c), is_outside(d)}));
        }
        return worst;
    }

    /// The best of the fans of triangles over the path, each triangle with a tet to both ends of the old side; none
    /// where that is much worse than what there is.
    std::vector<std::array<NodeId, 4>> turned_tets(const Quad& quad, const Fan& fan) const {
        constexpr double kept_share = 0.4, least_angle_deg = 2;
        std::vector<std::array<NodeId, 4>> old, best;
        for (const TetId t : fan.tets) old.push_back(mesh_.tets[t.index()]);
        const Worth before = worth_of(old);
        double most = std::min(before.volume * (1 - 1e-9), least_volume_);
        if (is_careful_) most = std::max(most, kept_share * before.volume);
        double flattest = 1 - kept_share * kept_share * (1 - before.flatness);
        if (!is_careful_) flattest = std::max(flattest, flatness_of_angle(least_angle_deg));
        const bool is_left = is_in_order(fan, quad);
        for (std::size_t centre = 0; centre < fan.path.size(); ++centre) {
            std::vector<std::array<NodeId, 4>> tets;
            for (std::size_t i = 0; i < fan.path.size(); ++i) {
                const std::size_t j = (i + 1) % fan.path.size();
                if (i == centre || j == centre) continue;
                std::array<NodeId, 3> triangle{fan.path[centre], fan.path[i], fan.path[j]};
                if (!is_left) std::swap(triangle[1], triangle[2]);
                tets.push_back({triangle[0], triangle[1], triangle[2], quad.d});
                tets.push_back({triangle[0], triangle[2], triangle[1], quad.b});
            }
            const Worth worth = worth_of(tets);
            if (worth.volume <= most || worth.flatness > flattest) continue;
            most = worth.volume;
            best = std::move(tets);
        }
        return best;
    }

    /// Whether the path goes counterclockwise as seen from d.
    bool is_in_order(const Fan& fan, const Quad& quad) const {
        return signed_volume(place(quad.b), place(fan.path[0]), place(fan.path[1]), place(quad.d)) > 0;
    }

    const Brep& brep_;
    const Projector& projector_;
    std::span<const TriangleId> triangles_;
    std::size_t first_tet_;
    Mesh& mesh_;
    double reach_, least_volume_;
    bool is_careful_ = true;  ///< tets may not get much thinner, either
    std::set<NodeId> nodes_;
    std::set<std::pair<NodeId, NodeId>> segments_;  ///< with such a node, lower first
    std::map<NodeId, std::vector<TriangleId>> triangles_at_;
    std::map<NodeId, std::vector<TetId>> tets_at_;
};

}  // namespace

std::size_t lean_needles(const Brep& brep, const Projector& projector, std::span<const TriangleId> triangles,
                         std::size_t first_tet, Mesh& mesh) {
    return NeedleStrips(brep, projector, triangles, first_tet, mesh).lean();
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/distinct_sides.h"

#include <algorithm>
#include <set>
#include <unordered_set>

namespace featuremesh {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::uint64_t side_key(std::int32_t a, std::int32_t b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint32_t>(std::max(a, b));
}

class SideBook {
  public:
    /// Of the mesh only sides between nodes of the filled triangles are of interest.
    SideBook(std::span<const FilledFace> faces, std::span<const std::array<NodeId, 2>> segments, const Mesh& mesh)
        : mesh_(mesh), next_inner_(static_cast<std::int32_t>(mesh.node_count())), may_meet_(mesh.node_count(), 0) {
        for (const FilledFace& face : faces)
            for (const auto& triangle : face.filling->triangles)
                for (const int p : triangle)
                    if (at(p) < face.boundary->nodes.size()) mark(face.boundary->nodes[at(p)]);
        for (const auto& [a, b] : segments)
            if (may_meet_[a.index()] && may_meet_[b.index()]) sides_.insert(side_key(a.value, b.value));
        for (const auto& t : mesh.triangles) {
            const std::array<bool, 3> meets{may_meet_[t[0].index()] != 0, may_meet_[t[1].index()] != 0,
                                            may_meet_[t[2].index()] != 0};
            for (int i = 0; i < 3; ++i)
                if (meets[at(i)] && meets[at((i + 1) % 3)])
                    sides_.insert(side_key(t[at(i)].value, t[at((i + 1) % 3)].value));
            if (meets[0] && meets[1] && meets[2]) triangles_.insert(sorted(t));
        }
    }

    std::size_t settle(FilledFace& face) {
        current_ = &face;
        find_copies();
        std::unordered_set<std::uint64_t> own,
            seen;  // boundary pieces; inner sides, each of which is met from both of its triangles
        for (const auto& s : face.boundary->segments) own.insert(side_key(s.a, s.b));
        for (const auto& s : face.boundary->inner) own.insert(side_key(s.a, s.b));
        const std::size_t count = face.filling->triangles.size();
        std::size_t added = 0;
        for (std::size_t t = 0; t < count; ++t) {
            for (int i = 0; i < 3; ++i) {
                const int a = face.filling->triangles[t][at(i)], b = face.filling->triangles[t][at((i + 1) % 3)];
                if (!may_meet_again(a, b) || own.count(side_key(a, b)) || !seen.insert(side_key(a, b)).second) continue;
                if (sides_.insert(side_key(node(a), node(b))).second) continue;
                split_side(face, a, b);
                ++added;
            }
            const auto c = face.filling->triangles[t];
            if (!is_on_edge(c[0]) || !is_on_edge(c[1]) || !is_on_edge(c[2])) continue;
            if (triangles_.insert(sorted({NodeId(node(c[0])), NodeId(node(c[1])), NodeId(node(c[2]))})).second)
                continue;
            split_triangle(face, t);
            ++added;
        }
        next_inner_ += static_cast<std::int32_t>(face.filling->points.size());
        return added;
    }

  private:
    static std::array<NodeId, 3> sorted(std::array<NodeId, 3> t) {
        std::sort(t.begin(), t.end());
        return t;
    }
    void mark(NodeId n) { may_meet_[n.index()] = is_on_edge(n); }
    bool is_on_edge(NodeId n) const { return mesh_.entities[n.index()].dim < 2; }
    bool is_boundary(int p) const { return at(p) < current_->boundary->nodes.size(); }
    bool is_on_edge(int p) const { return is_boundary(p) && is_on_edge(current_->boundary->nodes[at(p)]); }
    bool is_copy(int p) const { return is_boundary(p) && copies_.count(current_->boundary->nodes[at(p)].value) > 0; }
    bool is_pole(int p) const { return is_boundary(p) && poles_.count(current_->boundary->nodes[at(p)].value) > 0; }

    /// May a second side join the same two nodes elsewhere? Two nodes on edges may be joined in another face, too. A
    /// node with several copies in the chart may be joined again at another place of this face. Sides at a pole do not
    /// count: the flat triangles there, which are left out, join them.
    bool may_meet_again(int a, int b) const {
        if (is_pole(a) || is_pole(b)) return false;
        return (is_on_edge(a) && is_on_edge(b)) || is_copy(a) || is_copy(b);
    }

    void find_copies() {
        copies_.clear(), poles_.clear();
        std::unordered_set<std::int32_t> met;
        for (const NodeId n : current_->boundary->nodes)
            if (may_meet_[n.index()] && !met.insert(n.value).second) copies_.insert(n.value);
        for (const auto& s : current_->boundary->segments)
            if (s.is_pole) poles_.insert(current_->boundary->nodes[at(s.a)].value);
    }

    /// A number for the node of a point; those of inner nodes are not the mesh's yet.
    std::int32_t node(int p) const {
        return is_boundary(p) ? current_->boundary->nodes[at(p)].value
                              : next_inner_ + p - static_cast<std::int32_t>(current_->boundary->nodes.size());
    }

    static Vec2 point(const FilledFace& face, int p) {
        const std::size_t count = face.boundary->points.size();
        return at(p) < count ? face.boundary->points[at(p)]
                             : face.chart->to_plane(face.filling->parameters[at(p) - count]);
    }

    static int add_point(FilledFace& face, Vec2 p) {
        face.filling->points.push_back(face.chart->point(p));
        face.filling->parameters.push_back(face.chart->to_uv(p));
        return static_cast<int>(face.boundary->points.size() + face.filling->points.size()) - 1;
    }

    static void split_side(FilledFace& face, int a, int b) {
        const int middle = add_point(face, 0.5 * (point(face, a) + point(face, b)));
        auto& triangles = face.filling->triangles;
        const std::size_t count = triangles.size();
        for (std::size_t t = 0; t < count; ++t)
            for (int i = 0; i < 3; ++i) {
                const int p = triangles[t][at(i)], q = triangles[t][at((i + 1) % 3)], r = triangles[t][at((i + 2) % 3)];
                if (side_key(p, q) != side_key(a, b)) continue;
                triangles[t] = {p, middle, r};
                triangles.push_back({middle, q, r});
                break;
            }
    }

    static void split_triangle(FilledFace& face, std::size_t t) {
        const auto [a, b, c] = face.filling->triangles[t];
        const int centre = add_point(face, (1.0 / 3) * (point(face, a) + point(face, b) + point(face, c)));
        auto& triangles = face.filling->triangles;
        triangles[t] = {a, b, centre};
        triangles.push_back({b, c, centre});
        triangles.push_back({c, a, centre});
    }

    const Mesh& mesh_;
    std::int32_t next_inner_;
    std::vector<char> may_meet_;  // by node: on an edge, and a corner of a filled triangle
    const FilledFace* current_ = nullptr;
    std::unordered_set<std::int32_t> copies_, poles_;
    std::unordered_set<std::uint64_t> sides_;
    std::set<std::array<NodeId, 3>> triangles_;
};

}  // namespace

std::size_t make_sides_distinct(std::span<FilledFace> faces, std::span<const std::array<NodeId, 2>> segments,
                                const Mesh& mesh) {
    SideBook book(faces, segments, mesh);
    std::size_t added = 0;
    for (FilledFace& face : faces) added += book.settle(face);
    return added;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/flip_recovery.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry.h"
#include "core/sort_once.h"
#include "core/sorted_pair.h"
#include "volume/recovery/levelled_points.h"
#include "volume/tets/cavity_editor.h"
#include "volume/tets/edge_removal.h"
#include "volume/tets/orientation.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_measures.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

using Corners = std::array<int, 3>;
using Side = std::array<int, 2>;

std::array<Side, 3> sides_of(const Corners& c) {
    return {sorted_pair(c[0], c[1]), sorted_pair(c[1], c[2]), sorted_pair(c[2], c[0])};
}

Corners sorted(Corners c) {
    std::sort(c.begin(), c.end());
    return c;
}

/// What is to come back: an edge (c is -1), crossed by faces, or a triangle whose sides are there, crossed by edges.
struct Target {
    int a, b, c = -1;
    bool is_edge() const { return c < 0; }
};

/// The tets round an edge: tet i is (from, to, vertices[i], vertices[i + 1]), in an even permutation. On the hull the
/// last vertex has no tet behind it.
struct Ring {
    static constexpr int most = 24;
    int from = -1, to = -1;
    bool is_open = false;
    std::vector<int> vertices, tets;
    int size() const { return static_cast<int>(vertices.size()); }
};

/// Tets in place of others, and by how many crossings with the target they have more or less.
struct Change {
    std::vector<int> removed;
    std::vector<Tet> added;
    double cost = 0;
};

class FlipRecovery {
  public:
    FlipRecovery(const Cavity& cavity, const CavityFill& fill, const RunContext& context)
        : cavity_(cavity),
          context_(context),
          complex_(complex_of(fill)),
          editor_(complex_),
          open_facets_(fill.places.missing) {
        for (const Facet& f : cavity.facets) {
            facets_.push_back(sorted(f.corners));
            for (const Side& s : sides_of(f.corners)) sides_.push_back(s);
        }
        sort_once(facets_);
        sort_once(sides_);
    }

    /// Sides in this order, where they are missing, then the others; `hard` gets those that could not be had in front.
    std::optional<Triangulation> run(std::vector<Side>& hard) {
        std::vector<Side> open_sides;
        for (const int f : open_facets_)
            for (const Side& s : sides_of(cavity_.facets[f].corners))
                if (std::find(hard.begin(), hard.end(), s) == hard.end()) open_sides.push_back(s);
        sort_once(open_sides);
        open_sides.insert(open_sides.begin(), hard.begin(), hard.end());
        std::size_t left = open_sides.size() + open_facets_.size(), before = left + 1;
        while (left > 0 && left < before) {
            before = left;
            std::erase_if(open_sides, [&](const Side& s) { return recover({s[0], s[1]}); });
            std::erase_if(open_facets_, [&](int f) { return recover_facet(cavity_.facets[f].corners); });
            left = open_sides.size() + open_facets_.size();
        }
        if (left == 0) return triangulation();
        std::erase_if(hard, [&](const Side& s) {
            return std::find(open_sides.begin(), open_sides.end(), s) != open_sides.end();
        });
        hard.insert(hard.begin(), open_sides.begin(), open_sides.end());
        return {};
    }

    const std::vector<int>& left() const { return open_facets_; }

  private:
    static TetComplex complex_of(const CavityFill& fill) {
        TetComplex complex;
        complex.points = fill.points;
        complex.mobility.assign(fill.points.size(), Mobility::fixed);
        complex.tets = fill.triangulation.tets;
        complex.neighbours = fill.triangulation.neighbours;
        complex.tet_of_vertex.assign(fill.points.size(), -1);
        for (std::size_t t = 0; t < complex.tets.size(); ++t)
            for (const int c : complex.tets[t]) complex.tet_of_vertex[c] = static_cast<int>(t);
        return complex;
    }

    Triangulation triangulation() const {
        std::vector<int> index(complex_.tets.size(), -1);
        Triangulation result;
        for (std::size_t t = 0; t < complex_.tets.size(); ++t) {
            if (complex_.tets[t][0] < 0) continue;
            index[t] = static_cast<int>(result.tets.size());
            result.tets.push_back(complex_.tets[t]);
            result.neighbours.push_back(complex_.neighbours[t]);
        }
        for (auto& neighbours : result.neighbours)
            for (int& n : neighbours)
                if (n >= 0) n = index[n];
        return result;
    }

    const Vec3& point(int v) const { return complex_.points[v]; }
    int turn(int a, int b, int c, int d) const { return orientation(point(a), point(b), point(c), point(d)); }

    bool is_protected(const Side& s) const {
        return std::binary_search(sides_.begin(), sides_.end(), sorted_pair(s[0], s[1]));
    }
    bool is_protected(int a, int b, int c) const {
        return std::binary_search(facets_.begin(), facets_.end(), sorted({a, b, c}));
    }

    /// All tets of a vertex, on the hull, too.
    std::vector<int> star_of(int v) {
        std::vector<int> star{complex_.tet_of_vertex[v]};
        editor_.begin_marks();
        editor_.mark(star[0]);
        for (std::size_t i = 0; i < star.size(); ++i)
            for (int k = 0; k < 4; ++k) {
                const int next = complex_.neighbours[star[i]][k];
                if (complex_.tets[star[i]][k] == v || next < 0 || editor_.is_marked(next)) continue;
                editor_.mark(next);
                star.push_back(next);
            }
        return star;
    }

    static bool has_corner(const Tet& tet, int v) { return tet[corner_of(tet, v)] == v; }
    bool has_edge(int a, int b) { return tet_with({a, b}) >= 0; }
    bool has_face(int a, int b, int c) {
        for (const int t : star_of(a))
            if (has_corner(complex_.tets[t], b) && has_corner(complex_.tets[t], c)) return true;
        return false;
    }

    /// Whether segment (a, b) passes through the triangle's inside or its rim, from one side to the other.
    bool passes(int a, int b, int p, int q, int r) const {
        for (const int v : {p, q, r})
            if (v == a || v == b) return false;
        if (turn(p, q, r, a) * turn(p, q, r, b) >= 0) return false;
        const int s = turn(a, b, p, q), t = turn(a, b, q, r), u = turn(a, b, r, p);
        return (s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0);
    }
    bool face_crosses(const Target& target, int p, int q, int r) const {
        return target.is_edge() && passes(target.a, target.b, p, q, r);
    }
    bool edge_crosses(const Target& target, int p, int q) const {
        return !target.is_edge() && passes(p, q, target.a, target.b, target.c);
    }

    bool is_there(const Target& t) { return t.is_edge() ? has_edge(t.a, t.b) : has_face(t.a, t.b, t.c); }

    bool recover(const Target& target) {
        constexpr int most_changes = 200, most_sideways = 8;
        int sideways = 0;
        for (int i = 0; i < most_changes; ++i) {
            context_.check_cancelled();
            if (is_there(target)) return true;
            if (!improve(target) && (sideways++ == most_sideways || !change_sideways(target, sideways))) return false;
        }
        return false;
    }
    bool recover_facet(const Corners& c) {
        for (const Side& s : sides_of(c))
            if (!has_edge(s[0], s[1])) return false;
        return recover({c[0], c[1], c[2]});
    }

    /// One change after which there are fewer crossings; false where there is none.
    bool improve(const Target& target) {
        const std::vector<std::array<int, 2>> faces = crossings(target);
        for (const auto& [tet, face] : faces) {
            std::optional<Change> best = target.is_edge() ? face_flip(target, tet, face) : std::nullopt;
            for (const Side& edge : crossed_edges(target, tet, face)) {
                std::optional<Change> change = edge_removal(target, tet, edge, 0);
                if (change && (!best || change->cost < best->cost)) best = std::move(change);
            }
            if (!best || best->cost >= 0) continue;
            editor_.replace(best->removed, best->added);
            return true;
        }
        for (const auto& [tet, face] : faces)
            for (const Side& edge : crossed_edges(target, tet, face))
                if (clear(target, tet, edge)) return true;
        return false;
    }

    /// Some change after which there are as many crossings, another one each time.
    bool change_sideways(const Target& target, int turn) {
        std::vector<Change> changes;
        const auto collect = [&](std::optional<Change> change) {
            if (change && change->cost < 0.5) changes.push_back(std::move(*change));
        };
        for (const auto& [tet, face] : crossings(target)) {
            if (target.is_edge()) collect(face_flip(target, tet, face));
            for (const Side& edge : crossed_edges(target, tet, face)) collect(edge_removal(target, tet, edge, 0.5));
        }
        if (changes.empty()) return false;
        const Change& chosen = changes[static_cast<std::size_t>(turn) * 0x9E3779B1u % changes.size()];
        editor_.replace(chosen.removed, chosen.added);
        return true;
    }

    /// Takes an edge out after one that stands in its way, a spoke of its ring, or leaves all as it was.
    bool clear(const Target& target, int tet, const Side& edge) {
        Ring ring;
        if (!find_ring(tet, edge, ring) || ring.is_open) return false;
        for (int i = 0; i < ring.size(); ++i)
            for (int end = 0; end < 2; ++end) {
                const Side spoke{edge[end], ring.vertices[i]};
                const std::optional<Change> first =
                    edge_removal(target, ring.tets[i], spoke, std::numeric_limits<int>::max(), edge[1 - end]);
                if (!first) continue;
                std::vector<Tet> old;
                for (const int t : first->removed) old.push_back(complex_.tets[t]);
                const std::span<const int> ids = editor_.replace(first->removed, first->added);
                std::vector<int> added(ids.begin(), ids.end());
                const auto second = edge_removal(target, tet_with(edge), edge, -first->cost);
                if (second) {
                    editor_.replace(second->removed, second->added);
                    return true;
                }
                // the editor took free slots from the end of its list: given back so, all tets have their ids again
                if (added.size() > old.size())
                    std::reverse(added.begin() + static_cast<std::ptrdiff_t>(old.size()), added.end());
                editor_.replace(added, old);
            }
        return false;
    }

    int tet_with(const Side& edge) {
        for (const int t : star_of(edge[0]))
            if (has_corner(complex_.tets[t], edge[1])) return t;
        return -1;
    }

    /// Edges of a crossed face that may be in the way and are no facet's side.
    std::vector<Side> crossed_edges(const Target& target, int tet, int face) const {
        const Tet& t = complex_.tets[tet];
        const auto& c = opposite_face[face];
        std::vector<Side> edges;
        for (const Side& s : sides_of({t[c[0]], t[c[1]], t[c[2]]}))
            if ((target.is_edge() || edge_crosses(target, s[0], s[1])) && !is_protected(s)) edges.push_back(s);
        return edges;
    }

    /// Faces of tets, (tet, opposite corner), that the target passes through, from its ends on; for a triangle faces
    /// with an edge that passes through it.
    std::vector<std::array<int, 2>> crossings(const Target& target) {
        std::vector<std::array<int, 2>> found;
        std::vector<int> tets;
        if (target.is_edge()) {
            for (const int t : star_of(target.a))
                if (crosses(target, t, corner_of(complex_.tets[t], target.a))) tets.push_back(t);
        } else {
            for (const int t : star_of(target.a))
                if (has_corner(complex_.tets[t], target.b)) tets.push_back(t);
        }
        editor_.begin_marks();
        for (const int t : tets) editor_.mark(t);
        for (std::size_t i = 0; i < tets.size(); ++i)
            for (int k = 0; k < 4; ++k) {
                if (!crosses(target, tets[i], k)) continue;
                const int next = complex_.neighbours[tets[i]][k];
                found.push_back({tets[i], k});
                if (next < 0 || editor_.is_marked(next)) continue;
                editor_.mark(next);
                tets.push_back(next);
            }
        return found;
    }

    bool crosses(const Target& target, int tet, int face) const {
        const Tet& t = complex_.tets[tet];
        const auto& c = opposite_face[face];
        const int p = t[c[0]], q = t[c[1]], r = t[c[2]];
        if (target.is_edge()) return face_crosses(target, p, q, r);
        return edge_crosses(target, p, q) || edge_crosses(target, q, r) || edge_crosses(target, r, p);
    }

    bool is_positive(const Tet& t) const { return turn(t[0], t[1], t[2], t[3]) > 0; }
    /// Of changes that cross as little the one with the better tets is taken.
    double badness(const Tet& t) const {
        return 1e-3 * std::min(1.0, flatness(point(t[0]), point(t[1]), point(t[2]), point(t[3])));
    }

    std::optional<Change> face_flip(const Target& target, int tet, int face) {
        const int other = complex_.neighbours[tet][face];
        if (other < 0) return {};
        const Tet& t = complex_.tets[tet];
        const auto& corner = opposite_face[face];
        const int p = t[corner[0]], q = t[corner[1]], r = t[corner[2]];
        if (is_protected(p, q, r)) return {};
        const int back = face_towards(complex_.neighbours[other], tet), d = complex_.tets[other][back];
        Change change;
        change.removed = {tet, other};
        for (const int k : corner) {
            Tet added = t;
            added[k] = d;
            if (!is_positive(added)) return {};
            change.added.push_back(added);
        }
        change.cost = -1.0 * face_crosses(target, p, q, r);
        const int a = t[face];
        for (const Side s : {Side{p, q}, Side{q, r}, Side{r, p}}) change.cost += face_crosses(target, a, d, s[0]);
        return change;
    }

    /// False where there are too few or too many tets.
    bool find_ring(int tet, const Side& edge, Ring& ring) const {
        ring = {edge[0], edge[1], false, {}, {}};
        RingWalk back = walk_round(tet, {edge[1], edge[0]});  // to the hull, or once round
        while (!ring.is_open) {
            ring.is_open = !back.step();
            if (back.tet() == tet) break;
        }
        const int first = back.tet();
        RingWalk walk = walk_round(first, edge);
        bool is_left = true;
        do {
            ring.vertices.push_back(walk.vertex());
            ring.tets.push_back(walk.tet());
            is_left = walk.step();
        } while (is_left && walk.tet() != first);
        if (ring.is_open) ring.vertices.push_back(walk.next_vertex());
        return ring.size() >= 3 && ring.size() <= Ring::most;
    }
    RingWalk walk_round(int tet, const Side& edge) const {
        const Tet& corners = complex_.tets[tet];
        return {complex_, tet, corner_of(corners, edge[0]), corner_of(corners, edge[1])};
    }

    /// Whether the hull bends so little at the edge that what is cut off or added there has no volume to speak of.
    bool is_flat_hull(const Ring& ring) const {
        const Vec3 &p = point(ring.from), &q = point(ring.to), &u = point(ring.vertices.front()),
                   &v = point(ring.vertices.back());
        const double longest = std::max({length(q - p), length(u - p), length(v - p), length(u - v)});
        constexpr double flat_share = 1e-8;
        return std::abs(signed_volume(p, q, u, v)) < flat_share * longest * longest * longest;
    }

    /// The triangulation of an edge's ring that crosses least, if by less than `limit` more than now. `ear`, if any, is
    /// a vertex of the ring that only one triangle may have.
    std::optional<Change> edge_removal(const Target& target, int tet, const Side& edge, double limit,
                                       int ear = -1) const {
        const auto [p, q] = edge;
        Ring ring;
        if (is_protected(edge) || !find_ring(tet, edge, ring)) return {};
        if (ring.is_open && (ear >= 0 || !is_flat_hull(ring))) return {};
        int before = edge_crosses(target, p, q);
        for (const int v : ring.vertices) before += face_crosses(target, p, q, v);
        const int n = ring.size();
        const auto found = std::find(ring.vertices.begin(), ring.vertices.end(), ear);
        const int ear_at = found == ring.vertices.end() ? -1 : static_cast<int>(found - ring.vertices.begin());
        const auto cost = [&](int i, int k, int j) {
            if (ear_at >= 0 && (i == ear_at || k == ear_at || j == ear_at))
                for (const int x : {i, k, j})
                    if (x != ear_at && x != (ear_at + n - 1) % n && x != (ear_at + 1) % n)
                        return std::numeric_limits<double>::infinity();
            const int u = ring.vertices[i], v = ring.vertices[k], w = ring.vertices[j];
            const Tet upper{u, v, w, q}, lower{v, u, w, p};
            if (!is_positive(upper) || !is_positive(lower)) return std::numeric_limits<double>::infinity();
            double crossed = face_crosses(target, u, v, w) + badness(upper) + badness(lower);
            if (j - i < n - 1 || ring.is_open)
                crossed += edge_crosses(target, u, w) + face_crosses(target, p, u, w) + face_crosses(target, q, u, w);
            return crossed;
        };
        const auto best = triangulate_ring<SumOf, Ring::most>(n, before + limit, cost);
        if (!(best.cost < before + limit)) return {};
        Change change;
        change.cost = best.cost - before;
        change.removed = ring.tets;
        visit_triangles(best, 0, n - 1, [&](int i, int j, int k) {
            const int u = ring.vertices[i], v = ring.vertices[j], w = ring.vertices[k];
            change.added.push_back({u, v, w, q});
            change.added.push_back({v, u, w, p});
        });
        return change;
    }

    const Cavity& cavity_;
    const RunContext& context_;
    TetComplex complex_;
    CavityEditor editor_;
    std::vector<Corners> facets_;
    std::vector<Side> sides_;
    std::vector<int> open_facets_;
};

FlippedTriangulation recover_all(const Cavity& cavity, const CavityFill& fill, const RunContext& context) {
    constexpr int most_attempts = 6;
    constexpr std::size_t most_hard = 20;  // of more than so many some never come
    FlippedTriangulation result{{}, fill.places.missing};
    std::vector<Side> hard;
    for (int i = 0; i < most_attempts && hard.size() <= most_hard && !result.tets; ++i) {
        FlipRecovery recovery(cavity, fill, context);
        result.tets = recovery.run(hard);
        if (recovery.left().size() < result.left.size()) result.left = recovery.left();
    }
    return result;
}

}  // namespace

FlippedTriangulation recover_by_flips(const Cavity& cavity, const CavityFill& fill, RunContext& context) {
    FlippedTriangulation flipped = recover_all(cavity, fill, context);
    if (flipped.tets) return flipped;
    std::optional<std::vector<Vec3>> points = levelled_points(cavity, fill.points);
    if (!points) return flipped;
    CavityFill levelled;
    levelled.points = std::move(*points);
    levelled.triangulation = delaunay(levelled.points, context);
    levelled.places = find_facets(levelled.triangulation, levelled.points.size(), cavity.facets, context);
    FlippedTriangulation second = recover_all(cavity, levelled, context);
    if (second.tets) {
        const CavityFill as_given = label_cavity(cavity, fill.points, *second.tets, context);
        if (as_given.is_complete() && !has_inverted_tet(as_given)) return second;
    } else if (second.left.size() < flipped.left.size()) {
        flipped.left = std::move(second.left);
    }
    return flipped;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/flip_facets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/geometry.h"
#include "core/ids.h"
#include "core/sort_once.h"
#include "core/sorted_pair.h"
#include "volume/delaunay/triangulation.h"

namespace featuremesh {

namespace {

using Edge = std::array<int, 2>;

/// Two missing facets (a, b, c) and (a, c, d); turned (a, b, d) and (b, c, d).
struct Quad {
    int first, second;  ///< the facets
    int a, b, c, d;
};

class FlipSearch {
  public:
    FlipSearch(const Cavity& cavity, const CavityFill& fill, const Mesh& mesh)
        : cavity_(cavity), fill_(fill), mesh_(mesh) {}

    FacetSplit missing() const {
        const std::vector<Quad> quads = quads_among(fill_.places.missing);
        std::vector<Facet> wanted;
        for (const Quad& q : quads) wanted.push_back({{q.a, q.b, q.d}, {}}), wanted.push_back({{q.b, q.c, q.d}, {}});
        const FacetPlaces places = find_facets(fill_.triangulation, fill_.points.size(), wanted);
        const std::set<int> absent(places.missing.begin(), places.missing.end());
        std::vector<Quad> there;
        for (std::size_t i = 0; i < quads.size(); ++i)
            if (!absent.contains(static_cast<int>(2 * i)) && !absent.contains(static_cast<int>(2 * i + 1)))
                there.push_back(quads[i]);
        return split_of(there);
    }

    FacetSplit flat(double least_volume) const {
        std::vector<int> facets;
        std::set<std::array<int, 2>> pairs;
        for (std::size_t t = 0; t < fill_.regions.size(); ++t) {
            if (fill_.regions[t] < 0 || !is_flat(fill_.triangulation.tets[t], least_volume)) continue;
            std::vector<int> own;
            for (int k = 0; k < 4; ++k)
                if (const int f = fill_.places.facet_at[4 * t + k]; f >= 0) own.push_back(f);
            if (own.size() != 2 || !has_one_region(own[0]) || !has_one_region(own[1])) continue;
            pairs.insert(sorted_pair(own[0], own[1]));
            facets.insert(facets.end(), own.begin(), own.end());
        }
        sort_once(facets);
        std::vector<Quad> quads = quads_among(facets);
        std::erase_if(quads, [&](const Quad& q) { return !pairs.contains(sorted_pair(q.first, q.second)); });
        return split_of(quads);
    }

  private:
    bool has_one_region(int facet) const {
        return std::min(cavity_.facets[facet].regions[0], cavity_.facets[facet].regions[1]) < 0;
    }
    bool is_flat(const std::array<int, 4>& t, double least_volume) const {
        const Vec3 &a = fill_.points[t[0]], &b = fill_.points[t[1]], &c = fill_.points[t[2]], &d = fill_.points[t[3]];
        const double squared = std::max({squared_length(b - a), squared_length(c - a), squared_length(d - a)});
        return signed_volume(a, b, c, d) < std::max(least_volume, 1e-7 * squared * std::sqrt(squared));
    }

    /// Changes of diagonal, none of which touches a facet of another.
    FacetSplit split_of(const std::vector<Quad>& quads) const {
        FacetSplit split;
        std::set<int> used;
        for (const Quad& q : quads) {
            if (used.contains(q.first) || used.contains(q.second)) continue;
            used.insert({q.first, q.second});
            split.pieces.push_back(piece(q.a, q.b, q.d, q.first));
            split.pieces.push_back(piece(q.b, q.c, q.d, q.second));
        }
        std::sort(split.pieces.begin(), split.pieces.end(),
                  [](const auto& x, const auto& y) { return x.facet < y.facet; });
        return split;
    }

    std::vector<Quad> quads_among(const std::vector<int>& facets) const {
        std::map<Edge, std::vector<int>> by_edge;
        for (const int f : facets)
            for (int k = 0; k < 3; ++k)
                by_edge[sorted_pair(cavity_.facets[f].corners[k], cavity_.facets[f].corners[(k + 1) % 3])].push_back(f);
        std::vector<Quad> quads;
        if (facets.empty()) return quads;
        const std::set<Edge> taken = edges_near(by_edge), segments = segments_near(by_edge);
        for (const auto& [edge, pair] : by_edge) {
            if (pair.size() != 2 || segments.contains(edge) || !are_alike(pair[0], pair[1])) continue;
            const Quad q = quad_of(pair[0], pair[1], edge);
            if (q.a >= 0 && !taken.contains(sorted_pair(q.b, q.d)) && is_smooth(q)) quads.push_back(q);
        }
        return quads;
    }

    /// Edges of the surface between corners of missing facets.
    std::set<Edge> edges_near(const std::map<Edge, std::vector<int>>& missing) const {
        const std::set<int> corners = corners_of(missing);
        std::set<Edge> edges;
        for (const Facet& f : cavity_.facets)
            for (int k = 0; k < 3; ++k)
                if (corners.contains(f.corners[k]) && corners.contains(f.corners[(k + 1) % 3]))
                    edges.insert(sorted_pair(f.corners[k], f.corners[(k + 1) % 3]));
        return edges;
    }
    /// Pieces of CAD edges between corners of missing facets.
    std::set<Edge> segments_near(const std::map<Edge, std::vector<int>>& missing) const {
        std::map<NodeId, int> corner_of;
        for (const int c : corners_of(missing)) corner_of[cavity_.nodes[c]] = c;
        std::set<Edge> edges;
        for (const auto& segment : mesh_.segments) {
            const auto first = corner_of.find(segment[0]), last = corner_of.find(segment[1]);
            if (first != corner_of.end() && last != corner_of.end())
                edges.insert(sorted_pair(first->second, last->second));
        }
        return edges;
    }
    static std::set<int> corners_of(const std::map<Edge, std::vector<int>>& missing) {
        std::set<int> corners;
        for (const auto& [edge, facets] : missing) corners.insert(edge.begin(), edge.end());
        return corners;
    }

    bool are_alike(int f, int g) const {
        const TriangleId s = cavity_.triangle_of_facet[f], t = cavity_.triangle_of_facet[g];
        return s.is_valid() && t.is_valid() && mesh_.triangle_faces[s.index()] == mesh_.triangle_faces[t.index()];
    }

    /// Corners in the order in which the normal leaves the region of lower number, so that neighbours turn alike.
    Facet turned(int facet) const {
        Facet f = cavity_.facets[facet];
        if (!is_turned(facet)) return f;
        std::swap(f.corners[1], f.corners[2]);
        std::swap(f.regions[0], f.regions[1]);
        return f;
    }
    bool is_turned(int facet) const {
        const auto& r = cavity_.facets[facet].regions;
        return r[0] < 0 || (r[1] >= 0 && r[1] < r[0]);
    }
    FacetSplit::Piece piece(int a, int b, int c, int facet) const {
        return is_turned(facet) ? FacetSplit::Piece{{a, c, b}, facet} : FacetSplit::Piece{{a, b, c}, facet};
    }

    /// Corners so that the first facet turns as (a, b, c); a is -1 when the two do not make a quad of one region.
    Quad quad_of(int f, int g, const Edge& edge) const {
        const Facet one = turned(f), other = turned(g);
        auto first = one.corners, second = other.corners;
        while (first[1] == edge[0] || first[1] == edge[1]) std::rotate(first.begin(), first.begin() + 1, first.end());
        while (second[2] == edge[0] || second[2] == edge[1])
            std::rotate(second.begin(), second.begin() + 1, second.end());
        Quad q{f, g, first[0], first[1], first[2], second[2]};
        if (second[0] != q.a || second[1] != q.c || one.regions != other.regions) q.a = -1;
        return q;
    }

    Vec3 normal(int a, int b, int c) const {
        return normalized(cross(cavity_.points[b] - cavity_.points[a], cavity_.points[c] - cavity_.points[a]));
    }

    /// The surface must not fold, and hardly bend more than before.
    bool is_smooth(const Quad& q) const {
        const Vec3 old_normals[] = {normal(q.a, q.b, q.c), normal(q.a, q.c, q.d)};
        const Vec3 new_normals[] = {normal(q.a, q.b, q.d), normal(q.b, q.c, q.d)};
        for (const Vec3& m : old_normals)
            for (const Vec3& n : new_normals)
                if (dot(m, n) < 0.9) return false;
        return true;
    }

    const Cavity& cavity_;
    const CavityFill& fill_;
    const Mesh& mesh_;
};

}  // namespace

FacetSplit flip_missing(const Cavity& cavity, const CavityFill& fill, const Mesh& mesh) {
    return FlipSearch(cavity, fill, mesh).missing();
}

FacetSplit flip_flat(const Cavity& cavity, const CavityFill& fill, const Mesh& mesh, double least_volume) {
    return FlipSearch(cavity, fill, mesh).flat(least_volume);
}

}  // namespace featuremesh

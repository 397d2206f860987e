// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/edge_difference.h"

#include <algorithm>
#include <cmath>

#include "core/geometry.h"
#include "core/ids.h"
#include "difference/underlying_geometry.h"

namespace featuremesh {

namespace {

/// A stretch of a curve that an edge of one state covers.
struct Cover {
    double first, last;
    bool is_new;
};

/// Of the edges that are meshed for themselves: others differ as their faces do.
std::vector<std::vector<Cover>> covers_of_curves(const BoundaryPair& pair, const BoundaryMatch& match) {
    std::vector<std::vector<Cover>> covers(match.curves.size());
    const auto add = [&](const Stretch& s, bool is_new) {
        if (s.curve < 0) return;
        const UnderlyingCurve& curve = match.curves[std::size_t(s.curve)];
        for (const Stretch& part : within_period(s, curve, pair.sameness.length))
            covers[std::size_t(s.curve)].push_back({part.first, part.last, is_new});
    };
    const Brep &was = pair.old_model.brep(), &is = pair.new_model.brep();
    for (std::size_t e = 0; e < match.old_edges.size(); ++e)
        if (was.is_free(EdgeId(e))) add(match.old_edges[e], false);
    for (std::size_t e = 0; e < match.new_edges.size(); ++e)
        if (is.is_free(EdgeId(e))) add(match.new_edges[e], true);
    return covers;
}

class EdgeDifference {
  public:
    EdgeDifference(const BoundaryPair& pair, const BoundaryMatch& match, const Resolution& resolution,
                   std::vector<SpaceTriangle>& triangles)
        : pair_(pair), match_(match), resolution_(resolution), triangles_(triangles) {}

    void run() {
        const auto covers = covers_of_curves(pair_, match_);
        for (std::size_t c = 0; c < covers.size(); ++c) add_changed_pieces(match_.curves[c], covers[c]);
        add_changed_vertices();
    }

  private:
    void add_changed_pieces(const UnderlyingCurve& curve, const std::vector<Cover>& covers) {
        std::vector<double> cuts;
        for (const Cover& c : covers) cuts.push_back(c.first), cuts.push_back(c.last);
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if (cuts[i + 1] - cuts[i] <= parameter_tolerance(curve, pair_.sameness.length)) continue;
            const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
            bool was = false, is = false;
            for (const Cover& c : covers)
                if (c.first <= middle && middle <= c.last) (c.is_new ? is : was) = true;
            if (was != is) add_piece(curve, cuts[i], cuts[i + 1]);
        }
    }

    void add_piece(const UnderlyingCurve& curve, double first, double last) {
        constexpr int samples = 32;
        constexpr double most_pieces = 1e5;
        double length = 0;
        const auto at = [&](double share) { return point_at(curve, first + share * (last - first)); };
        for (int i = 0; i < samples; ++i) length += distance(at(double(i) / samples), at(double(i + 1) / samples));
        const double pieces = std::clamp(std::ceil(2 * length / resolution_.finest), 8.0, most_pieces);
        for (int i = 0; i < int(pieces); ++i) {
            const Vec3 p = at(i / pieces), q = at((i + 1) / pieces);
            triangles_.push_back({p, q, q});
        }
    }

    void add_changed_vertices() {
        const Brep &was = pair_.old_model.brep(), &is = pair_.new_model.brep();
        std::vector<char> has_partner(is.vertex_count(), 0);
        for (std::size_t v = 0; v < was.vertex_count(); ++v) {
            const VertexId partner = match_.new_vertex_of[v];
            if (partner.is_valid())
                has_partner[partner.index()] = 1;
            else if (has_free_edge(was, VertexId(v)))
                add_point(pair_.motion.apply(was.point_of(VertexId(v))));
        }
        for (std::size_t v = 0; v < has_partner.size(); ++v)
            if (!has_partner[v] && has_free_edge(is, VertexId(v))) add_point(is.point_of(VertexId(v)));
    }
    static bool has_free_edge(const Brep& brep, VertexId vertex) {
        const auto edges = brep.edges_of(vertex);
        return std::any_of(edges.begin(), edges.end(), [&](EdgeId e) { return brep.is_free(e); });
    }
    void add_point(const Vec3& p) { triangles_.push_back({p, p, p}); }

    const BoundaryPair& pair_;
    const BoundaryMatch& match_;
    const Resolution& resolution_;
    std::vector<SpaceTriangle>& triangles_;
};

}  // namespace

void append_edge_difference(const BoundaryPair& pair, const BoundaryMatch& match, const Resolution& resolution,
                            std::vector<SpaceTriangle>& triangles) {
    EdgeDifference(pair, match, resolution, triangles).run();
}

}  // namespace featuremesh

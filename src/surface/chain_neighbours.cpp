// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/chain_neighbours.h"

#include <BRepAdaptor_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>

#include "brep/common_body.h"

namespace featuremesh {

namespace {

/// Of a piece's chord: no point of the edge is further from it. A quarter turn has 0.21.
constexpr double sagitta_share = 0.3;

double distance_to_piece(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double share = dot(p - a, along) / std::max(squared_length(along), 1e-300);
    return distance(p, a + std::clamp(share, 0.0, 1.0) * along);
}

}  // namespace

ChainNeighbours::ChainNeighbours(const Brep& brep, const Projector& projector, std::vector<std::vector<Place>> chains)
    : brep_(brep), projector_(projector), chains_(std::move(chains)), extents_(chains_.size()) {
    for (std::size_t e = 0; e < chains_.size(); ++e) {
        if (chains_[e].empty()) continue;
        Extent& extent = extents_[e];
        extent.is_straight = BRepAdaptor_Curve(brep.edge(EdgeId(e))).GetType() == GeomAbs_Line;
        for (std::size_t i = 1; i < chains_[e].size() && !extent.is_straight; ++i)
            extent.sagitta =
                std::max(extent.sagitta, sagitta_share * distance(chains_[e][i - 1].point, chains_[e][i].point));
        for (const Place& at : chains_[e]) extent.box.add(at.point);
        extent.box = extent.box.grown(extent.sagitta);
        widest_ = std::max(widest_, extent.box.size().x);
        by_low_.emplace_back(extent.box.low.x, e);
    }
    std::sort(by_low_.begin(), by_low_.end());
}

bool ChainNeighbours::is_on_another(EdgeId edge, const Vec3& p, double reach) const {
    auto it = std::lower_bound(by_low_.begin(), by_low_.end(), std::pair(p.x - widest_ - reach, std::size_t{0}));
    for (; it != by_low_.end() && it->first <= p.x + reach; ++it) {
        const std::size_t other = it->second;
        if (!extents_[other].box.grown(reach).contains(p) || !may_touch(edge, EdgeId(other)) ||
            !is_near_chain(other, p, reach))
            continue;
        if (projector_.nearest(EdgeId(other), p).distance <= reach) return true;
    }
    return false;
}

bool ChainNeighbours::may_touch(EdgeId a, EdgeId b) const {
    if (a == b || (extents_[a.index()].is_straight && extents_[b.index()].is_straight)) return false;
    for (const VertexId v : brep_.ends_of(a))
        for (const VertexId w : brep_.ends_of(b))
            if (v == w) return false;
    for (const FaceId f : brep_.faces_of(a))
        for (const FaceId g : brep_.faces_of(b))
            if (have_common_body(brep_, f, g)) return true;
    return false;
}

bool ChainNeighbours::is_near_chain(std::size_t edge, const Vec3& p, double reach) const {
    constexpr int halvings = 6;
    const std::vector<Place>& places = chains_[edge];
    const Extent& extent = extents_[edge];
    for (std::size_t i = 1; i < places.size(); ++i)
        if (distance_to_piece(p, places[i - 1].point, places[i].point) <= reach + extent.sagitta &&
            (extent.is_straight || is_near_piece(EdgeId(edge), {places[i - 1], places[i]}, p, reach, halvings)))
            return true;
    return false;
}

bool ChainNeighbours::is_near_piece(EdgeId edge, const std::array<Place, 2>& ends, const Vec3& p, double reach,
                                    int halvings) const {
    if (halvings == 0) return true;
    const auto& [from, to] = ends;
    const double t = 0.5 * (from.t + to.t);
    const Place middle{t, projector_.on_edge(edge, t)};
    const double sagitta =
        sagitta_share * std::max(distance(from.point, middle.point), distance(middle.point, to.point));
    const auto is_near = [&](const Place& a, const Place& b) {
        return distance_to_piece(p, a.point, b.point) <= reach + sagitta &&
               is_near_piece(edge, {a, b}, p, reach, halvings - 1);
    };
    return is_near(from, middle) || is_near(middle, to);
}

}  // namespace featuremesh

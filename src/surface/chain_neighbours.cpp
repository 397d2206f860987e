// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/chain_neighbours.h"

#include <BRepAdaptor_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>

namespace featuremesh {

namespace {

double distance_to_piece(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double share = dot(p - a, along) / std::max(squared_length(along), 1e-300);
    return distance(p, a + std::clamp(share, 0.0, 1.0) * along);
}

}  // namespace

ChainNeighbours::ChainNeighbours(const Brep& brep, const Projector& projector, std::vector<std::vector<Vec3>> chains)
    : brep_(brep), projector_(projector), chains_(std::move(chains)), extents_(chains_.size()) {
    for (std::size_t e = 0; e < chains_.size(); ++e) {
        if (chains_[e].empty()) continue;
        Extent& extent = extents_[e];
        extent.is_straight = BRepAdaptor_Curve(brep.edge(EdgeId(e))).GetType() == GeomAbs_Line;
        for (std::size_t i = 1; i < chains_[e].size() && !extent.is_straight; ++i)  // a quarter turn has 0.21
            extent.sagitta = std::max(extent.sagitta, 0.3 * distance(chains_[e][i - 1], chains_[e][i]));
        for (const Vec3& p : chains_[e]) extent.box.add(p);
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
            for (const BodyId s : brep_.bodies_of(f))
                for (const BodyId t : brep_.bodies_of(g))
                    if (s.is_valid() && s == t) return true;
    return false;
}

bool ChainNeighbours::is_near_chain(std::size_t edge, const Vec3& p, double reach) const {
    const std::vector<Vec3>& points = chains_[edge];
    for (std::size_t i = 1; i < points.size(); ++i)
        if (distance_to_piece(p, points[i - 1], points[i]) <= reach + extents_[edge].sagitta) return true;
    return false;
}

}  // namespace featuremesh

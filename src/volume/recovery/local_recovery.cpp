// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/local_recovery.h"

#include <algorithm>
#include <utility>

#include "core/geometry.h"
#include "volume/recovery/facet_split.h"
#include "volume/recovery/neighbourhood.h"

namespace featuremesh {

namespace {

/// By tet: has it a point within reach of the box of a missing facet, in lengths of that facet?
std::vector<std::uint8_t> are_near_missing(const Cavity& cavity, const CavityFill& fill, double reach) {
    std::vector<Box> boxes;
    for (const int f : fill.places.missing) {
        Box box;
        for (const int c : cavity.facets[f].corners) box.add(cavity.points[c]);
        boxes.push_back(box.grown(reach * box.diagonal()));
    }
    std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.low.x < b.low.x; });
    double widest = 0;
    for (const Box& b : boxes) widest = std::max(widest, b.size().x);
    std::vector<std::uint8_t> is_near(fill.points.size(), 0);
    for (std::size_t i = 0; i < fill.points.size(); ++i) {
        const Vec3& p = fill.points[i];
        auto box = std::lower_bound(boxes.begin(), boxes.end(), p.x - widest,
                                    [](const Box& b, double x) { return b.low.x < x; });
        for (; box != boxes.end() && box->low.x <= p.x && !is_near[i]; ++box) is_near[i] = box->contains(p);
    }
    std::vector<std::uint8_t> are_near;
    are_near.reserve(fill.triangulation.tets.size());
    for (const auto& tet : fill.triangulation.tets)
        are_near.push_back(std::any_of(tet.begin(), tet.end(), [&](int c) { return is_near[c]; }));
    return are_near;
}

/// Of the neighbourhood's facets and points, as the whole cavity has them.
FacetSplit split_of_whole(const FacetSplit& local, const Neighbourhood& near, const Cavity& cavity) {
    const int own = static_cast<int>(cavity.points.size()), subs = static_cast<int>(near.cavity().points.size());
    FacetSplit whole;
    for (FacetSplit::Added added : local.added) {
        for (int& c : added.edge)
            if (c >= 0) c = near.point_of(c);
        if (added.facet >= 0) added.facet = near.facet_of(added.facet);
        whole.added.push_back(added);
    }
    for (FacetSplit::Piece piece : local.pieces) {
        for (int& c : piece.corners) c = c < subs ? near.point_of(c) : own + c - subs;
        piece.facet = near.facet_of(piece.facet);
        whole.pieces.push_back(piece);
    }
    std::sort(whole.pieces.begin(), whole.pieces.end(), [](const auto& a, const auto& b) { return a.facet < b.facet; });
    return whole;
}

/// None where what is missing reaches through the border, or would have to cut it.
std::optional<ConstrainedTriangulation> recover_in(const Neighbourhood& near, const Cavity& cavity,
                                                   const CavityFill& fill, const RunContext& context) {
    if (!crossing_facets(near.cavity()).empty()) return {};
    const ConstrainedTriangulation local = constrained_delaunay(near.cavity(), {}, fill.places.missing.size(), context);
    if (local.is_given_up || !local.failed.empty()) return {};
    for (const auto& piece : local.split.pieces)
        if (near.facet_of(piece.facet) < 0 || near.is_border(piece.facet)) return {};
    auto merged = near.merge(local.triangulation, local.split.added.size());
    if (!merged) return {};
    ConstrainedTriangulation whole;
    whole.triangulation = std::move(*merged);
    whole.split = split_of_whole(local.split, near, cavity);
    return whole;
}

}  // namespace

std::optional<ConstrainedTriangulation> recover_locally(const Cavity& cavity, const CavityFill& fill,
                                                        const RunContext& context) {
    for (const double reach : {0.7, 1.5, 4.0}) {
        const Neighbourhood near(cavity, fill, are_near_missing(cavity, fill, reach));
        if (!near.is_small()) return {};
        if (auto recovered = recover_in(near, cavity, fill, context)) return recovered;
    }
    return {};
}

}  // namespace featuremesh

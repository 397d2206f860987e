// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/opposite_nodes.h"

#include <algorithm>

namespace featuremesh {

namespace {
constexpr double reach = 0.25, clearance = 0.3;  // of the wanted length
}  // namespace

std::vector<EdgeId> EdgesBeside::of(EdgeId edge) const {
    std::vector<EdgeId> others;
    for (const auto& [a, b] : pairs_)
        if (a == edge || b == edge) others.push_back(a == edge ? b : a);
    return others;
}

std::vector<double> parameters_opposite(const Projector& projector, const WantedLength& sizing, EdgeId edge,
                                        const std::array<double, 2>& between, std::span<const Vec3> points) {
    std::vector<std::pair<double, Vec3>> opposite;
    for (const Vec3& p : points)
        if (const OnEdge at = projector.nearest(edge, p);
            at.distance < reach * sizing.at(at.point) && at.t > between[0] && at.t < between[1])
            opposite.emplace_back(at.t, at.point);
    std::sort(opposite.begin(), opposite.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    const Vec3 end = projector.on_edge(edge, between[1]);
    Vec3 last = projector.on_edge(edge, between[0]);
    std::vector<double> parameters;
    for (const auto& [t, p] : opposite) {
        const double least = clearance * sizing.at(p);
        if (distance(p, last) < least || distance(p, end) < least) continue;
        parameters.push_back(t);
        last = p;
    }
    return parameters;
}

}  // namespace featuremesh

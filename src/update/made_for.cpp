// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/made_for.h"

#include <algorithm>
#include <cmath>

namespace featuremesh {

namespace {
constexpr double same_size = 1e-9;  // relative
}

std::optional<double> MadeFor::of(NodeId node) const {
    const auto at = std::lower_bound(nodes.begin(), nodes.end(), node);
    if (at == nodes.end() || *at != node) return {};
    return sizes[std::size_t(at - nodes.begin())];
}

MadeFor made_for(const Mesh& mesh, const SizingField& sizing, const SizedMesh& old,
                 const std::vector<std::int32_t>& origin) {
    const std::vector<Box> resized = where_different(old.sizing, sizing);
    MadeFor sizes;
    for (std::size_t n = 0; n < mesh.corner_count; ++n) {
        if (origin[n] < 0) continue;
        const NodeId before(origin[n]);
        const Vec3& p = mesh.points[n];
        const auto holds_p = [&](const Box& box) { return box.contains(p); };
        const bool is_as_it_was = old.made_for.nodes.empty() && p == old.mesh.point(before) &&
                                  std::none_of(resized.begin(), resized.end(), holds_p);
        if (is_as_it_was) continue;
        const double was = old.made_for_at(before), wanted = sizing.at(p);
        if (std::abs(was - wanted) <= same_size * wanted) continue;
        sizes.nodes.emplace_back(n);
        sizes.sizes.push_back(was);
    }
    return sizes;
}

}  // namespace featuremesh

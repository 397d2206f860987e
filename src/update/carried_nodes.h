// SPDX-License-Identifier: GPL-3.0-or-later
// Old nodes under the motions that they stay with.
#pragma once

#include <cstdint>
#include <span>

#include "core/geometry.h"
#include "core/ids.h"
#include "difference/feature_difference.h"
#include "update/keep.h"

namespace featuremesh {

/// A view of what is decided about the old nodes so far.
struct CarriedNodes {
    const KeepInput& input;
    std::span<const std::int32_t> motions;  ///< by old node: index of its carried region, or `dropped`

    std::span<const CarriedRegion> regions() const { return input.difference.regions; }
    std::size_t motion_of(NodeId n) const { return static_cast<std::size_t>(motions[n.index()]); }
    /// Where a node that is not dropped is in the new state; the first motion is the identity.
    Vec3 at(std::size_t node) const {
        const Vec3& p = input.old_mesh.points[node];
        return motions[node] == 0 ? p : regions()[static_cast<std::size_t>(motions[node])].motion.apply(p);
    }
    Vec3 at(NodeId n) const { return at(n.index()); }
};

}  // namespace featuremesh

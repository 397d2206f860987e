// SPDX-License-Identifier: GPL-3.0-or-later
// A place where a size is wanted.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/geometry.h"

namespace featuremesh {

/// A ball in which a size is wanted; outside it the size grows with the distance.
struct SourceBall {
    Vec3 center;
    double radius = 0;
    double size = 0;
    bool operator==(const SourceBall&) const = default;

    /// The smaller of `best` and what this ball asks for at p; without a root where that is clearly more.
    double lower(double best, const Vec3& p, double slope, double inverse_slope) const {
        if (size >= best) return best;
        const double reach = (best - size) * inverse_slope + radius, squared = squared_length(p - center);
        if (squared > reach * reach * (1 + 1e-9)) return best;
        return std::min(best, size + slope * std::max(0.0, std::sqrt(squared) - radius));
    }
};

}  // namespace featuremesh

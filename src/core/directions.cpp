// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/directions.h"

#include <cmath>

namespace featuremesh {

const std::vector<Vec3>& directions_in_space() {
    constexpr int direction_count = 24;
    static const auto fibonacci_lattice = [] {
        std::vector<Vec3> made;
        const double golden = 2.39996322972865332;
        for (int i = 0; i < direction_count; ++i) {
            const double z = 1 - (2 * i + 1.0) / direction_count, r = std::sqrt(1 - z * z);
            made.push_back({r * std::cos(golden * i), r * std::sin(golden * i), z});
        }
        return made;
    }();
    return fibonacci_lattice;
}

}  // namespace featuremesh

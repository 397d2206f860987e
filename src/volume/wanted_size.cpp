// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/wanted_size.h"

#include <cmath>
#include <numbers>

namespace featuremesh {

WantedSize wanted_size(const SizingField& sizing, const Mesh& surface) {
    WantedSize size{[&sizing](const Vec3& p) { return sizing.at(p); }, sizing.largest(), sizing.is_uniform()};
    size.slope = sizing.growth() - 1;
    if (size.is_uniform || surface.triangles.empty()) return size;
    // the mean of directions: a turn for a factor of two
    constexpr std::size_t most_asked = 2000;
    constexpr double turn = 2 * std::numbers::pi;
    const std::size_t step = (surface.triangles.size() + most_asked - 1) / most_asked;
    double x = 0, y = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); t += step) {
        const auto& n = surface.triangles[t];
        const Vec3 middle = (surface.point(n[0]) + surface.point(n[1]) + surface.point(n[2])) * (1.0 / 3);
        const double angle = turn * std::log2(size.at(middle) / size.largest);
        x += std::cos(angle), y += std::sin(angle);
    }
    size.root = size.largest * std::exp2(std::atan2(y, x) / turn);
    return size;
}

}  // namespace featuremesh

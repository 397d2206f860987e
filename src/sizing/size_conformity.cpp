// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/size_conformity.h"

#include <algorithm>

#include "core/geometry.h"

namespace featuremesh {
namespace {

constexpr std::size_t most_elements = 900;
constexpr std::size_t sides[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};  // those with all its nodes

template <class Elements>
SizeConformity conformity_of(const Mesh& mesh, const SizingField& sizing, const Elements& elements) {
    SizeConformity conformity;
    if (elements.empty()) return conformity;
    const std::size_t stride = (elements.size() + most_elements - 1) / most_elements;
    double sum = 0;
    std::int64_t within = 0, count = 0;
    for (std::size_t t = 0; t < elements.size(); t += stride)
        for (const auto& [i, j] : sides) {
            if (std::max(i, j) >= elements[t].size()) continue;
            const Vec3 &a = mesh.point(elements[t][i]), &b = mesh.point(elements[t][j]);
            const double ratio = distance(a, b) / sizing.at((a + b) * 0.5);
            ++conformity.histogram[static_cast<std::size_t>(std::clamp(ratio * 10, 0.0, 19.0))];
            within += ratio >= 0.7 && ratio <= 1.4;
            sum += ratio;
            ++count;
        }
    conformity.share_within = static_cast<double>(within) / static_cast<double>(count);
    conformity.mean = sum / static_cast<double>(count);
    return conformity;
}

}  // namespace

SizeConformity measure_size_conformity(const Mesh& mesh, const SizingField& sizing) {
    if (!mesh.tets.empty()) return conformity_of(mesh, sizing, mesh.tets);
    if (!mesh.triangles.empty()) return conformity_of(mesh, sizing, mesh.triangles);
    return conformity_of(mesh, sizing, mesh.segments);
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/elements.h"

#include <cmath>

#include "mesh/second_order.h"

namespace featuremesh {

namespace {

using Barycentric = std::array<double, 4>;

const double near_weight = (5 + 3 * std::sqrt(5.0)) / 20, far_weight = (5 - std::sqrt(5.0)) / 20;

Barycentric place_of(int node_count, int point) {
    if (node_count == 4) return {0.25, 0.25, 0.25, 0.25};
    Barycentric place{far_weight, far_weight, far_weight, far_weight};
    place[std::size_t(point)] = near_weight;
    return place;
}

/// Derivatives along barycentric coordinates 1, 2 and 3; coordinate 0 is what is left of 1.
std::array<Vec3, 10> local_gradients(const Barycentric& at) {
    static constexpr std::array<Vec3, 4> of_coordinate{Vec3{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::array<Vec3, 10> gradients;
    for (std::size_t i = 0; i < 4; ++i) gradients[i] = of_coordinate[i] * (4 * at[i] - 1);
    for (std::size_t s = 0; s < 6; ++s) {
        const auto i = std::size_t(tet_sides[s][0]), j = std::size_t(tet_sides[s][1]);
        gradients[4 + s] = 4 * at[j] * of_coordinate[i] + 4 * at[i] * of_coordinate[j];
    }
    return gradients;
}

const std::array<std::array<Vec3, 10>, 4>& all_local_gradients() {
    static const std::array<std::array<Vec3, 10>, 4> gradients{
        local_gradients(place_of(10, 0)), local_gradients(place_of(10, 1)), local_gradients(place_of(10, 2)),
        local_gradients(place_of(10, 3))};
    return gradients;
}

}  // namespace

Element<4, 1> linear_element(const Mesh& mesh, std::size_t tet) {
    Element<4, 1> element{mesh.tets[tet], {}};
    const Vec3& origin = mesh.point(element.nodes[0]);
    const Vec3 a = mesh.point(element.nodes[1]) - origin, b = mesh.point(element.nodes[2]) - origin;
    const Vec3 c = mesh.point(element.nodes[3]) - origin;
    const double determinant = dot(a, cross(b, c)), scale = 1 / determinant;
    auto& [volume, gradients] = element.points[0];
    volume = determinant / 6;
    gradients[1] = cross(b, c) * scale, gradients[2] = cross(c, a) * scale, gradients[3] = cross(a, b) * scale;
    gradients[0] = -(gradients[1] + gradients[2] + gradients[3]);
    return element;
}

Element<10, 4> quadratic_element(const Mesh& mesh, std::size_t tet) {
    Element<10, 4> element;
    for (std::size_t i = 0; i < 4; ++i) element.nodes[i] = mesh.tets[tet][i];
    for (std::size_t i = 0; i < 6; ++i) element.nodes[4 + i] = mesh.tet_mids[tet][i];
    const auto& local_of_points = all_local_gradients();
    for (std::size_t p = 0; p < 4; ++p) {
        const auto& local = local_of_points[p];
        Vec3 a, b, c;  // columns of the Jacobian
        for (std::size_t i = 0; i < 10; ++i) {
            const Vec3& x = mesh.point(element.nodes[i]);
            a += x * local[i].x, b += x * local[i].y, c += x * local[i].z;
        }
        const double determinant = dot(a, cross(b, c)), scale = 1 / determinant;
        const Vec3 ra = cross(b, c) * scale, rb = cross(c, a) * scale, rc = cross(a, b) * scale;
        auto& [volume, gradients] = element.points[p];
        volume = determinant / 24;
        for (std::size_t i = 0; i < 10; ++i) gradients[i] = ra * local[i].x + rb * local[i].y + rc * local[i].z;
    }
    return element;
}

std::array<double, 10> shape_values(int node_count, int point) {
    const Barycentric at = place_of(node_count, point);
    std::array<double, 10> values{};
    for (std::size_t i = 0; i < 4; ++i) values[i] = node_count == 4 ? at[i] : at[i] * (2 * at[i] - 1);
    if (node_count == 10)
        for (std::size_t s = 0; s < 6; ++s)
            values[4 + s] = 4 * at[std::size_t(tet_sides[s][0])] * at[std::size_t(tet_sides[s][1])];
    return values;
}

CornerWeights corner_weights() {
    const double spread = near_weight - far_weight;
    return {1 / spread - far_weight / spread, -far_weight / spread};
}

CornerWeights inner_weights() { return {near_weight, far_weight}; }

}  // namespace featuremesh

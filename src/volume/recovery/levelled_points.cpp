// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/levelled_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>

namespace featuremesh {

namespace {

/// Twice the area of the facets that face one way or the other, as a vector.
std::vector<Vec3> summed_normals(const Cavity& cavity) {
    constexpr double steps = 1e6, off_round_numbers = 0.137;
    std::map<std::array<std::int64_t, 3>, Vec3> sums;
    for (const Facet& f : cavity.facets) {
        const Vec3& a = cavity.points[f.corners[0]];
        Vec3 normal = cross(cavity.points[f.corners[1]] - a, cavity.points[f.corners[2]] - a);
        const double area = length(normal);
        if (!(area > 0)) continue;
        const double largest = std::max({normal.x, normal.y, normal.z}),
                     least = std::min({normal.x, normal.y, normal.z});
        if (-least > largest) normal = -1.0 * normal;
        const auto step = [&](double x) { return std::llround(x / area * steps + off_round_numbers); };
        Vec3& sum = sums[{step(normal.x), step(normal.y), step(normal.z)}];
        sum = sum + normal;
    }
    std::vector<Vec3> normals;
    for (const auto& [key, sum] : sums) normals.push_back(sum);
    return normals;
}

/// Three axes, each across the others.
std::array<Vec3, 3> frame_of(const Cavity& cavity) {
    constexpr double most_across = 1e-6;  // cosine
    const std::vector<Vec3> normals = summed_normals(cavity);
    const auto is_smaller = [](const Vec3& a, const Vec3& b) { return squared_length(a) < squared_length(b); };
    const Vec3 first = normalized(*std::max_element(normals.begin(), normals.end(), is_smaller));
    Vec3 second{};
    for (const Vec3& n : normals)
        if (std::abs(dot(n, first)) < most_across * length(n) && is_smaller(second, n)) second = n;
    if (!(squared_length(second) > 0)) second = std::abs(first.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    second = normalized(second - dot(second, first) * first);
    return {first, second, cross(first, second)};
}

/// Makes values equal that differ by no more than `tolerance` from the next.
void level(std::vector<double>& values, double tolerance) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    double last = 0, shared = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        double& value = values[order[i]];
        if (i == 0 || value - last > tolerance) shared = value;
        last = value;
        value = shared;
    }
}

bool are_distinct(std::vector<Vec3> points) {
    const auto place = [](const Vec3& p) { return std::tuple(p.x, p.y, p.z); };
    std::sort(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) { return place(a) < place(b); });
    return std::adjacent_find(points.begin(), points.end()) == points.end();
}

}  // namespace

std::optional<std::vector<Vec3>> levelled_points(const Cavity& cavity, const std::vector<Vec3>& points) {
    constexpr double tolerance_of_extent = 1e-9;
    const std::array<Vec3, 3> axes = frame_of(cavity);
    const Vec3 origin = points.front();
    std::array<std::vector<double>, 3> along;
    for (int k = 0; k < 3; ++k)
        for (const Vec3& p : points) along[k].push_back(dot(axes[k], p - origin));
    double extent = 0;
    for (const auto& values : along) {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        extent = std::max(extent, *most - *least);
    }
    for (auto& values : along) level(values, tolerance_of_extent * extent);
    std::vector<Vec3> result;
    for (std::size_t i = 0; i < points.size(); ++i) result.push_back({along[0][i], along[1][i], along[2][i]});
    if (!are_distinct(result)) return {};
    return result;
}

}  // namespace featuremesh

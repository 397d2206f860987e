// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes to solve, of either order.
#pragma once

#include <functional>

#include "box_mesh.h"
#include "core/errors.h"
#include "statics/model.h"

namespace featuremesh {

inline const Material steel{210000, 0.3, 7.85e-9};

/// The unit box stretched to x, y, z, its inner nodes moved so that no two tets are alike.
inline Mesh solved_box(int n, int order, const Vec3& size = {1, 1, 1}) {
    Mesh mesh = box_mesh(n);
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        Vec3& p = mesh.points[i];
        if (mesh.entities[i].dim == 3)
            p += Vec3{std::sin(7.0 * double(i)), std::sin(11.0 * double(i)), std::sin(13.0 * double(i))} * (0.12 / n);
        p = {p.x * size.x, p.y * size.y, p.z * size.z};
    }
    if (order == 2) {
        mesh.order = 2;
        add_mid_side_nodes(mesh);
    }
    return mesh;
}

inline StaticsModel free_model(const Mesh& mesh, const Material& material = steel) {
    const std::size_t n = 3 * mesh.node_count();
    return {mesh,
            {material},
            std::vector<std::int32_t>(mesh.tets.size(), 0),
            std::vector<double>(n, 0.0),
            std::vector<char>(n, 0),
            std::vector<double>(n, 0.0)};
}

/// Gives all three components of the displacement of every node where `where` says so.
inline void hold(
    StaticsModel& model, const std::function<bool(const Vec3&)>& where,
    const std::function<Vec3(const Vec3&)>& displacement = [](const Vec3&) { return Vec3{}; }) {
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
        if (!where(model.mesh.points[i])) continue;
        const Vec3 u = displacement(model.mesh.points[i]);
        for (int c = 0; c < 3; ++c) {
            model.is_held[3 * i + std::size_t(c)] = 1;
            model.given[3 * i + std::size_t(c)] = u[c];
        }
    }
}

inline std::vector<std::int32_t> triangles_of(const Mesh& mesh, int face) {
    std::vector<std::int32_t> found;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (mesh.triangle_faces[t].value == face) found.push_back(std::int32_t(t));
    return found;
}

inline double largest(const std::vector<double>& values) {
    double most = 0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
}

inline Vec3 sum_of(const std::vector<double>& vectors) {
    Vec3 sum;
    for (std::size_t i = 0; i < vectors.size(); i += 3) sum += {vectors[i], vectors[i + 1], vectors[i + 2]};
    return sum;
}

}  // namespace featuremesh

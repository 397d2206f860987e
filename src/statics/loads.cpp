// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/loads.h"

#include "core/ids.h"
#include "statics/elements.h"

namespace featuremesh {

namespace {

void add(std::vector<double>& loads, NodeId node, const Vec3& load) {
    for (int c = 0; c < 3; ++c) loads[3 * node.index() + std::size_t(c)] += load[c];
}

/// The six-node triangle's derivatives and values at (a, b), its barycentric coordinates 1 and 2.
struct TrianglePoint {
    std::array<double, 6> values, along_a, along_b;
};

TrianglePoint triangle_point(double a, double b) {
    const double c = 1 - a - b;
    return {{c * (2 * c - 1), a * (2 * a - 1), b * (2 * b - 1), 4 * c * a, 4 * a * b, 4 * b * c},
            {1 - 4 * c, 4 * a - 1, 0, 4 * (c - a), 4 * b, -4 * b},
            {1 - 4 * c, 0, 4 * b - 1, -4 * a, 4 * a, 4 * (c - b)}};
}

std::array<NodeId, 6> six_nodes(const Mesh& mesh, std::size_t triangle) {
    const auto& corners = mesh.triangles[triangle];
    const auto& mids = mesh.triangle_mids[triangle];
    return {corners[0], corners[1], corners[2], mids[0], mids[1], mids[2]};
}

void add_pressure_on_curved(const Mesh& mesh, std::size_t triangle, double pressure, std::vector<double>& loads) {
    static const std::array<TrianglePoint, 3> points{triangle_point(1.0 / 6, 1.0 / 6), triangle_point(2.0 / 3, 1.0 / 6),
                                                     triangle_point(1.0 / 6, 2.0 / 3)};
    const auto nodes = six_nodes(mesh, triangle);
    for (const TrianglePoint& point : points) {
        Vec3 along_a, along_b;
        for (std::size_t i = 0; i < 6; ++i) {
            along_a += mesh.point(nodes[i]) * point.along_a[i];
            along_b += mesh.point(nodes[i]) * point.along_b[i];
        }
        const Vec3 inward = cross(along_a, along_b) * (-pressure / 6);
        for (std::size_t i = 0; i < 6; ++i) add(loads, nodes[i], inward * point.values[i]);
    }
}

double plane_area(const Mesh& mesh, NodeId a, NodeId b, NodeId c) {
    return length(cross(mesh.point(b) - mesh.point(a), mesh.point(c) - mesh.point(a))) / 2;
}

}  // namespace

void add_weight(const Mesh& mesh, std::span<const Material> materials, std::span<const std::int32_t> tet_materials,
                const Vec3& gravity, std::vector<double>& loads) {
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) {
        const Vec3 per_volume = gravity * materials[std::size_t(tet_materials[tet])].density;
        with_element(mesh, tet, [&](const auto& element) {
            for (std::size_t p = 0; p < element.points.size(); ++p) {
                const auto values = shape_values(int(element.nodes.size()), int(p));
                for (std::size_t i = 0; i < element.nodes.size(); ++i)
                    add(loads, element.nodes[i], per_volume * (values[i] * element.points[p].volume));
            }
        });
    }
}

void add_pressure(const Mesh& mesh, std::span<const std::int32_t> triangles, double pressure,
                  std::vector<double>& loads) {
    for (const std::int32_t triangle : triangles) {
        if (mesh.order == 2) {
            add_pressure_on_curved(mesh, std::size_t(triangle), pressure, loads);
            continue;
        }
        const auto& [a, b, c] = mesh.triangles[std::size_t(triangle)];
        const Vec3 normal = cross(mesh.point(b) - mesh.point(a), mesh.point(c) - mesh.point(a));
        for (const NodeId node : {a, b, c}) add(loads, node, normal * (-pressure / 6));
    }
}

std::vector<double> area_shares(const Mesh& mesh, std::span<const std::int32_t> triangles) {
    std::vector<double> shares(mesh.node_count(), 0.0);
    for (const std::int32_t triangle : triangles) {
        const auto& [a, b, c] = mesh.triangles[std::size_t(triangle)];
        if (mesh.order == 1) {
            for (const NodeId node : {a, b, c}) shares[node.index()] += plane_area(mesh, a, b, c) / 3;
            continue;
        }
        const auto& [ab, bc, ca] = mesh.triangle_mids[std::size_t(triangle)];
        const double area = plane_area(mesh, a, ab, ca) + plane_area(mesh, b, bc, ab) + plane_area(mesh, c, ca, bc) +
                            plane_area(mesh, ab, bc, ca);
        for (const NodeId node : {ab, bc, ca}) shares[node.index()] += area / 3;
    }
    return shares;
}

std::vector<double> length_shares(const Mesh& mesh, std::span<const std::int32_t> segments) {
    std::vector<double> shares(mesh.node_count(), 0.0);
    for (const std::int32_t segment : segments) {
        const auto& [a, b] = mesh.segments[std::size_t(segment)];
        if (mesh.order == 1) {
            for (const NodeId node : {a, b}) shares[node.index()] += distance(mesh.point(a), mesh.point(b)) / 2;
            continue;
        }
        const NodeId mid = mesh.segment_mids[std::size_t(segment)];
        const double along = distance(mesh.point(a), mesh.point(mid)) + distance(mesh.point(mid), mesh.point(b));
        shares[a.index()] += along / 6, shares[b.index()] += along / 6, shares[mid.index()] += along * 2 / 3;
    }
    return shares;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/stresses.h"

#include <algorithm>
#include <cmath>

#include "mesh/second_order.h"
#include "statics/elements.h"

namespace featuremesh {

namespace {

constexpr std::size_t grain = 1024;

Stress stress_at(const Element& element, const IntegrationPoint& point, const Material& material,
                 std::span<const double> displacements) {
    Vec3 along[3];  // the displacement's derivatives by x, y and z
    for (std::size_t i = 0; i < std::size_t(element.node_count); ++i) {
        const double* u = displacements.data() + 3 * element.nodes[i].index();
        const Vec3 moved{u[0], u[1], u[2]};
        along[0] += moved * point.gradients[i].x;
        along[1] += moved * point.gradients[i].y;
        along[2] += moved * point.gradients[i].z;
    }
    const double shear = material.shear_modulus();
    const double mean = material.lame_first() * (along[0].x + along[1].y + along[2].z);
    return {mean + 2 * shear * along[0].x,     mean + 2 * shear * along[1].y,     mean + 2 * shear * along[2].z,
            shear * (along[0].y + along[1].x), shear * (along[1].z + along[2].y), shear * (along[2].x + along[0].z)};
}

Vec3 times(const Stress& s, const Vec3& g) {
    return {s[0] * g.x + s[3] * g.y + s[5] * g.z, s[3] * g.x + s[1] * g.y + s[4] * g.z,
            s[5] * g.x + s[4] * g.y + s[2] * g.z};
}

/// Stresses of a tet continued to its corners.
std::array<Stress, 4> corner_stresses(const StaticsModel& model, std::span<const double> displacements,
                                      std::size_t tet) {
    static const CornerWeights weights = corner_weights();
    const Element element = element_at(model.mesh, tet);
    std::array<Stress, 4> inside{}, corners{};
    for (std::size_t p = 0; p < std::size_t(element.point_count); ++p)
        inside[p] = stress_at(element, element.points[p], model.material(tet), displacements);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 6; ++k) {
            if (element.point_count == 1) {
                corners[i][k] = inside[0][k];
                continue;
            }
            for (std::size_t p = 0; p < 4; ++p) corners[i][k] += (p == i ? weights.own : weights.other) * inside[p][k];
        }
    return corners;
}

/// Twice the energy density of a stress, N/mm^2.
double energy_density(const Stress& s, const Material& material) {
    const double trace = s[0] + s[1] + s[2];
    const double squares = s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
    return ((1 + material.poisson) * squares - material.poisson * trace * trace) / material.young;
}

/// The place of a node among those of a tet, corners first.
std::size_t place_in(const Mesh& mesh, std::size_t tet, std::size_t node) {
    const auto& corners = mesh.tets[tet];
    const auto corner = std::find(corners.begin(), corners.end(), NodeId(node));
    if (corner != corners.end()) return std::size_t(corner - corners.begin());
    const auto& mids = mesh.tet_mids[tet];
    return std::size_t(4 + std::find(mids.begin(), mids.end(), NodeId(node)) - mids.begin());
}

/// The corners whose mean is a node's own value.
std::array<std::size_t, 2> corners_of(std::size_t place) {
    if (place < 4) return {place, place};
    return {std::size_t(tet_sides[place - 4][0]), std::size_t(tet_sides[place - 4][1])};
}

}  // namespace

std::vector<double> resisting_forces(const StaticsModel& model, std::span<const double> displacements,
                                     const TetsOfNodes& around, RunContext& context) {
    const Mesh& mesh = model.mesh;
    const std::size_t width = mesh.order == 2 ? 10 : 4;
    std::vector<Vec3> of_elements(width * mesh.tets.size());
    parallel_for(context, mesh.tets.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tet = begin; tet < end; ++tet) {
            const Element element = element_at(mesh, tet);
            for (std::size_t p = 0; p < std::size_t(element.point_count); ++p) {
                const IntegrationPoint& point = element.points[p];
                const Stress stress = stress_at(element, point, model.material(tet), displacements);
                for (std::size_t i = 0; i < width; ++i)
                    of_elements[width * tet + i] += times(stress, point.gradients[i]) * point.volume;
            }
        }
    });
    std::vector<double> forces(3 * mesh.node_count(), 0.0);
    parallel_for(context, mesh.node_count(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node)
            for (auto t = around.starts[node]; t < around.starts[node + 1]; ++t) {
                const auto tet = std::size_t(around.tets[std::size_t(t)]);
                const Vec3& force = of_elements[width * tet + place_in(mesh, tet, node)];
                for (int c = 0; c < 3; ++c) forces[3 * node + std::size_t(c)] += force[c];
            }
    });
    return forces;
}

std::vector<Stress> nodal_stresses(const StaticsModel& model, std::span<const double> displacements,
                                   const TetsOfNodes& around, RunContext& context) {
    const Mesh& mesh = model.mesh;
    std::vector<std::array<Stress, 4>> of_corners(mesh.tets.size());
    parallel_for(context, mesh.tets.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tet = begin; tet < end; ++tet) of_corners[tet] = corner_stresses(model, displacements, tet);
    });
    std::vector<Stress> stresses(mesh.node_count(), Stress{});
    parallel_for(context, mesh.node_count(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node) {
            const auto count = double(around.starts[node + 1] - around.starts[node]);
            for (auto t = around.starts[node]; t < around.starts[node + 1]; ++t) {
                const auto tet = std::size_t(around.tets[std::size_t(t)]);
                const auto [a, b] = corners_of(place_in(mesh, tet, node));
                for (std::size_t k = 0; k < 6; ++k)
                    stresses[node][k] += (of_corners[tet][a][k] + of_corners[tet][b][k]) / (2 * count);
            }
        }
    });
    return stresses;
}

double discretisation_error(const StaticsModel& model, std::span<const double> displacements,
                            const std::vector<Stress>& nodal, RunContext& context) {
    const Mesh& mesh = model.mesh;
    const CornerWeights weights = inner_weights();
    std::vector<std::array<double, 2>> of_tets(mesh.tets.size(), {0.0, 0.0});  // of the difference, of the solution
    parallel_for(context, mesh.tets.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tet = begin; tet < end; ++tet) {
            const Element element = element_at(mesh, tet);
            const auto count = std::size_t(element.point_count);
            for (std::size_t p = 0; p < 4; ++p) {
                const IntegrationPoint& point = element.points[p % count];
                const Stress own = stress_at(element, point, model.material(tet), displacements);
                Stress difference = own;
                for (std::size_t i = 0; i < 4; ++i)
                    for (std::size_t k = 0; k < 6; ++k)
                        difference[k] -= (i == p ? weights.own : weights.other) * nodal[mesh.tets[tet][i].index()][k];
                const double volume = point.volume * double(count) / 4;
                of_tets[tet][0] += volume * energy_density(difference, model.material(tet));
                of_tets[tet][1] += volume * energy_density(own, model.material(tet));
            }
        }
    });
    double difference = 0, solution = 0;
    for (const auto& [a, b] : of_tets) difference += a, solution += b;
    return solution > 0 ? std::sqrt(difference / (difference + solution)) : 0;
}

double von_mises(const Stress& s) {
    const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
    return std::sqrt((xy * xy + yz * yz + zx * zx) / 2 + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

}  // namespace featuremesh

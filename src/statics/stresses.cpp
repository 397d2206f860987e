// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/stresses.h"

#include <algorithm>
#include <cmath>

#include "core/geometry.h"
#include "core/ids.h"
#include "mesh/mesh.h"
#include "mesh/second_order.h"
#include "statics/elements.h"

namespace featuremesh {

namespace {

constexpr std::size_t grain = 1024;

template <class ElementType>
Stress stress_at(const ElementType& element, std::size_t p, const Material& material,
                 std::span<const double> displacements) {
    const auto& point = element.points[p];
    Vec3 along[3];  // the displacement's derivatives by x, y and z
    for (std::size_t i = 0; i < element.nodes.size(); ++i) {
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

/// How many points of integration a tet has.
std::size_t points_of_tet(const Mesh& mesh) { return mesh.order == 2 ? 4 : 1; }

/// The stresses of a 10-node tet, from those inside, continued to a place of it.
Stress continued(std::span<const InnerStress> inside, const CornerWeights& weights,
                 const std::array<std::size_t, 2>& to) {
    Stress there{};
    for (std::size_t p = 0; p < 4; ++p) {
        const double weight =
            ((p == to[0] ? weights.own : weights.other) + (p == to[1] ? weights.own : weights.other)) / 2;
        for (std::size_t k = 0; k < 6; ++k) there[k] += weight * inside[p].stress[k];
    }
    return there;
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

/// A tet's own stress less that of its corners, continued linearly to one of four points inside.
Stress difference_at(const Mesh& mesh, std::size_t tet, std::size_t point, Stress own, const CornerWeights& weights,
                     const std::vector<Stress>& nodal) {
    for (std::size_t i = 0; i < 4; ++i) {
        const Stress& corner = nodal[mesh.tets[tet][i].index()];
        for (std::size_t k = 0; k < 6; ++k) own[k] -= (i == point ? weights.own : weights.other) * corner[k];
    }
    return own;
}

/// Over those of the tets around each that count; nothing where there are none.
template <class Counts>
std::vector<Stress> means_at_nodes(const StaticsModel& model, const std::vector<InnerStress>& inside,
                                   const TetsOfNodes& around, RunContext& context, Counts counts) {
    const Mesh& mesh = model.mesh;
    const CornerWeights weights = corner_weights();
    std::vector<Stress> stresses(mesh.node_count(), Stress{});
    parallel_for(context, mesh.node_count(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node) {
            const auto first = around.tets.begin() + around.starts[node],
                       last = around.tets.begin() + around.starts[node + 1];
            const auto count =
                double(std::count_if(first, last, [&](std::int32_t t) { return counts(std::size_t(t)); }));
            for (auto t = first; t != last; ++t) {
                const auto tet = std::size_t(*t);
                if (!counts(tet)) continue;
                const Stress there = mesh.order == 1 ? inside[tet].stress
                                                     : continued({inside.data() + 4 * tet, 4}, weights,
                                                                 corners_of(place_in(mesh, tet, node)));
                for (std::size_t k = 0; k < 6; ++k) stresses[node][k] += there[k] / count;
            }
        }
    });
    return stresses;
}

/// By material the means over its tets; none where there is one alone.
std::vector<std::vector<Stress>> means_by_material(const StaticsModel& model, const std::vector<InnerStress>& inside,
                                                   const TetsOfNodes& around, RunContext& context) {
    std::vector<std::vector<Stress>> means;
    for (std::size_t m = 0; model.materials.size() > 1 && m < model.materials.size(); ++m)
        means.push_back(means_at_nodes(model, inside, around, context,
                                       [&](std::size_t tet) { return std::size_t(model.tet_materials[tet]) == m; }));
    return means;
}

}  // namespace

Resistance resistance_to(std::span<const double> displacements, const StaticsModel& model, const TetsOfNodes& around,
                         RunContext& context) {
    const Mesh& mesh = model.mesh;
    const std::size_t width = mesh.order == 2 ? 10 : 4, points = points_of_tet(mesh);
    std::vector<Vec3> of_elements(width * mesh.tets.size());
    Resistance resistance{std::vector<double>(3 * mesh.node_count(), 0.0),
                          std::vector<InnerStress>(points * mesh.tets.size())};
    parallel_for(context, mesh.tets.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tet = begin; tet < end; ++tet)
            with_element(mesh, tet, [&](const auto& element) {
                for (std::size_t p = 0; p < points; ++p) {
                    const auto& point = element.points[p];
                    const Stress stress = stress_at(element, p, model.material(tet), displacements);
                    resistance.inside[points * tet + p] = {stress, point.volume};
                    for (std::size_t i = 0; i < element.nodes.size(); ++i)
                        of_elements[width * tet + i] += times(stress, point.gradients[i]) * point.volume;
                }
            });
    });
    parallel_for(context, mesh.node_count(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node)
            for (auto t = around.starts[node]; t < around.starts[node + 1]; ++t) {
                const auto tet = std::size_t(around.tets[std::size_t(t)]);
                const Vec3& force = of_elements[width * tet + place_in(mesh, tet, node)];
                for (int c = 0; c < 3; ++c) resistance.forces[3 * node + std::size_t(c)] += force[c];
            }
    });
    return resistance;
}

std::vector<Stress> nodal_stresses(const StaticsModel& model, const std::vector<InnerStress>& inside,
                                   const TetsOfNodes& around, RunContext& context) {
    return means_at_nodes(model, inside, around, context, [](std::size_t) { return true; });
}

DiscretisationError discretisation_error(const StaticsModel& model, const std::vector<InnerStress>& inside,
                                         const std::vector<Stress>& nodal, const TetsOfNodes& around,
                                         RunContext& context) {
    const Mesh& mesh = model.mesh;
    const CornerWeights weights = inner_weights();
    const std::vector<std::vector<Stress>> of_materials = means_by_material(model, inside, around, context);
    const std::size_t points = points_of_tet(mesh);
    std::vector<std::array<double, 2>> of_tets(mesh.tets.size(), {0.0, 0.0});  // of the difference, of the solution
    parallel_for(context, mesh.tets.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tet = begin; tet < end; ++tet) {
            const std::vector<Stress>& means =
                of_materials.empty() ? nodal : of_materials[std::size_t(model.tet_materials[tet])];
            for (std::size_t p = 0; p < points; ++p) {
                const auto& [own, volume] = inside[points * tet + p];
                const Material& material = model.material(tet);
                of_tets[tet][1] += volume * energy_density(own, material);
                for (std::size_t at = p; at < 4; at += points)
                    of_tets[tet][0] += volume * double(points) / 4 *
                                       energy_density(difference_at(mesh, tet, at, own, weights, means), material);
            }
        }
    });
    double difference = 0, solution = 0;
    for (const auto& [a, b] : of_tets) difference += a, solution += b;
    DiscretisationError error{0, std::vector<double>(of_tets.size(), 0.0)};
    if (!(solution > 0)) return error;
    const double energy = difference + solution;
    error.whole = std::sqrt(difference / energy);
    for (std::size_t tet = 0; tet < of_tets.size(); ++tet) error.of_tets[tet] = std::sqrt(of_tets[tet][0] / energy);
    return error;
}

DiscretisationError discretisation_error(const StaticsModel& model, std::span<const double> displacements,
                                         RunContext& context) {
    const TetsOfNodes around = tets_of_nodes(model.mesh);
    const Resistance resistance = resistance_to(displacements, model, around, context);
    return discretisation_error(model, resistance.inside, nodal_stresses(model, resistance.inside, around, context),
                                around, context);
}

double von_mises(const Stress& s) {
    const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
    return std::sqrt((xy * xy + yz * yz + zx * zx) / 2 + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

}  // namespace featuremesh

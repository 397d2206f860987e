// SPDX-License-Identifier: GPL-3.0-or-later
// What is solved: a mesh of linear elastic material, held and loaded at its nodes.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace featuremesh {

/// An isotropic linear elastic material.
struct Material {
    double young = 0;    ///< MPa
    double poisson = 0;  ///< from -1 to below 0.5
    double density = 0;  ///< t/mm^3

    bool operator==(const Material&) const = default;
    double lame_first() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }
    double shear_modulus() const { return young / (2 * (1 + poisson)); }
};

/// Vectors have three components per node, one node after the other.
struct StaticsModel {
    const Mesh& mesh;
    std::vector<Material> materials;
    std::vector<std::int32_t> tet_materials;  ///< by tet, index into `materials`
    std::vector<double> loads;                ///< N
    std::vector<char> is_held;                ///< whether that component of the node's displacement is given
    std::vector<double> given;                ///< mm, where it is given; 0 elsewhere

    const Material& material(std::size_t tet) const { return materials[std::size_t(tet_materials[tet])]; }
};

/// Throws InputError for sizes that do not fit, for materials that none can have, and for numbers that are not finite.
void check(const StaticsModel& model);

}  // namespace featuremesh

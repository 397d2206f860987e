// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from displacements: stresses, and the forces that the elements put on their nodes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/run_context.h"
#include "mesh/mesh.h"
#include "statics/model.h"
#include "statics/stiffness.h"

namespace featuremesh {

/// xx, yy, zz, xy, yz, zx; MPa.
using Stress = std::array<double, 6>;

/// A stress at a point of integration, and the volume that this stands for, mm^3.
struct InnerStress {
    Stress stress;
    double volume;
};

/// How elements resist the displacements of their nodes.
struct Resistance {
    std::vector<double> forces;  ///< (n,3) N: the stiffness matrix times the displacements, but without that matrix
    std::vector<InnerStress> inside;  ///< by tet at its points of integration
};
Resistance resistance_to(std::span<const double> displacements, const StaticsModel& model, const TetsOfNodes& around,
                         RunContext& context);

/// Stresses at the nodes as CalculiX writes them: those of an element's points of integration are continued linearly to
/// its nodes, and a node has the mean over its elements.
std::vector<Stress> nodal_stresses(const StaticsModel& model, const std::vector<InnerStress>& inside,
                                   const TetsOfNodes& around, RunContext& context);

/// Estimate of how far the mesh keeps the solution from the true one: the energy norm of the difference between the
/// elements' stresses and the nodes' means, of elements of the same material each, over that of the solution
/// (ZienkiewiczZhu1987). `nodal` are the means over all elements.
struct DiscretisationError {
    double whole = 0;
    std::vector<double> of_tets;  ///< each one's part; the sum of their squares is the square of the whole
};
DiscretisationError discretisation_error(const StaticsModel& model, const std::vector<InnerStress>& inside,
                                         const std::vector<Stress>& nodal, const TetsOfNodes& around,
                                         RunContext& context);
/// The same of displacements, (n,3) mm.
DiscretisationError discretisation_error(const StaticsModel& model, std::span<const double> displacements,
                                         RunContext& context);

double von_mises(const Stress& stress);

}  // namespace featuremesh

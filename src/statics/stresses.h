// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from displacements: stresses, and the forces that the elements put on their nodes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/run_context.h"
#include "statics/model.h"
#include "statics/stiffness.h"

namespace featuremesh {

/// xx, yy, zz, xy, yz, zx; MPa.
using Stress = std::array<double, 6>;

/// The forces by which the elements resist the displacements, (n,3) N: the stiffness matrix times them, but element by
/// element, without that matrix.
std::vector<double> resisting_forces(const StaticsModel& model, std::span<const double> displacements,
                                     const TetsOfNodes& around, RunContext& context);

/// Stresses at the nodes as CalculiX writes them: those of an element's points of integration are continued linearly to
/// its nodes, and a node has the mean over its elements.
std::vector<Stress> nodal_stresses(const StaticsModel& model, std::span<const double> displacements,
                                   const TetsOfNodes& around, RunContext& context);

/// Estimate of how far the mesh keeps the solution from the true one: the energy norm of the difference between the
/// elements' stresses and the nodes' means, over that of the solution (ZienkiewiczZhu1987).
double discretisation_error(const StaticsModel& model, std::span<const double> displacements,
                            const std::vector<Stress>& nodal, RunContext& context);

double von_mises(const Stress& stress);

}  // namespace featuremesh

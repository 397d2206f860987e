// SPDX-License-Identifier: GPL-3.0-or-later
// What a solution within a tolerance leaves out of balance as a whole: a force and a moment.
#pragma once

#include <span>
#include <vector>

#include "core/run_context.h"
#include "statics/model.h"
#include "statics/rigid_motions.h"
#include "statics/stiffness.h"

namespace featuremesh {

/// Moves all that is free as one rigid body, three ways along and three about the middle, until the forces out of
/// balance have neither a sum nor a moment. That is Galerkin's condition on these six motions, so the energy of the
/// error becomes less; what is held stays, and only elements beside it are strained.
class RigidBalance {
  public:
    RigidBalance(const StaticsModel& model, const BlockMatrix& matrix, RunContext& context);

    /// Adds to `moved`, which was to balance `forces`, three numbers a node, 0 on held components.
    void correct(std::span<const double> forces, std::span<double> moved) const;

  private:
    using Six = RigidMotions::Six;

    Six at(std::size_t component) const;

    /// What a component resists with when all moves by each motion.
    struct Resisted {
        std::size_t component;
        Six by;
    };

    const StaticsModel& model_;
    RigidMotions motions_;
    std::vector<Resisted> resisted_;  // beside held components only: elsewhere it is nothing
    SixFactor factor_;
};

}  // namespace featuremesh

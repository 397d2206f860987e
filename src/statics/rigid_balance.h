// SPDX-License-Identifier: GPL-3.0-or-later
// What a solution within a tolerance leaves out of balance as a whole: a force and a moment.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "core/run_context.h"
#include "statics/model.h"
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
    static constexpr std::size_t count = 6;
    using Motions = std::array<double, count>;
    using Square = std::array<Motions, count>;

    Vec3 place(std::size_t node) const;
    Motions at(std::size_t component) const;
    void factor(Square stiffness);
    Motions solve(Motions forces) const;

    /// What a component resists with when all moves by each motion.
    struct Resisted {
        std::size_t component;
        Motions by;
    };

    const StaticsModel& model_;
    Vec3 middle_;
    double radius_ = 1;
    std::vector<Resisted> resisted_;  // beside held components only: elsewhere it is nothing
    Square factor_{};                 // Cholesky's, lower
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Conjugate gradients with algebraic multigrid for stiffness matrices. PETSc does it, in a library that is loaded when
// it is needed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/run_context.h"
#include "statics/coarse_level.h"
#include "statics/stiffness.h"

namespace featuremesh {

class LinearSolver {
  public:
    virtual ~LinearSolver() = default;

    /// How many threads products with the matrix are made on; the solution has the same bytes for any number.
    virtual void use_threads(int threads) = 0;

    /// Takes the matrix and sets its preconditioner up anew; `points` are its nodes, mm. That of 10-node tets goes by
    /// way of the coarse level, that of 4-node tets has none.
    virtual void set_up(BlockMatrix matrix, std::span<const Vec3> points, std::optional<CoarseLevel> coarse) = 0;

    /// Factors the matrix of the last set-up, for 10-node tets that of their coarse level, in place of its aggregation.
    /// Returns false and changes nothing where that would take too long.
    virtual bool factor() = 0;

    /// Factors the matrix of 10-node tets itself, as it was at the last set-up, and does without the coarse level from
    /// now on. Returns false and changes nothing where that would take too long.
    virtual bool factor_finest() = 0;

    /// Takes another matrix and keeps the aggregation: `origin` is by node (with a coarse level by its nodes) the node
    /// at the last set-up, -1 for those that were not there or are held otherwise now. The new nodes' own block is
    /// factored.
    virtual void carry_over(BlockMatrix matrix, std::optional<CoarseLevel> coarse,
                            std::vector<std::int32_t> origin) = 0;

    /// The matrix that it solves; empty before it has one.
    virtual const BlockMatrix& matrix() const = 0;

    /// Hands out the matrix and that of its coarse level, to be changed in place to those that it is carried over to.
    /// Empty where there is none. Until it is given others nothing else may be asked for.
    struct Matrices {
        BlockMatrix finest, coarse;
    };
    virtual Matrices give_matrices() = 0;

    /// Moves these nodes until the forces at them are all but balanced, then, where there is a coarse level, all nodes
    /// by what that makes of the forces beside them. `forces` are what the displacements have to balance, zero on held
    /// components, which stay where they are.
    virtual void balance_within(std::span<const std::int32_t> nodes, std::span<const double> forces,
                                std::span<double> displacements) = 0;

    /// sqrt(r B r) with B the preconditioner: about the energy norm of the error that leaves the residual r.
    virtual double energy_norm(std::span<const double> residual) = 0;

    /// When iterations end.
    struct Aim {
        double energy_norm;  ///< of what is left: within it, or expected to be after a few fast iterations
        int most_iterations;
        bool has_patience;  ///< to go on where a hundred iterations left more than a fifth
    };
    struct Solved {
        int iterations;
        bool is_within;  ///< the energy norm that was aimed at, or is expected to be: the caller has to look
    };

    /// Adds to `solution` what solves the matrix for `residual`. Throws Cancelled.
    virtual Solved solve(std::span<const double> residual, std::span<double> solution, const Aim& aim,
                         const RunContext& context) = 0;
};

/// Throws InputError with the package to install where there is no PETSc.
std::unique_ptr<LinearSolver> make_linear_solver();

/// Whether make_linear_solver would succeed, and if not why.
bool has_linear_solver(std::string* reason = nullptr);

}  // namespace featuremesh

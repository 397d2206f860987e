// SPDX-License-Identifier: GPL-3.0-or-later
// Linear statics of one mesh after another, each solved from what the last one left.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "statics/linear_solver.h"
#include "statics/model.h"
#include "statics/node_order.h"
#include "statics/stiffness.h"
#include "statics/stresses.h"

namespace featuremesh {

/// What conjugate gradients are preconditioned by.
enum class PreconditionedBy {
    aggregation,    ///< multigrid by smoothed aggregation, of 10-node tets below their own level
    linear_factor,  ///< of 10-node tets: a factor for the linear displacements, below their own level
    factor,         ///< a factor of the matrix itself
};

struct StaticsSolution {
    std::vector<double> displacements;  ///< (n,3) mm
    std::vector<Stress> stresses;       ///< by node, MPa
    std::vector<double> reactions;      ///< (n,3) N, on held components; 0 elsewhere
    double strain_energy = 0;           ///< N mm
    int iterations = 0;
    /// Of the forces out of balance where nothing is held over those that the displacements were to balance; from the
    /// elements, without the matrix that was solved.
    double residual = 0;
    double energy_error = 0;          ///< estimate of the energy norm of the solution's error, relative
    double discretisation_error = 0;  ///< estimate of what the mesh is off, of the energy norm (see stresses.h)
    PreconditionedBy preconditioned_by = PreconditionedBy::aggregation;  ///< at the end
    bool kept_preconditioner = false;
    double kept_start_share = 0;  ///< of the nodes that started from their last displacement
};

/// Keeps what the next solution can start from: the preconditioner, and the displacements by node number.
class StaticsSolver {
  public:
    static constexpr double tolerance = 1e-6;  ///< of the energy norm
    static constexpr int most_iterations = 500;

    /// Throws InputError for a model that cannot be solved and KernelError where the solver does not converge.
    /// Steps: "assemble", "setup", "solve", "stresses". What is kept changes the time, never more of the answer than
    /// the tolerance.
    StaticsSolution solve(const StaticsModel& model, RunContext& context);

    /// Lets the next solution start from displacements, (n,3) mm by node number, where it knows of none itself. A
    /// number that is another node now costs iterations, no more; what is not finite is left out.
    void start_from(std::span<const Number> numbers, std::span<const double> displacements);

    /// Forgets what was kept.
    void forget() { *this = StaticsSolver(); }

  private:
    using Ordered = std::shared_ptr<const OrderedModel>;

    struct Setup {
        std::vector<Number> nodes;  ///< the numbers of those that it knows
        std::vector<char> is_held;  ///< by component of theirs
        std::vector<Material> materials;
        PreconditionedBy by = PreconditionedBy::aggregation;
        int iterations = 20;  ///< of the first solution with it; until one is found a guess
    };

    /// What a solution starts from.
    struct Start {
        std::vector<double> residual;  ///< what it leaves of the forces out of balance, by the matrix
        double least_energy_norm;      ///< of what balances all of them; 0 where nothing is known
    };

    StaticsSolution solve_ordered(const Ordered& ordered, RunContext& context);
    std::vector<std::int32_t> origins(const StaticsModel& model) const;
    bool goes_by_corners(const StaticsModel& model) const;
    void remember_nodes(const StaticsModel& model);
    void put_factor(PreconditionedBy wanted, const StaticsModel& model, RunContext& context);
    bool prepare(const Ordered& ordered, RunContext& context);
    void carry_over(const Ordered& ordered, std::vector<std::int32_t> origin, RunContext& context);
    SameRows same_rows_of(const OrderedModel& ordered, RunContext& context) const;
    void balance(const Ordered& ordered, std::span<const double> unbalanced, const Start& start,
                 StaticsSolution& solution, Resistance& resistance, RunContext& context);
    LinearSolver::Solved move_by(const StaticsModel& model, std::span<const double> residual,
                                 const LinearSolver::Aim& aim, std::vector<double>& displacements, RunContext& context);
    double whole_energy_norm(std::span<const double> unbalanced);
    Start start_at(std::vector<double>& moved, const std::vector<double>& unbalanced, RunContext& context) const;
    Start start_from_last(const StaticsModel& model, const std::vector<double>& unbalanced, StaticsSolution& solution,
                          RunContext& context) const;

    std::unique_ptr<LinearSolver> solver_;
    Ordered assembled_;  ///< what its matrix is assembled from
    Setup setup_;        ///< where the preconditioner is from
    struct {
        std::vector<Number> nodes;  ///< their numbers
        std::vector<double> displacements;
    } last_;  ///< the last solution
};

}  // namespace featuremesh

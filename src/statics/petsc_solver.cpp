// SPDX-License-Identifier: GPL-3.0-or-later
// The solver by PETSc, in a library of its own.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <string>
#include <utility>

#include "core/errors.h"
#include "core/messages.h"
#include "statics/linear_solver.h"
#include "statics/new_nodes.h"
#include "statics/petsc_aggregation.h"
#include "statics/petsc_nodes_block.h"
#include "statics/petsc_objects.h"
#include "statics/petsc_quadratic.h"

namespace featuremesh {

namespace {

/// MPI for this process alone: nothing is started beside it and nothing left on the disk. Neither the environment nor a
/// file of the user changes how is solved, and signals stay FreeCAD's.
void start_petsc() {
    PetscBool is_running = PETSC_FALSE;
    PetscInitialized(&is_running);
    if (is_running) return;
    int has_mpi = 0;
    MPI_Initialized(&has_mpi);
    if (!has_mpi) {
        setenv("OMPI_MCA_ess_singleton_isolated", "1", 1);
        setenv("OMPI_MCA_orte_create_session_dirs", "0", 1);
        setenv("OMPI_MCA_btl", "self", 1);
    }
    unsetenv("PETSC_OPTIONS");
    check(PetscOptionsSetValue(nullptr, "-skip_petscrc", nullptr));
    check(PetscOptionsSetValue(nullptr, "-no_signal_handler", nullptr));
    check(PetscInitializeNoArguments());
    check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
    // Otherwise how it sums depends on where in memory the vectors lie, since PETSc 3.20.
    check(PetscOptionsSetValue(nullptr, "-vec_mdot_use_gemv", "no"));
    check(PetscOptionsSetValue(nullptr, "-vec_maxpy_use_gemv", "no"));
    check(PetscOptionsSetValue(nullptr, "-mat_cholmod_print", "0"));
    for (const auto& [name, value] : {std::pair{"pc_gamg_type", "agg"},
                                      {"pc_gamg_agg_nsmooths", "1"},
                                      {"pc_gamg_threshold", "0.02"},
                                      {"mg_levels_ksp_type", "chebyshev"},
                                      {"mg_levels_ksp_max_it", "2"},
                                      {"mg_levels_pc_type", "jacobi"}})
        check(PetscOptionsSetValue(nullptr, (std::string("-") + Aggregation::prefix + name).c_str(), value));
}

/// When conjugate gradients stop. The energy norm of what is left is known of the iteration before, since it takes the
/// preconditioner. Where each of the last two took off half of it and more, the present one is expected to do so, too:
/// the caller asks for the norm of what is left anyway.
struct Stop {
    LinearSolver::Aim aim;
    const RunContext* context;
    bool is_cancelled = false;
    double early_norm = 0;          ///< that of a hundred iterations ago
    std::array<double, 3> norms{};  ///< the last ones, the latest first

    void add(double norm) { norms = {norm, norms[0], norms[1]}; }

    double expected() const {
        constexpr double fast = 0.5;
        const double share = std::max(norms[0] / norms[1], norms[1] / norms[2]);
        return share <= fast ? share * norms[0] : norms[0];
    }

    bool is_enough(PetscInt iteration) {
        constexpr double slow = 0.2;  // what is left of the norm where 500 iterations will hardly do
        if (iteration >= aim.most_iterations) return true;
        if (iteration % 100 != 1) return false;  // the first norm is known then
        const double before = std::exchange(early_norm, norms[0]);
        return !aim.has_patience && iteration > 1 && norms[0] > slow * before;
    }
};

PetscErrorCode look_whether_to_stop(KSP, PetscInt iteration, PetscReal norm, KSPConvergedReason* reason, void* data) {
    Stop& stop = *static_cast<Stop*>(data);
    *reason = KSP_CONVERGED_ITERATING;
    if (PetscIsInfOrNanReal(norm) || PetscIsInfOrNanReal(stop.norms[0]))
        *reason = KSP_DIVERGED_NANORINF;
    else if (iteration > 0 && stop.expected() <= stop.aim.energy_norm)
        *reason = KSP_CONVERGED_ATOL;
    else if (stop.is_enough(iteration))
        *reason = KSP_DIVERGED_ITS;
    return guarded([&] {
        try {
            stop.context->check_cancelled();
        } catch (const Cancelled&) {
            stop.is_cancelled = true;
            *reason = KSP_DIVERGED_ITS;
        }
    });
}

class PetscSolver final : public LinearSolver {
  public:
    PetscSolver() { start_petsc(); }

    void set_up(BlockMatrix matrix, std::span<const Vec3> points, std::optional<CoarseLevel> coarse) override {
        forget_known();
        whole([&] {
            quadratic_.reset();
            if (coarse) points = points.first(coarse->matrix.node_count());
            aggregation_.set_up(std::move(coarse ? coarse->matrix : matrix), points);
            take_quadratic(std::move(matrix), coarse);
        });
    }

    bool factor() override {
        forget_known();
        return aggregation_.factor();
    }

    bool factor_finest() override {
        if (!is_quadratic_) return false;
        const BlockMatrix& blocks = quadratic_.system().blocks;
        std::vector<std::int32_t> nodes(blocks.node_count());
        std::iota(nodes.begin(), nodes.end(), 0);
        NodesBlock all;
        Factor factor;
        all.take(blocks, std::move(nodes));
        if (!factor.set_up_large(all.matrix)) return false;
        forget_known();
        is_quadratic_ = false;
        whole([&] { aggregation_.set_up_factored(quadratic_.give_matrix(), factor); });
        return true;
    }

    void carry_over(BlockMatrix matrix, std::optional<CoarseLevel> coarse, std::vector<std::int32_t> origin) override {
        forget_known();
        whole([&] {
            aggregation_.carry_over(std::move(coarse ? coarse->matrix : matrix), std::move(origin));
            take_quadratic(std::move(matrix), coarse);
        });
    }

    const BlockMatrix& matrix() const override { return system().blocks; }

    Matrices give_matrices() override {
        forget_known();
        if (!is_quadratic_) return {aggregation_.give_matrix(), {}};
        return {quadratic_.give_matrix(), aggregation_.give_matrix()};
    }

    void use_threads(int threads) override {
        aggregation_.use_threads(threads);
        quadratic_.use_threads(threads);
    }

    void balance_within(std::span<const std::int32_t> nodes, std::span<const double> forces,
                        std::span<double> displacements) override {
        if (nodes.empty()) return;
        const BlockMatrix& blocks = system().blocks;
        const NodesUpperHalf block(blocks, nodes);
        Vector in, out;
        fill(in, left_at(nodes, forces, displacements));
        check(VecDuplicate(in, out.fresh()));
        solve_roughly(block.matrix, in, out);
        read(out, [&](const double* moved) {
            for (std::size_t i = 0; i < 3 * nodes.size(); ++i) displacements[component(nodes, i)] += moved[i];
        });
        if (!is_quadratic_) return;

        const std::vector<std::int32_t> around = with_neighbours({nodes.begin(), nodes.end()}, blocks);
        const std::vector<double> left = left_at(around, forces, displacements);
        std::vector<double> all(displacements.size(), 0.0);
        for (std::size_t i = 0; i < left.size(); ++i) all[component(around, i)] = left[i];
        fill(in, all);
        check(VecDuplicate(in, out.fresh()));
        whole([&] { quadratic_.correct(in, out); });
        read(out, [&](const double* moved) {
            for (std::size_t i = 0; i < all.size(); ++i) displacements[i] += moved[i];
        });
    }

    double energy_norm(std::span<const double> residual) override {
        Vector r, z;
        fill(r, residual);
        if (is_known(r)) return known_norm_;
        check(VecDuplicate(r, z.fresh()));
        PetscScalar product = 0;
        whole([&] {
            if (is_quadratic_) {
                product = quadratic_.begin(r, z);
            } else {
                aggregation_.apply(r, z);
                check(VecDot(r, z, &product));
            }
        });
        swap(known_in_, r), swap(known_out_, z);
        is_begun_ = is_quadratic_;
        if (!std::isfinite(double(product))) {
            forget_known();
            throw KernelError(say<Code::petsc_out_of_range>());
        }
        return known_norm_ = std::sqrt(std::max(0.0, double(product)));
    }

    Solved solve(std::span<const double> residual, std::span<double> solution, const Aim& aim,
                 const RunContext& context) override {
        if (energy_norm(residual) <= aim.energy_norm) return {0, true};
        Vector b, x;
        fill(b, residual);
        check(VecDuplicate(b, x.fresh()));
        Owned<KSP, KSPDestroy> cg;
        Preconditioner shell;
        Stop stop{aim, &context};
        Watched watched{*this, stop};
        check(PCCreate(PETSC_COMM_SELF, shell.fresh()));
        use_shell(shell, watched);
        check(KSPCreate(PETSC_COMM_SELF, cg.fresh()));
        use_conjugate_gradients(cg);
        check(KSPSetNormType(cg, KSP_NORM_UNPRECONDITIONED));
        check(KSPSetPC(cg, shell));
        check(KSPSetOperators(cg, system().exact, system().exact));
        check(KSPSetConvergenceTest(cg, look_whether_to_stop, &stop, nullptr));
        whole([&] { check(KSPSolve(cg, b, x)); });
        if (stop.is_cancelled) throw Cancelled();
        KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
        check(KSPGetConvergedReason(cg, &reason));
        if (reason == KSP_DIVERGED_NANORINF) throw KernelError(say<Code::petsc_out_of_range>());
        read(x, [&](const double* moved) {
            for (std::size_t i = 0; i < solution.size(); ++i) solution[i] += moved[i];
        });
        PetscInt iterations = 0;
        check(KSPGetIterationNumber(cg, &iterations));
        return {int(iterations), reason > 0};
    }

    /// Preconditions.
    void apply(Vec in, Vec out) {
        if (is_known(in)) {
            if (std::exchange(is_begun_, false)) quadratic_.end(known_in_, known_out_);
            check(VecCopy(known_out_, out));
        } else if (is_quadratic_)
            quadratic_.apply(in, out);
        else
            aggregation_.apply(in, out);
    }

  private:
    /// Preconditions and says what the energy norm is.
    struct Watched {
        PetscSolver& solver;
        Stop& stop;

        void apply(Vec in, Vec out) {
            solver.apply(in, out);
            PetscScalar product = 0;
            check(VecDot(in, out, &product));
            stop.add(std::sqrt(std::abs(double(product))));
        }
    };

    /// Calls work of which PETSc's preconditioners are no more to be used when it does not come to its end.
    template <class Work>
    void whole(const Work& work) {
        try {
            work();
        } catch (...) {
            aggregation_.abandon(), quadratic_.abandon();
            throw;
        }
    }

    /// Flexible ones where the preconditioner ends with iterations, so that it is another each time (Notay 2000).
    void use_conjugate_gradients(KSP cg) const {
        check(KSPSetType(cg, is_quadratic_ ? KSPFCG : KSPCG));
        if (!is_quadratic_) return;  // PETSc takes any solver for a flexible one in what follows
        check(KSPFCGSetMmax(cg, 1));
        check(KSPFCGSetNprealloc(cg, 2));
    }

    /// As far as a start needs it, by conjugate gradients with an incomplete factor. Where that fails nothing comes
    /// out that is finite.
    static void solve_roughly(Mat matrix, Vec in, Vec out) {
        constexpr double least_share = 1e-3;
        constexpr PetscInt most = 300;
        Owned<KSP, KSPDestroy> cg;
        PC factor = nullptr;
        check(KSPCreate(PETSC_COMM_SELF, cg.fresh()));
        check(KSPSetType(cg, KSPCG));
        check(KSPSetNormType(cg, KSP_NORM_NATURAL));
        check(KSPSetOperators(cg, matrix, matrix));
        check(KSPGetPC(cg, &factor));
        check(PCSetType(factor, PCICC));
        check(KSPSetTolerances(cg, least_share, 0, PETSC_DEFAULT, most));
        check(KSPSolve(cg, in, out));
    }

    void take_quadratic(BlockMatrix matrix, const std::optional<CoarseLevel>& coarse) {
        is_quadratic_ = coarse.has_value();
        if (coarse)
            quadratic_.set_up(std::move(matrix), *coarse, aggregation_);
        else
            quadratic_.reset();
    }

    const System& system() const { return is_quadratic_ ? quadratic_.system() : aggregation_.system(); }

    /// Conjugate gradients begin with the residual whose norm was asked for last.
    bool is_known(Vec in) const {
        PetscBool is_same = PETSC_FALSE;
        if (known_in_) check(VecEqual(known_in_, in, &is_same));
        return is_same;
    }

    void forget_known() { known_in_.reset(), known_out_.reset(); }

    static void fill(Vector& vector, std::span<const double> values) {
        check(VecCreateSeq(PETSC_COMM_SELF, PetscInt(values.size()), vector.fresh()));
        PetscScalar* to = nullptr;
        check(VecGetArrayWrite(vector, &to));
        std::copy(values.begin(), values.end(), to);
        check(VecRestoreArrayWrite(vector, &to));
    }

    template <class Take>
    static void read(Vec vector, const Take& take) {
        const PetscScalar* values = nullptr;
        check(VecGetArrayRead(vector, &values));
        take(values);
        check(VecRestoreArrayRead(vector, &values));
    }

    /// What the displacements leave of the forces at some nodes.
    std::vector<double> left_at(std::span<const std::int32_t> nodes, std::span<const double> forces,
                                std::span<const double> displacements) const {
        std::vector<double> left = resisting(system().blocks, nodes, displacements);
        for (std::size_t i = 0; i < left.size(); ++i) left[i] = forces[component(nodes, i)] - left[i];
        return left;
    }

    Aggregation aggregation_;
    QuadraticLevel quadratic_;  // above it, for 10-node tets
    bool is_quadratic_ = false;
    Vector known_in_, known_out_;  // what was preconditioned for its norm, and what came out
    bool is_begun_ = false;        // that is not at its end
    double known_norm_ = 0;
};

}  // namespace

}  // namespace featuremesh

extern "C" featuremesh::LinearSolver* featuremesh_make_petsc_solver() { return new featuremesh::PetscSolver; }

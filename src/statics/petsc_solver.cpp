// SPDX-License-Identifier: GPL-3.0-or-later
// The solver by PETSc, in a library of its own.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/errors.h"
#include "core/messages.h"
#include "statics/linear_solver.h"
#include "statics/petsc_factor.h"
#include "statics/petsc_nodes_block.h"
#include "statics/petsc_objects.h"
#include "statics/petsc_products.h"

namespace featuremesh {

namespace {

constexpr const char* prefix = "featuremesh_";                      // of the options of the aggregation
constexpr const char* quadratic_prefix = "featuremesh_quadratic_";  // and of the level above it
constexpr double most_factor_work = 2e10;                           // multiplications, about 20 s

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
    for (const auto& [name, value] : {std::pair{"pc_gamg_type", "agg"},
                                      {"pc_gamg_agg_nsmooths", "1"},
                                      {"pc_gamg_threshold", "0.02"},
                                      {"mg_levels_ksp_type", "chebyshev"},
                                      {"mg_levels_ksp_max_it", "2"},
                                      {"mg_levels_pc_type", "jacobi"},
                                      {"quadratic_mg_levels_ksp_type", "chebyshev"},
                                      {"quadratic_mg_levels_ksp_max_it", "3"},
                                      {"quadratic_mg_levels_pc_type", "jacobi"}})
        check(PetscOptionsSetValue(nullptr, (std::string("-") + prefix + name).c_str(), value));
}

/// A matrix as PETSc reads it. Its products are made on several threads, each row by itself.
struct System {
    BlockMatrix blocks;
    Matrix exact;    ///< what is solved
    Matrix rounded;  ///< what is preconditioned: products in single precision, which have half the memory to read
    RunContext threads;

    PetscInt size() const { return PetscInt(3 * blocks.node_count()); }

    void take(BlockMatrix taken) {
        exact.reset(), rounded.reset();
        blocks = std::move(taken);
        make_shell(exact, &System::multiply_exactly);
    }

    /// For a preconditioner that asks for products and the diagonal only.
    void round_products() {
        round();
        make_shell(rounded, &System::multiply_rounded);
    }

    /// For one that looks at every entry. PETSc shares the values; only products are rounded.
    void round_products_of_entries() {
        round();
        if (blocks.values.size() > std::size_t(std::numeric_limits<PetscInt>::max()))
            throw InputError(say<Code::too_fine_to_solve>());
        starts_.assign(std::size_t(size()) + 1, 0);
        columns_.resize(blocks.values.size());
        for (std::size_t node = 0; node < blocks.node_count(); ++node) {
            const auto begin = std::size_t(blocks.starts[node]), end = std::size_t(blocks.starts[node + 1]);
            const std::size_t width = 3 * (end - begin);
            for (std::size_t r = 0; r < 3; ++r) {
                const std::size_t at = 9 * begin + r * width;
                starts_[3 * node + r + 1] = PetscInt(at + width);
                for (std::size_t k = 0; k < width; ++k)
                    columns_[at + k] = 3 * blocks.neighbours[begin + k / 3] + PetscInt(k % 3);
            }
        }
        check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, size(), size(), starts_.data(), columns_.data(),
                                        blocks.values.data(), rounded.fresh()));
        check(MatSetBlockSize(rounded, 3));
        check(MatSetOption(rounded, MAT_SPD, PETSC_TRUE));
        Owned<PetscContainer, PetscContainerDestroy> self;
        check(PetscContainerCreate(PETSC_COMM_SELF, self.fresh()));
        check(PetscContainerSetPointer(self, this));
        check(PetscObjectCompose((PetscObject)(Mat)rounded, owner, (PetscObject)(PetscContainer)self));
        check(MatSetOperation(rounded, MATOP_MULT, (void (*)(void)) & System::multiply_entries));
        products_.serve(rounded);
    }

  private:
    using Product = PetscErrorCode (*)(Mat, Vec, Vec);

    void round() { rounded_ = {3, blocks.starts, blocks.neighbours, blocks.values.data(), threads}; }

    void make_shell(Matrix& shell, Product product) {
        check(MatCreateShell(PETSC_COMM_SELF, size(), size(), size(), size(), this, shell.fresh()));
        check(MatShellSetOperation(shell, MATOP_MULT, (void (*)(void))product));
        check(MatShellSetOperation(shell, MATOP_GET_DIAGONAL, (void (*)(void)) & System::get_diagonal));
        check(MatSetOption(shell, MAT_SPD, PETSC_TRUE));
    }

    static PetscErrorCode multiply_exactly(Mat of, Vec in, Vec out) {
        System* self = nullptr;
        PetscCall(MatShellGetContext(of, &self));
        return self->multiply(in, out);
    }

    static PetscErrorCode multiply_rounded(Mat of, Vec in, Vec out) {
        System* self = nullptr;
        PetscCall(MatShellGetContext(of, &self));
        return multiply_by(self->rounded_, in, out, self->threads);
    }

    static PetscErrorCode multiply_entries(Mat of, Vec in, Vec out) {
        PetscObject found = nullptr;
        void* self = nullptr;
        PetscCall(PetscObjectQuery((PetscObject)of, owner, &found));
        PetscCall(PetscContainerGetPointer((PetscContainer)found, &self));
        return multiply_by(static_cast<System*>(self)->rounded_, in, out, static_cast<System*>(self)->threads);
    }

    static PetscErrorCode get_diagonal(Mat of, Vec out) {
        System* self = nullptr;
        PetscScalar* y = nullptr;
        PetscCall(MatShellGetContext(of, &self));
        PetscCall(VecGetArrayWrite(out, &y));
        const BlockMatrix& blocks = self->blocks;
        for (std::size_t node = 0; node < blocks.node_count(); ++node) {
            const auto first = blocks.neighbours.begin() + blocks.starts[node];
            const auto last = blocks.neighbours.begin() + blocks.starts[node + 1];
            const auto at = std::size_t(std::lower_bound(first, last, std::int32_t(node)) - first);
            const auto width = 3 * std::size_t(last - first);
            for (std::size_t r = 0; r < 3; ++r)
                y[3 * node + r] = blocks.values[9 * std::size_t(blocks.starts[node]) + r * width + 3 * at + r];
        }
        PetscCall(VecRestoreArrayWrite(out, &y));
        return PetscErrorCode(0);
    }

    PetscErrorCode multiply(Vec in, Vec out) {
        const PetscScalar* x = nullptr;
        PetscScalar* y = nullptr;
        PetscCall(VecGetArrayRead(in, &x));
        PetscCall(VecGetArrayWrite(out, &y));
        parallel_for(threads, blocks.node_count(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t node = begin; node < end; ++node) {
                const auto first = std::size_t(blocks.starts[node]), last = std::size_t(blocks.starts[node + 1]);
                const std::size_t width = 3 * (last - first);
                const double* row = blocks.values.data() + 9 * first;
                double sums[3] = {0, 0, 0};
                for (std::size_t k = first; k < last; ++k, row += 3) {
                    const double* u = x + 3 * std::size_t(blocks.neighbours[k]);
                    for (std::size_t r = 0; r < 3; ++r)
                        sums[r] += row[r * width] * u[0] + row[r * width + 1] * u[1] + row[r * width + 2] * u[2];
                }
                for (std::size_t r = 0; r < 3; ++r) y[3 * node + r] = sums[r];
            }
        });
        PetscCall(VecRestoreArrayRead(in, &x));
        PetscCall(VecRestoreArrayWrite(out, &y));
        return PetscErrorCode(0);
    }

    static constexpr const char* owner = "featuremesh_system";

    RoundedBlocks rounded_;
    std::vector<PetscInt> starts_, columns_;
    ProductsByBlocks products_{blocks, threads};
};

void name_rigid_motions(const System& system, std::span<const Vec3> points) {
    Vector places;
    check(VecCreateSeq(PETSC_COMM_SELF, system.size(), places.fresh()));
    check(VecSetBlockSize(places, 3));
    PetscScalar* values = nullptr;
    check(VecGetArrayWrite(places, &values));
    for (std::size_t node = 0; node < points.size(); ++node)
        for (int c = 0; c < 3; ++c) values[3 * node + std::size_t(c)] = points[node][c];
    check(VecRestoreArrayWrite(places, &values));
    MatNullSpace motions = nullptr;
    check(MatNullSpaceCreateRigidBody(places, &motions));
    const PetscErrorCode code = MatSetNearNullSpace(system.rounded, motions);
    MatNullSpaceDestroy(&motions);
    check(code);
}

/// From the coarse level to the fine one: means of parents, nothing where components are held.
struct Interpolation {
    std::vector<PetscInt> starts, columns;
    std::vector<double> values;
    Matrix matrix;

    void take(const CoarseLevel& level, PetscInt width) {
        matrix.reset();
        starts.assign(1, 0);
        columns.clear(), values.clear();
        for (std::size_t node = 0; node < level.parents.size(); ++node)
            for (std::size_t c = 0; c < 3; ++c) {
                if (!level.is_held[3 * node + c]) add_row(level, level.parents[node], c);
                starts.push_back(PetscInt(columns.size()));
            }
        check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, PetscInt(starts.size() - 1), width, starts.data(),
                                        columns.data(), values.data(), matrix.fresh()));
    }

  private:
    void add_row(const CoarseLevel& level, std::array<std::int32_t, 2> parents, std::size_t component) {
        std::sort(parents.begin(), parents.end());
        const bool is_corner = parents[0] == parents[1];
        for (std::size_t i = is_corner ? 1 : 0; i < 2; ++i) {
            const auto column = 3 * std::size_t(parents[i]) + component;
            if (level.is_held[column]) continue;
            columns.push_back(PetscInt(column));
            values.push_back(is_corner ? 1 : 0.5);
        }
    }
};

/// The preconditioner of an earlier matrix under a later one of which most nodes are the same. With n the new nodes and
/// k the kept ones it is [I -K_kn K_nn^-1; 0 I]^T diag(B_kk, K_nn^-1) [..]: exact where B_kk, the earlier one's part of
/// the kept nodes, is the inverse of K_kk - K_kn K_nn^-1 K_nk.
class Carried {
  public:
    void set_up(const System& system, std::vector<std::int32_t> origin, PetscInt old_size) {
        system_ = &system;
        origin_ = std::move(origin);
        std::vector<std::int32_t> fresh;
        for (std::size_t node = 0; node < origin_.size(); ++node)
            if (origin_[node] < 0) fresh.push_back(std::int32_t(node));
        new_.take(system.blocks, std::move(fresh));
        check(VecCreateSeq(PETSC_COMM_SELF, old_size, old_in_.fresh()));
        check(VecDuplicate(old_in_, old_out_.fresh()));
        if (!new_.nodes.empty()) factor_new_block();
    }

    void apply(PC earlier, Vec in, Vec out) {
        const PetscScalar* r = nullptr;
        PetscScalar* y = nullptr;
        check(VecGetArrayRead(in, &r));
        check(VecGetArrayWrite(out, &y));
        std::vector<double> at_new(new_.size()), push(3 * origin_.size(), 0.0);
        for (std::size_t i = 0; i < at_new.size(); ++i) at_new[i] = r[new_.at(i)];
        solve_new(at_new);
        couple([&](std::size_t row, std::size_t column, double value) { push[column] += value * at_new[row]; });
        apply_earlier(earlier, r, push, y);
        std::vector<double> pull(at_new.size(), 0.0);
        couple([&](std::size_t row, std::size_t column, double value) { pull[row] += value * y[column]; });
        solve_new(pull);
        for (std::size_t i = 0; i < at_new.size(); ++i) y[new_.at(i)] = at_new[i] - pull[i];
        check(VecRestoreArrayRead(in, &r));
        check(VecRestoreArrayWrite(out, &y));
    }

  private:
    /// Visits the entries between new rows and kept columns.
    template <class Visit>
    void couple(Visit visit) const {
        const BlockMatrix& blocks = system_->blocks;
        for (std::size_t i = 0; i < new_.nodes.size(); ++i) {
            const auto node = std::size_t(new_.nodes[i]);
            const auto begin = std::size_t(blocks.starts[node]), end = std::size_t(blocks.starts[node + 1]);
            for (std::size_t k = begin; k < end; ++k) {
                const auto other = std::size_t(blocks.neighbours[k]);
                if (origin_[other] < 0) continue;
                for (std::size_t r = 0; r < 3; ++r)
                    for (std::size_t c = 0; c < 3; ++c)
                        visit(3 * i + r, 3 * other + c,
                              blocks.values[9 * begin + r * 3 * (end - begin) + 3 * (k - begin) + c]);
            }
        }
    }

    void factor_new_block() {
        check(PCCreate(PETSC_COMM_SELF, factor_.fresh()));
        check(PCSetOperators(factor_, new_.matrix, new_.matrix));
        check(PCSetType(factor_, PCCHOLESKY));
        check(PCFactorSetMatOrderingType(factor_, MATORDERINGND));
        check(PCSetUp(factor_));
        check(VecCreateSeq(PETSC_COMM_SELF, PetscInt(new_.size()), new_in_.fresh()));
        check(VecDuplicate(new_in_, new_out_.fresh()));
    }

    void solve_new(std::vector<double>& values) {
        if (values.empty()) return;
        PetscScalar* in = nullptr;
        const PetscScalar* out = nullptr;
        check(VecGetArrayWrite(new_in_, &in));
        std::copy(values.begin(), values.end(), in);
        check(VecRestoreArrayWrite(new_in_, &in));
        check(PCApply(factor_, new_in_, new_out_));
        check(VecGetArrayRead(new_out_, &out));
        std::copy(out, out + values.size(), values.begin());
        check(VecRestoreArrayRead(new_out_, &out));
    }

    void apply_earlier(PC earlier, const PetscScalar* r, const std::vector<double>& push, PetscScalar* y) {
        PetscScalar* in = nullptr;
        const PetscScalar* out = nullptr;
        check(VecSet(old_in_, 0));
        check(VecGetArray(old_in_, &in));
        for (std::size_t node = 0; node < origin_.size(); ++node)
            if (origin_[node] >= 0)
                for (std::size_t c = 0; c < 3; ++c)
                    in[3 * std::size_t(origin_[node]) + c] = r[3 * node + c] - push[3 * node + c];
        check(VecRestoreArray(old_in_, &in));
        check(PCApply(earlier, old_in_, old_out_));
        check(VecGetArrayRead(old_out_, &out));
        for (std::size_t node = 0; node < origin_.size(); ++node)
            if (origin_[node] >= 0)
                for (std::size_t c = 0; c < 3; ++c) y[3 * node + c] = out[3 * std::size_t(origin_[node]) + c];
        check(VecRestoreArrayRead(old_out_, &out));
    }

    const System* system_ = nullptr;
    std::vector<std::int32_t> origin_;
    NodesBlock new_;
    Preconditioner factor_;
    Vector new_in_, new_out_, old_in_, old_out_;
};

/// When conjugate gradients stop.
struct Stop {
    double target;
    int most_iterations;
    const RunContext* context;
    bool is_cancelled = false;
};

PetscErrorCode look_whether_to_stop(KSP, PetscInt iteration, PetscReal norm, KSPConvergedReason* reason, void* data) {
    Stop& stop = *static_cast<Stop*>(data);
    *reason = KSP_CONVERGED_ITERATING;
    if (PetscIsInfOrNanReal(norm))
        *reason = KSP_DIVERGED_NANORINF;
    else if (norm <= stop.target)
        *reason = KSP_CONVERGED_ATOL;
    else if (iteration >= stop.most_iterations)
        *reason = KSP_DIVERGED_ITS;
    try {
        stop.context->check_cancelled();
    } catch (const Cancelled&) {
        stop.is_cancelled = true;
        *reason = KSP_DIVERGED_ITS;
    }
    return PetscErrorCode(0);
}

class PetscSolver final : public LinearSolver {
  public:
    PetscSolver() { start_petsc(); }

    void set_up(BlockMatrix matrix, std::span<const Vec3> points, std::optional<CoarseLevel> coarse) override {
        present_.take({});
        multigrid_.reset();
        forget_known();
        factor_.reset();
        is_carried_ = false;
        has_coarse_ = coarse.has_value();
        earlier_.take(std::move(matrix));
        check(PCCreate(PETSC_COMM_SELF, multigrid_.fresh()));
        if (coarse) {
            earlier_.round_products();
            linear_.take(std::move(coarse->matrix));
            linear_.round_products_of_entries();
            name_rigid_motions(linear_, points.first(linear_.blocks.node_count()));
            interpolation_.take(*coarse, linear_.size());
            go_by_way_of_linear_displacements();
        } else {
            earlier_.round_products_of_entries();
            name_rigid_motions(earlier_, points);
            use_aggregation(multigrid_, earlier_);
        }
        check(PCSetUp(multigrid_));
    }

    bool factor() override {
        forget_known();
        if (!factor_.set_up(has_coarse_ ? linear_.rounded : earlier_.rounded, most_factor_work)) return false;
        if (!has_coarse_) {
            factor_.serve(multigrid_);
            return true;
        }
        KSP coarse = nullptr;
        PC aggregation = nullptr;
        check(PCMGGetCoarseSolve(multigrid_, &coarse));
        check(KSPGetPC(coarse, &aggregation));
        factor_.serve(aggregation);
        return true;
    }

    void carry_over(BlockMatrix matrix, std::vector<std::int32_t> origin) override {
        present_.take(std::move(matrix));
        forget_known();
        carried_.set_up(present_, std::move(origin), earlier_.size());
        is_carried_ = true;
    }

    const BlockMatrix& matrix() const override { return system().blocks; }

    void use_threads(int threads) override {
        earlier_.threads.threads = present_.threads.threads = linear_.threads.threads = threads;
    }

    void balance_within(std::span<const std::int32_t> nodes, std::span<const double> forces,
                        std::span<double> displacements) override {
        if (nodes.empty()) return;
        NodesBlock block;
        block.take(system().blocks, {nodes.begin(), nodes.end()});
        Vector all, resisting, b, x;
        fill(all, displacements);
        check(VecDuplicate(all, resisting.fresh()));
        check(MatMult(system().exact, all, resisting));
        check(VecCreateSeq(PETSC_COMM_SELF, PetscInt(block.size()), b.fresh()));
        check(VecDuplicate(b, x.fresh()));
        const PetscScalar* values = nullptr;
        PetscScalar* to = nullptr;
        check(VecGetArrayRead(resisting, &values));
        check(VecGetArrayWrite(b, &to));
        for (std::size_t i = 0; i < block.size(); ++i) to[i] = forces[block.at(i)] - values[block.at(i)];
        check(VecRestoreArrayWrite(b, &to));
        check(VecRestoreArrayRead(resisting, &values));
        solve_roughly(block.matrix, b, x);
        check(VecGetArrayRead(x, &values));
        for (std::size_t i = 0; i < block.size(); ++i) displacements[block.at(i)] += values[i];
        check(VecRestoreArrayRead(x, &values));
    }

    double energy_norm(std::span<const double> residual) override {
        Vector r, z;
        fill(r, residual);
        check(VecDuplicate(r, z.fresh()));
        precondition(r, z);
        swap(known_in_, r), swap(known_out_, z);
        PetscScalar product = 0;
        check(VecDot(known_in_, known_out_, &product));
        if (!std::isfinite(double(product))) throw KernelError(say<Code::petsc_out_of_range>());
        return std::sqrt(std::max(0.0, double(product)));
    }

    int solve(std::span<const double> residual, std::span<double> solution, double target, int most_iterations,
              const RunContext& context) override {
        Vector b, x;
        fill(b, residual);
        check(VecDuplicate(b, x.fresh()));
        Owned<KSP, KSPDestroy> cg;
        Preconditioner shell;
        Stop stop{target, most_iterations, &context};
        make_shell(shell);
        check(KSPCreate(PETSC_COMM_SELF, cg.fresh()));
        check(KSPSetType(cg, KSPCG));
        check(KSPSetNormType(cg, KSP_NORM_NATURAL));
        check(KSPSetPC(cg, shell));
        check(KSPSetOperators(cg, system().exact, system().exact));
        check(KSPSetConvergenceTest(cg, look_whether_to_stop, &stop, nullptr));
        check(KSPSolve(cg, b, x));
        if (stop.is_cancelled) throw Cancelled();
        KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
        check(KSPGetConvergedReason(cg, &reason));
        if (reason == KSP_DIVERGED_NANORINF) throw KernelError(say<Code::petsc_out_of_range>());
        const PetscScalar* values = nullptr;
        check(VecGetArrayRead(x, &values));
        for (std::size_t i = 0; i < solution.size(); ++i) solution[i] += values[i];
        check(VecRestoreArrayRead(x, &values));
        PetscInt iterations = 0;
        check(KSPGetIterationNumber(cg, &iterations));
        return reason > 0 ? int(iterations) : -1;
    }

  private:
    /// As far as a start needs it, by conjugate gradients with the diagonal blocks.
    static void solve_roughly(Mat matrix, Vec in, Vec out) {
        constexpr double least_share = 1e-5;
        constexpr PetscInt most = 300;
        Owned<KSP, KSPDestroy> cg;
        PC diagonal = nullptr;
        check(KSPCreate(PETSC_COMM_SELF, cg.fresh()));
        check(KSPSetType(cg, KSPCG));
        check(KSPSetNormType(cg, KSP_NORM_NATURAL));
        check(KSPSetOperators(cg, matrix, matrix));
        check(KSPGetPC(cg, &diagonal));
        check(PCSetType(diagonal, PCPBJACOBI));
        check(KSPSetTolerances(cg, least_share, 0, PETSC_DEFAULT, most));
        check(KSPSolve(cg, in, out));
    }

    static void use_aggregation(PC preconditioner, const System& system) {
        check(PCSetOptionsPrefix(preconditioner, prefix));
        check(PCSetType(preconditioner, PCGAMG));
        check(PCSetOperators(preconditioner, system.rounded, system.rounded));
        check(PCSetFromOptions(preconditioner));
    }

    /// Smooths quadratic displacements, and leaves the rest to the aggregation of the linear ones.
    void go_by_way_of_linear_displacements() {
        check(PCSetOptionsPrefix(multigrid_, quadratic_prefix));
        check(PCSetType(multigrid_, PCMG));
        check(PCSetOperators(multigrid_, earlier_.rounded, earlier_.rounded));
        check(PCMGSetLevels(multigrid_, 2, nullptr));
        check(PCMGSetInterpolation(multigrid_, 1, interpolation_.matrix));
        KSP coarse = nullptr;
        PC aggregation = nullptr;
        check(PCMGGetCoarseSolve(multigrid_, &coarse));
        check(KSPSetType(coarse, KSPPREONLY));
        check(KSPSetOperators(coarse, linear_.rounded, linear_.rounded));
        check(KSPGetPC(coarse, &aggregation));
        use_aggregation(aggregation, linear_);
        check(PCSetFromOptions(multigrid_));
    }

    const System& system() const { return is_carried_ ? present_ : earlier_; }

    void precondition(Vec in, Vec out) {
        if (is_known(in))
            check(VecCopy(known_out_, out));
        else if (is_carried_)
            carried_.apply(multigrid_, in, out);
        else
            check(PCApply(multigrid_, in, out));
    }

    /// Conjugate gradients begin with the residual whose norm was asked for last.
    bool is_known(Vec in) const {
        PetscBool is_same = PETSC_FALSE;
        if (known_in_) check(VecEqual(known_in_, in, &is_same));
        return is_same;
    }

    void forget_known() { known_in_.reset(), known_out_.reset(); }

    void make_shell(Preconditioner& shell) {
        check(PCCreate(PETSC_COMM_SELF, shell.fresh()));
        check(PCSetType(shell, PCSHELL));
        check(PCShellSetContext(shell, this));
        check(PCShellSetApply(shell, [](PC pc, Vec in, Vec out) -> PetscErrorCode {
            void* self = nullptr;
            PCShellGetContext(pc, &self);
            try {
                static_cast<PetscSolver*>(self)->precondition(in, out);
            } catch (const Error&) {  // C code lies between here and the caller
                return PetscErrorCode(PETSC_ERR_LIB);
            }
            return PetscErrorCode(0);
        }));
    }

    void fill(Vector& vector, std::span<const double> values) {
        check(VecCreateSeq(PETSC_COMM_SELF, system().size(), vector.fresh()));
        PetscScalar* to = nullptr;
        check(VecGetArrayWrite(vector, &to));
        std::copy(values.begin(), values.end(), to);
        check(VecRestoreArrayWrite(vector, &to));
    }

    System earlier_, present_;  // that of the last set-up, and the one carried over to
    System linear_;             // of 10-node tets' corners, at the last set-up
    Interpolation interpolation_;
    Preconditioner multigrid_;
    Factor factor_;
    Carried carried_;
    Vector known_in_, known_out_;  // what was preconditioned for its norm, and what came out
    bool is_carried_ = false, has_coarse_ = false;
};

}  // namespace

}  // namespace featuremesh

extern "C" featuremesh::LinearSolver* featuremesh_make_petsc_solver() { return new featuremesh::PetscSolver; }

// SPDX-License-Identifier: GPL-3.0-or-later
// The level of quadratic displacements above one of linear ones.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "statics/coarse_level.h"
#include "statics/petsc_aggregation.h"
#include "statics/petsc_nodes_block.h"
#include "statics/petsc_objects.h"
#include "statics/petsc_system.h"
#include "statics/stiffness.h"

namespace featuremesh {

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

/// The same numbers each time, none of which stands out.
inline void fill_with_noise(Vec vector) {
    std::minstd_rand random;
    PetscInt size = 0;
    PetscScalar* values = nullptr;
    check(VecGetLocalSize(vector, &size));
    check(VecGetArrayWrite(vector, &values));
    for (PetscInt i = 0; i < size; ++i) values[i] = double(random()) / double(std::minstd_rand::max()) - 0.5;
    check(VecRestoreArrayWrite(vector, &values));
}

/// About the largest eigenvalue of a matrix in terms of its nodes' own blocks, from below: that of ten steps of
/// Lanczos.
inline double largest_eigenvalue(Mat matrix) {
    constexpr PetscInt steps = 10;
    Owned<KSP, KSPDestroy> lanczos;
    PC diagonal = nullptr;
    Vector in, out;
    check(KSPCreate(PETSC_COMM_SELF, lanczos.fresh()));
    check(KSPSetType(lanczos, KSPCG));
    check(KSPSetNormType(lanczos, KSP_NORM_NONE));
    check(KSPSetComputeEigenvalues(lanczos, PETSC_TRUE));
    check(KSPSetTolerances(lanczos, 0, 0, PETSC_DEFAULT, steps));
    check(KSPSetOperators(lanczos, matrix, matrix));
    check(KSPGetPC(lanczos, &diagonal));
    check(PCSetType(diagonal, PCPBJACOBI));
    check(MatCreateVecs(matrix, out.fresh(), in.fresh()));
    fill_with_noise(in);
    check(KSPSolve(lanczos, in, out));
    PetscInt done = 0, found = 0;
    std::array<PetscReal, steps> values{}, imaginary{};
    check(KSPGetIterationNumber(lanczos, &done));
    check(KSPComputeEigenvalues(lanczos, std::min(done, steps), values.data(), imaginary.data(), &found));
    return *std::max_element(values.begin(), values.end());
}

/// Smooths quadratic displacements, and leaves the rest to the aggregation of the linear ones.
class QuadraticLevel {
  public:
    void set_up(BlockMatrix matrix, const CoarseLevel& level, Aggregation& below) {
        reset();
        system_.take(std::move(matrix));
        system_.round_products();
        find_largest_eigenvalue();
        interpolation_.take(level, below.system().size());
        check(MatCreateVecs(interpolation_.matrix, moved_.fresh(), left_.fresh()));
        check(VecDuplicate(moved_, forces_.fresh()));
        solve_coarse_by(below);
        smooth();
    }

    /// Hands the matrix out, to be changed to the next one.
    BlockMatrix give_matrix() {
        smoother_.reset(), coarse_.reset();
        return system_.give();
    }

    void reset() {
        smoother_.reset(), coarse_.reset();
        system_.take({});
    }

    void abandon() { smoother_.abandon(), coarse_.abandon(); }

    void apply(Vec in, Vec out) {
        begin(in, out);
        end(in, out);
    }

    /// All of it but the last smoothing. Returns the product of what comes in and what will come out, which is known
    /// by then: with S the smoothing, C the coarse correction and r' what S leaves of r it is Sr (r + r') + r' C r'.
    double begin(Vec in, Vec out) {
        check(VecSet(out, 0));
        check(KSPSolve(smoother_, in, out));
        check(MatMult(system_.rounded, out, left_));
        check(VecAYPX(left_, -1, in));
        solve_coarse(left_);
        PetscScalar before = 0, after = 0, coarse = 0;
        check(VecDot(out, in, &before));
        check(VecDot(out, left_, &after));
        check(VecDot(forces_, moved_, &coarse));
        check(MatMultAdd(interpolation_.matrix, moved_, out, out));
        return before + after + coarse;
    }

    void end(Vec in, Vec out) { check(KSPSolve(smoother_, in, out)); }

    /// By the coarse level alone.
    void correct(Vec in, Vec out) {
        solve_coarse(in);
        check(MatMult(interpolation_.matrix, moved_, out));
    }

    const System& system() const { return system_; }

    void use_threads(int threads) { system_.threads.threads = threads; }

  private:
    void solve_coarse(Vec in) {
        check(MatMultTranspose(interpolation_.matrix, in, forces_));
        check(VecSet(moved_, 0));
        check(KSPSolve(coarse_, forces_, moved_));
    }

    /// A few iterations there cost little beside one of quadratic displacements, and save nearly half of those.
    void solve_coarse_by(Aggregation& below) {
        constexpr double least_share = 0.01;  // a factor comes to it at once
        constexpr PetscInt most = 3;
        constexpr double never = 1e300;  // is it given up: what is out of balance may grow while the error falls
        PC aggregation = nullptr;
        check(KSPCreate(PETSC_COMM_SELF, coarse_.fresh()));
        check(KSPSetType(coarse_, KSPCG));
        check(KSPSetNormType(coarse_, KSP_NORM_UNPRECONDITIONED));
        check(KSPSetTolerances(coarse_, least_share, 0, never, most));
        check(KSPSetOperators(coarse_, below.system().exact, below.system().exact));
        check(KSPGetPC(coarse_, &aggregation));
        use_shell(aggregation, below);
    }

    /// Of the matrix in terms of its nodes' own blocks. Where most rows are those of the last matrix, what is larger
    /// now belongs to a motion at the new ones, so only these and their neighbours are looked at.
    void find_largest_eigenvalue() {
        const BlockMatrix& blocks = system_.blocks;
        if (blocks.blocks_before == 0) {
            largest_eigenvalue_ = largest_eigenvalue(system_.rounded);
            return;
        }
        NodesBlock changed;
        changed.take(blocks, nodes_by_new_rows(blocks));
        if (changed.size() > 0) largest_eigenvalue_ = std::max(largest_eigenvalue_, largest_eigenvalue(changed.matrix));
    }

    static std::vector<std::int32_t> nodes_by_new_rows(const BlockMatrix& blocks) {
        std::vector<char> is_by(blocks.node_count(), 0);
        for (std::size_t node = 0; node < blocks.node_count(); ++node)
            if (blocks.begin(node) >= blocks.blocks_before)
                for (std::size_t k = blocks.begin(node); k < blocks.end(node); ++k)
                    is_by[std::size_t(blocks.neighbours[k])] = 1;
        std::vector<std::int32_t> nodes;
        for (std::size_t node = 0; node < is_by.size(); ++node)
            if (is_by[node]) nodes.push_back(std::int32_t(node));
        return nodes;
    }

    /// Chebyshev's polynomials serve from a tenth of the largest eigenvalue to a tenth beyond what was found of it.
    void smooth() {
        constexpr double from = 0.1, to = 1.1;
        constexpr PetscInt steps = 2;
        PC diagonal = nullptr;
        check(KSPCreate(PETSC_COMM_SELF, smoother_.fresh()));
        check(KSPSetType(smoother_, KSPCHEBYSHEV));
        check(KSPSetNormType(smoother_, KSP_NORM_NONE));
        check(KSPSetInitialGuessNonzero(smoother_, PETSC_TRUE));
        check(KSPSetTolerances(smoother_, 0, 0, PETSC_DEFAULT, steps));
        check(KSPChebyshevSetEigenvalues(smoother_, to * largest_eigenvalue_, from * largest_eigenvalue_));
        check(KSPSetOperators(smoother_, system_.rounded, system_.rounded));
        check(KSPGetPC(smoother_, &diagonal));
        check(PCSetType(diagonal, PCPBJACOBI));
    }

    System system_;
    Interpolation interpolation_;
    double largest_eigenvalue_ = 0;
    Owned<KSP, KSPDestroy> smoother_, coarse_;
    Vector left_, forces_, moved_;  // out of balance after smoothing, the same of the coarse level, its correction
};

}  // namespace featuremesh

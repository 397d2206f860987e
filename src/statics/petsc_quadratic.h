// SPDX-License-Identifier: GPL-3.0-or-later
// The level of quadratic displacements above one of linear ones.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "statics/coarse_level.h"
#include "statics/petsc_aggregation.h"
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

/// Smooths quadratic displacements, and leaves the rest to the aggregation of the linear ones.
class QuadraticLevel {
  public:
    static constexpr const char* prefix = "featuremesh_quadratic_";  // of its options

    void set_up(BlockMatrix matrix, const CoarseLevel& level, Aggregation& below) {
        multigrid_.reset();
        system_.take(std::move(matrix));
        system_.round_products();
        interpolation_.take(level, below.system().size());
        check(PCCreate(PETSC_COMM_SELF, multigrid_.fresh()));
        check(PCSetOptionsPrefix(multigrid_, prefix));
        check(PCSetType(multigrid_, PCMG));
        check(PCSetOperators(multigrid_, system_.rounded, system_.rounded));
        check(PCMGSetLevels(multigrid_, 2, nullptr));
        check(PCMGSetInterpolation(multigrid_, 1, interpolation_.matrix));
        solve_coarse_by(below);
        check(PCSetFromOptions(multigrid_));
        check(PCSetUp(multigrid_));
    }

    void reset() {
        multigrid_.reset();
        system_.take({});
    }

    void abandon() { multigrid_.abandon(); }

    void apply(Vec in, Vec out) { check(PCApply(multigrid_, in, out)); }

    const System& system() const { return system_; }

    void use_threads(int threads) { system_.threads.threads = threads; }

  private:
    /// A few iterations there cost little beside one of quadratic displacements, and save nearly half of those.
    void solve_coarse_by(Aggregation& below) {
        constexpr double least_share = 0.1;
        constexpr PetscInt most = 3;
        KSP coarse = nullptr;
        PC aggregation = nullptr;
        check(PCMGGetCoarseSolve(multigrid_, &coarse));
        check(KSPSetType(coarse, KSPCG));
        check(KSPSetNormType(coarse, KSP_NORM_NATURAL));
        check(KSPSetTolerances(coarse, least_share, 0, PETSC_DEFAULT, most));
        check(KSPSetOperators(coarse, below.system().exact, below.system().exact));
        check(KSPGetPC(coarse, &aggregation));
        use_shell(aggregation, below);
    }

    System system_;
    Interpolation interpolation_;
    Preconditioner multigrid_;
};

}  // namespace featuremesh

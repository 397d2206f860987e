// SPDX-License-Identifier: GPL-3.0-or-later
// A sparse Cholesky factor as a preconditioner.
#pragma once

#include "statics/petsc_objects.h"

namespace featuremesh {

/// A matrix's Cholesky factor as a preconditioner: exact, and soon found where the part is thin. It is not made where
/// it takes more than `most_work`.
class Factor {
  public:
    /// Returns whether the matrix was factored.
    bool set_up(Mat matrix) { return set_up(matrix, MATSOLVERPETSC, MATORDERINGND); }

    /// The same by CHOLMOD, which makes larger factors in a third of the time. False where PETSc comes without.
    bool set_up_large(Mat matrix) {
        constexpr double least_fill = 4;  // of quadratic displacements on a part that is one tet thick
        PetscBool is_there = PETSC_FALSE;
        check(MatGetFactorAvailable(matrix, MATSOLVERCHOLMOD, MAT_FACTOR_CHOLESKY, &is_there));
        return is_there && !is_too_much(least_fill * entries(matrix) / 2, matrix) &&
               set_up(matrix, MATSOLVERCHOLMOD, MATORDERINGEXTERNAL);
    }

    void apply(Vec in, Vec out) { check(MatSolve(factor_, in, out)); }

    void reset() { factor_.reset(); }
    friend void swap(Factor& a, Factor& b) { swap(a.factor_, b.factor_); }

  private:
    static constexpr double most_work = 2e10;  // multiplications, about 20 s

    bool set_up(Mat matrix, MatSolverType by, MatOrderingType ordering) {
        Owned<IS, ISDestroy> order, same;
        MatFactorInfo info;
        check(MatGetFactor(matrix, by, MAT_FACTOR_CHOLESKY, factor_.fresh()));
        check(MatGetOrdering(matrix, ordering, order.fresh(), same.fresh()));
        check(MatFactorInfoInitialize(&info));
        info.fill = 5;
        check(MatCholeskyFactorSymbolic(factor_, matrix, order, &info));
        const bool is_made = !is_too_much(entries(factor_), matrix) && fill(matrix, info);
        if (!is_made) factor_.reset();
        return is_made;
    }

    /// Not where rounding has taken the matrix's definiteness.
    bool fill(Mat matrix, const MatFactorInfo& info) {
        MatFactorError error = MAT_FACTOR_NOERROR;
        const PetscErrorCode code = MatCholeskyFactorNumeric(factor_, matrix, &info);
        if (code == PETSC_ERR_MAT_CH_ZRPVT) return false;
        check(code);
        check(MatFactorGetError(factor_, &error));
        return error == MAT_FACTOR_NOERROR;
    }

    static double entries(Mat matrix) {
        MatInfo found;
        check(MatGetInfo(matrix, MAT_LOCAL, &found));
        return found.nz_used;
    }

    /// Is a factor of so many entries?
    static bool is_too_much(double entries, Mat matrix) {
        PetscInt size = 0;
        check(MatGetSize(matrix, &size, nullptr));
        return entries * entries > most_work * size;
    }

    Matrix factor_;
};

}  // namespace featuremesh

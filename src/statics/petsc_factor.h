// SPDX-License-Identifier: GPL-3.0-or-later
// A sparse Cholesky factor as a preconditioner.
#pragma once

#include "statics/petsc_objects.h"

namespace featuremesh {

/// A matrix's Cholesky factor as a preconditioner: exact, and soon found where the part is thin.
class Factor {
  public:
    /// Returns whether the matrix was factored: not where that takes more than about `most_work` multiplications.
    bool set_up(Mat matrix, double most_work) {
        Owned<IS, ISDestroy> order, same;
        MatFactorInfo info;
        MatInfo found;
        PetscInt size = 0;
        check(MatGetSize(matrix, &size, nullptr));
        check(MatGetFactor(matrix, MATSOLVERPETSC, MAT_FACTOR_CHOLESKY, factor_.fresh()));
        check(MatGetOrdering(matrix, MATORDERINGND, order.fresh(), same.fresh()));
        check(MatFactorInfoInitialize(&info));
        info.fill = 5;
        check(MatCholeskyFactorSymbolic(factor_, matrix, order, &info));
        check(MatGetInfo(factor_, MAT_LOCAL, &found));
        if (found.nz_used * found.nz_used > most_work * size) {
            factor_.reset();
            return false;
        }
        check(MatCholeskyFactorNumeric(factor_, matrix, &info));
        return true;
    }

    void apply(Vec in, Vec out) { check(MatSolve(factor_, in, out)); }

    void reset() { factor_.reset(); }

  private:
    Matrix factor_;
};

}  // namespace featuremesh

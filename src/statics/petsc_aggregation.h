// SPDX-License-Identifier: GPL-3.0-or-later
// The multigrid by smoothed aggregation of a stiffness matrix, which serves later matrices, too.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/geometry.h"
#include "statics/petsc_carried.h"
#include "statics/petsc_factor.h"
#include "statics/petsc_objects.h"
#include "statics/petsc_system.h"
#include "statics/petsc_transfers.h"
#include "statics/stiffness.h"

namespace featuremesh {

/// Of linear displacements: three numbers a node, which know the rigid motions.
class Aggregation {
  public:
    static constexpr const char* prefix = "featuremesh_";  // of its options

    void set_up(BlockMatrix matrix, std::span<const Vec3> points) {
        take(std::move(matrix));
        earlier_.round_products_of_entries();
        name_rigid_motions(earlier_, points);
        check(PCCreate(PETSC_COMM_SELF, multigrid_.fresh()));
        check(PCSetOptionsPrefix(multigrid_, prefix));
        check(PCSetType(multigrid_, PCGAMG));
        check(PCSetOperators(multigrid_, earlier_.rounded, earlier_.rounded));
        check(PCSetFromOptions(multigrid_));
        check(PCSetUp(multigrid_));
        transfers_.serve(multigrid_, earlier_.threads);
    }

    /// Puts the matrix's Cholesky factor in place of the aggregation. Returns false and changes nothing where that
    /// takes too much work.
    bool factor() {
        if (!factor_.set_up(earlier_.rounded)) return false;
        use_shell(multigrid_, factor_);
        return true;
    }

    /// Takes another matrix, and its factor in place of an aggregation.
    void set_up_factored(BlockMatrix matrix, Factor& factor) {
        take(std::move(matrix));
        swap(factor_, factor);
        check(PCCreate(PETSC_COMM_SELF, multigrid_.fresh()));
        check(PCSetOperators(multigrid_, earlier_.exact, earlier_.exact));
        use_shell(multigrid_, factor_);
    }

    /// Serves another matrix from now on; `origin` is by node that at the last set-up, -1 for new ones.
    void carry_over(BlockMatrix matrix, std::vector<std::int32_t> origin) {
        present_.take(std::move(matrix));
        carried_.set_up(present_, std::move(origin), earlier_.size());
        is_carried_ = true;
    }

    /// Hands the matrix out, to be changed to that which this is carried over to.
    BlockMatrix give_matrix() { return is_carried_ ? present_.give() : earlier_.give_but_rounded(); }

    void abandon() { multigrid_.abandon(); }

    void apply(Vec in, Vec out) {
        if (is_carried_)
            carried_.apply(multigrid_, in, out);
        else
            check(PCApply(multigrid_, in, out));
    }

    const System& system() const { return is_carried_ ? present_ : earlier_; }

    void use_threads(int threads) { earlier_.threads.threads = present_.threads.threads = threads; }

  private:
    void take(BlockMatrix matrix) {
        present_.take({});
        multigrid_.reset();
        transfers_.reset();
        factor_.reset();
        is_carried_ = false;
        earlier_.take(std::move(matrix));
    }

    System earlier_, present_;  // that of the last set-up, and the one carried over to
    Transfers transfers_;
    Preconditioner multigrid_;
    Factor factor_;
    Carried carried_;
    bool is_carried_ = false;
};

}  // namespace featuremesh

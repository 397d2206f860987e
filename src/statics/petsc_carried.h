// SPDX-License-Identifier: GPL-3.0-or-later
// A preconditioner of an earlier matrix under a later one.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "statics/petsc_nodes_block.h"
#include "statics/petsc_objects.h"
#include "statics/petsc_system.h"
#include "statics/stiffness.h"

namespace featuremesh {

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
        for (std::size_t i = 0; i < at_new.size(); ++i) at_new[i] = r[component(new_.nodes, i)];
        solve_new(at_new);
        couple([&](std::size_t row, std::size_t column, double value) { push[column] += value * at_new[row]; });
        apply_earlier(earlier, r, push, y);
        std::vector<double> pull(at_new.size(), 0.0);
        couple([&](std::size_t row, std::size_t column, double value) { pull[row] += value * y[column]; });
        solve_new(pull);
        for (std::size_t i = 0; i < at_new.size(); ++i) y[component(new_.nodes, i)] = at_new[i] - pull[i];
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
            for (std::size_t k = blocks.begin(node); k < blocks.end(node); ++k) {
                const auto other = std::size_t(blocks.neighbours[k]);
                if (origin_[other] < 0) continue;
                for (std::size_t r = 0; r < 3; ++r)
                    for (std::size_t c = 0; c < 3; ++c)
                        visit(3 * i + r, 3 * other + c,
                              blocks.values[blocks.place(node, k) + r * blocks.width(node) + c]);
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

}  // namespace featuremesh

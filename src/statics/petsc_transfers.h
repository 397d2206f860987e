// SPDX-License-Identifier: GPL-3.0-or-later
// The ways up and down between the levels of an aggregation, on all threads.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/run_context.h"
#include "statics/aggregate_products.h"
#include "statics/petsc_objects.h"
#include "statics/petsc_products.h"
#include "statics/rounded_blocks.h"

namespace featuremesh {

/// P, from the motions of aggregates to displacements, and its transpose, in single precision.
class Transfer {
  public:
    Transfer(const PetscBlocks& motions, RunContext& threads) : threads_(threads), up_(motions.blocks().pattern) {
        const Blocks blocks = motions.blocks();
        const auto aggregates = std::size_t(motions.width()) / up_.across;
        const NodesOfAggregates has(up_, aggregates);
        down_ = {up_.across, up_.height, has.starts, has.nodes};
        std::vector<double> turned(down_.place(aggregates));
        parallel_for(threads, aggregates, 256, [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row)
                for (std::size_t at = down_.begin(row); at < down_.end(row); ++at) turn(blocks, has, row, at, turned);
        });
        prolongation_ = {up_.height, up_.across, rows_of(up_.starts, up_.columns), blocks.values, threads};
        restriction_ = {down_.height, down_.across, rows_of(down_.starts, down_.columns), turned.data(), threads};
    }

    /// Lets PETSc's P go by this, which has to outlive it.
    void serve(Mat matrix) {
        attach(matrix, name, this);
        check(MatSetOperation(matrix, MATOP_MULT_ADD, (void (*)(void))prolong_and_add));
        check(MatSetOperation(matrix, MATOP_MULT_TRANSPOSE, (void (*)(void))restrict_down));
    }

  private:
    static constexpr const char* name = "featuremesh_transfer";

    void turn(const Blocks& blocks, const NodesOfAggregates& has, std::size_t row, std::size_t at,
              std::vector<double>& turned) const {
        const auto node = std::size_t(has.nodes[at]), block = std::size_t(has.blocks[at]);
        const double* from = blocks.values + up_.place(node, block);
        double* to = turned.data() + down_.place(row, at);
        for (std::size_t r = 0; r < up_.height; ++r)
            for (std::size_t c = 0; c < up_.across; ++c) to[c * down_.width(row) + r] = from[r * up_.width(node) + c];
    }

    static PetscErrorCode prolong_and_add(Mat of, Vec in, Vec more, Vec out) {
        Transfer* self = nullptr;
        const PetscScalar* x = nullptr;
        PetscScalar* y = nullptr;
        PetscCall(find(of, name, self));
        PetscCall(VecGetArrayRead(in, &x));
        PetscCall(guarded([&] { self->prolong(x); }));
        PetscCall(VecRestoreArrayRead(in, &x));
        if (more != out) PetscCall(VecCopy(more, out));
        PetscCall(VecGetArray(out, &y));
        for (std::size_t i = 0; i < self->product_.size(); ++i) y[i] += self->product_[i];
        return VecRestoreArray(out, &y);
    }

    void prolong(const double* x) {
        product_.resize(up_.height * up_.count());
        prolongation_.multiply(x, product_.data(), threads_);
    }

    static PetscErrorCode restrict_down(Mat of, Vec in, Vec out) {
        Transfer* self = nullptr;
        PetscCall(find(of, name, self));
        return multiply_by(self->restriction_, in, out, self->threads_);
    }

    RunContext& threads_;
    BlockPattern up_, down_;
    RoundedBlocks prolongation_, restriction_;
    std::vector<double> product_;
};

/// Those of all levels of a multigrid that is set up.
class Transfers {
  public:
    void serve(PC multigrid, RunContext& threads) {
        PetscInt levels = 0;
        check(PCMGGetLevels(multigrid, &levels));
        for (PetscInt level = 1; level < levels; ++level) {
            Mat motions = nullptr;
            check(PCMGGetInterpolation(multigrid, level, &motions));
            const PetscBlocks blocks(motions, level + 1 == levels ? 3 : 6, 6);
            if (!blocks.is_of_blocks()) continue;
            of_levels_.push_back(std::make_unique<Transfer>(blocks, threads));
            of_levels_.back()->serve(motions);
        }
    }

    void reset() { of_levels_.clear(); }

  private:
    std::vector<std::unique_ptr<Transfer>> of_levels_;
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// The products of an aggregation's set-up by blocks in place of PETSc's own, which go number by number on one thread.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/run_context.h"
#include "statics/aggregate_products.h"
#include "statics/petsc_objects.h"
#include "statics/rounded_blocks.h"
#include "statics/stiffness.h"

namespace featuremesh {

/// A matrix of PETSc's, read by blocks where it is of blocks.
class PetscBlocks {
  public:
    PetscBlocks(Mat matrix, std::size_t height, std::size_t across)
        : matrix_(matrix), pattern_{height, across, {0}, {}} {
        check(MatGetSize(matrix, nullptr, &width_));
        check(MatGetRowIJ(matrix, 0, PETSC_FALSE, PETSC_FALSE, &rows_, &starts_, &columns_, &is_read_));
        check(MatSeqAIJGetArrayRead(matrix, &values_));
        is_of_blocks_ = is_read_ && rows_ % PetscInt(height) == 0 && width_ % PetscInt(across) == 0;
        for (PetscInt row = 0; is_of_blocks_ && row < rows_; row += PetscInt(height)) is_of_blocks_ = take(row);
    }
    PetscBlocks(const PetscBlocks&) = delete;
    PetscBlocks& operator=(const PetscBlocks&) = delete;
    ~PetscBlocks() {
        MatSeqAIJRestoreArrayRead(matrix_, &values_);
        MatRestoreRowIJ(matrix_, 0, PETSC_FALSE, PETSC_FALSE, &rows_, &starts_, &columns_, &is_read_);
    }

    bool is_of_blocks() const { return is_of_blocks_; }
    Blocks blocks() const { return {pattern_, values_}; }
    PetscInt width() const { return width_; }

  private:
    /// Takes one row of blocks. Returns whether it is one.
    bool take(PetscInt row) {
        const auto height = PetscInt(pattern_.height), across = PetscInt(pattern_.across);
        const PetscInt begin = starts_[row], count = starts_[row + 1] - begin;
        if (count % across != 0) return false;
        for (PetscInt r = 0; r < height; ++r)
            if (starts_[row + r + 1] != begin + (r + 1) * count) return false;
        for (PetscInt k = 0; k < height * count; ++k)
            if (columns_[begin + k] != columns_[begin + k % count / across * across] + k % across) return false;
        for (PetscInt k = 0; k < count; k += across) {
            if (columns_[begin + k] % across != 0) return false;
            pattern_.columns.push_back(columns_[begin + k] / across);
        }
        pattern_.starts.push_back(std::int64_t(pattern_.columns.size()));
        return true;
    }

    Mat matrix_;
    PetscInt rows_ = 0, width_ = 0;
    const PetscInt *starts_ = nullptr, *columns_ = nullptr;
    const PetscScalar* values_ = nullptr;
    PetscBool is_read_ = PETSC_FALSE;
    bool is_of_blocks_ = false;
    BlockPattern pattern_;
};

/// PETSc's multigrid begins each cycle with the product of nothing, which costs nothing here.
inline PetscErrorCode multiply_by(const RoundedBlocks& matrix, Vec in, Vec out, RunContext& threads) {
    PetscInt size = 0;
    const PetscScalar* x = nullptr;
    PetscScalar* y = nullptr;
    PetscCall(VecGetLocalSize(in, &size));
    PetscCall(VecGetArrayRead(in, &x));
    if (std::all_of(x, x + size, [](PetscScalar value) { return value == 0; })) {
        PetscCall(VecRestoreArrayRead(in, &x));
        return VecSet(out, 0);
    }
    PetscCall(VecGetArrayWrite(out, &y));
    PetscCall(guarded([&] { matrix.multiply(x, y, threads); }));
    PetscCall(VecRestoreArrayRead(in, &x));
    return VecRestoreArrayWrite(out, &y);
}

/// Lets a matrix of PETSc's find something of ours again.
inline void attach(Mat of, const char* name, void* what) {
    Owned<PetscContainer, PetscContainerDestroy> container;
    check(PetscContainerCreate(PETSC_COMM_SELF, container.fresh()));
    check(PetscContainerSetPointer(container, what));
    check(PetscObjectCompose((PetscObject)of, name, (PetscObject)(PetscContainer)container));
}

template <class What>
PetscErrorCode find(Mat of, const char* name, What*& what) {
    PetscObject found = nullptr;
    void* pointer = nullptr;
    PetscCall(PetscObjectQuery((PetscObject)of, name, &found));
    PetscCall(PetscContainerGetPointer((PetscContainer)found, &pointer));
    what = static_cast<What*>(pointer);
    return PetscErrorCode(0);
}

/// Lets PETSc make the products of a stiffness matrix, and of those that come of them, by blocks.
class ProductsByBlocks {
  public:
    ProductsByBlocks(const BlockMatrix& matrix, RunContext& threads) : matrix_(matrix), threads_(threads) {}

    /// `of` has the matrix's entries and lives no longer than this.
    void serve(Mat of) {
        finest_ = of;
        levels_.clear();
        take_over(of);
    }

  private:
    using Operation = PetscErrorCode (*)(Mat);
    static constexpr const char *owner_name = "featuremesh_products", *level_name = "featuremesh_level";

    void take_over(Mat of) {
        attach(of, owner_name, this);
        void (*otherwise)(void) = nullptr;
        check(MatGetOperation(of, MATOP_PRODUCTSETFROMOPTIONS, &otherwise));
        if (otherwise) otherwise_ = (Operation)otherwise;
        // Where two matrices do not have the same operation PETSc asks the first for a function of this name.
        check(MatSetOperation(of, MATOP_PRODUCTSETFROMOPTIONS, nullptr));
        check(PetscObjectComposeFunction((PetscObject)of, "MatProductSetFromOptions_seqaij_seqaij_C", choose));
    }

    struct Asked {
        MatProductType type = MATPRODUCT_UNSPECIFIED;
        Mat of = nullptr, by = nullptr;
        ProductsByBlocks* self = nullptr;

        explicit Asked(Mat product) {
            check(MatProductGetType(product, &type));
            check(MatProductGetMats(product, &of, &by, nullptr));
            check(find(of, owner_name, self));
        }
        std::size_t height() const { return of == self->finest_ ? 3 : 6; }
    };

    static PetscErrorCode choose(Mat product) {
        return guarded([&] {
            const Asked asked(product);
            const bool is_ours = (asked.type == MATPRODUCT_AB || asked.type == MATPRODUCT_PtAP) &&
                                 PetscBlocks(asked.by, asked.height(), 6).is_of_blocks();
            if (is_ours)
                check(MatSetOperation(product, MATOP_PRODUCTSYMBOLIC, (void (*)(void))prepare));
            else
                check(asked.self->otherwise_(product));
        });
    }

    static PetscErrorCode prepare(Mat product) {
        return MatSetOperation(product, MATOP_PRODUCTNUMERIC, (void (*)(void))make);
    }

    static PetscErrorCode make(Mat product) {
        return guarded([&] {
            const Asked asked(product);
            const PetscBlocks motions(asked.by, asked.height(), 6);
            if (asked.height() == 3) {
                const BlockMatrix& matrix = asked.self->matrix_;
                BlockPattern pattern{3, 3, matrix.begins, matrix.neighbours};  // rows as assembled
                pattern.starts.push_back(matrix.ends.back());
                asked.self->make_of<3>(asked, product, {pattern, matrix.values.data()}, motions);
            } else {
                const PetscBlocks stiffness(asked.of, 6, 6);
                asked.self->make_of<6>(asked, product, stiffness.blocks(), motions);
            }
            check(prepare(product));
        });
    }

    template <std::size_t height>
    void make_of(const Asked& asked, Mat product, const Blocks& stiffness, const PetscBlocks& motions) {
        const LevelProducts<height> level(stiffness, motions.blocks(), threads_);
        const BlockPattern once = level.pattern();
        if (asked.type == MATPRODUCT_AB) {
            shape(product, once, motions.width());
            fill(product, [&](double* values) { level.multiply(once, 0, once.count(), values); });
            return;
        }
        const NodesOfAggregates has(motions.blocks().pattern, std::size_t(motions.width() / 6));
        const BlockPattern condensed = level.pattern(once, has);
        shape(product, condensed, motions.width());
        fill(product, [&](double* values) { level.condense(once, has, condensed, values); });
        take_over(product);
        round_products(product, condensed);
    }

    /// What the multigrid multiplies a level by, in single precision, as on the finest.
    struct Level {
        BlockPattern pattern;
        RoundedBlocks rounded;
        RunContext& threads;
    };

    void round_products(Mat of, BlockPattern pattern) {
        levels_.push_back(std::unique_ptr<Level>(new Level{std::move(pattern), {}, threads_}));
        Level& level = *levels_.back();
        const PetscScalar* values = nullptr;
        check(MatSeqAIJGetArrayRead(of, &values));
        level.rounded = {6, 6, rows_of(level.pattern.starts, level.pattern.columns), values, threads_};
        check(MatSeqAIJRestoreArrayRead(of, &values));
        attach(of, level_name, &level);
        check(MatSetOperation(of, MATOP_MULT, (void (*)(void))multiply));
    }

    static PetscErrorCode multiply(Mat of, Vec in, Vec out) {
        Level* level = nullptr;
        PetscCall(find(of, level_name, level));
        return multiply_by(level->rounded, in, out, level->threads);
    }

    /// Makes `product` a matrix of such blocks.
    static void shape(Mat product, const BlockPattern& blocks, PetscInt width) {
        const auto rows = PetscInt(blocks.height * blocks.count());
        std::vector<PetscInt> in_row, columns;
        for (std::size_t row = 0; row < blocks.count(); ++row)
            for (std::size_t r = 0; r < blocks.height; ++r) {
                in_row.push_back(PetscInt(blocks.width(row)));
                for (std::size_t block = blocks.begin(row); block < blocks.end(row); ++block)
                    for (PetscInt c = 0; c < 6; ++c) columns.push_back(6 * blocks.columns[block] + c);
            }
        check(MatSetSizes(product, rows, width, rows, width));
        check(MatSetBlockSizes(product, PetscInt(blocks.height), 6));
        check(MatSetType(product, MATSEQAIJ));
        check(MatSeqAIJSetPreallocation(product, 0, in_row.data()));
        check(MatSeqAIJSetColumnIndices(product, columns.data()));
    }

    template <class Write>
    static void fill(Mat product, const Write& write) {
        PetscScalar* values = nullptr;
        check(MatSeqAIJGetArrayWrite(product, &values));
        write(values);
        check(MatSeqAIJRestoreArrayWrite(product, &values));
        check(MatAssemblyBegin(product, MAT_FINAL_ASSEMBLY));
        check(MatAssemblyEnd(product, MAT_FINAL_ASSEMBLY));
    }

    const BlockMatrix& matrix_;
    RunContext& threads_;
    std::vector<std::unique_ptr<Level>> levels_;
    Mat finest_ = nullptr;
    Operation otherwise_ = nullptr;
};

}  // namespace featuremesh

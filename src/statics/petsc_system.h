// SPDX-License-Identifier: GPL-3.0-or-later
// A stiffness matrix as PETSc reads it.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "core/geometry.h"
#include "core/messages.h"
#include "statics/petsc_objects.h"
#include "statics/petsc_products.h"
#include "statics/rounded_blocks.h"
#include "statics/stiffness.h"

namespace featuremesh {

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

    /// Hands the matrix out, to be changed; another has to be taken before this is used again.
    BlockMatrix give() {
        exact.reset(), rounded.reset();
        return std::move(blocks);
    }

    /// Hands the matrix out once it serves but as a preconditioner: its rounded products are all that this is asked for
    /// then.
    BlockMatrix give_but_rounded() {
        exact.reset();
        BlockMatrix given;
        given.begins = blocks.begins, given.ends = blocks.ends, given.neighbours.reserve(blocks.neighbours.capacity());
        given.neighbours = blocks.neighbours;
        given.values = std::move(blocks.values);
        return given;
    }

    /// For a preconditioner that asks for products and the nodes' own blocks only.
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
            const std::size_t begin = blocks.begin(node), width = blocks.width(node);
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

    void round() {
        rounded_.take({blocks.begins, blocks.ends, blocks.neighbours}, blocks.values.data(), threads,
                      blocks.blocks_before);
    }

    void make_shell(Matrix& shell, Product product) {
        check(MatCreateShell(PETSC_COMM_SELF, size(), size(), size(), size(), this, shell.fresh()));
        check(MatShellSetOperation(shell, MATOP_MULT, (void (*)(void))product));
        check(MatSetBlockSize(shell, 3));
        check(MatSetOperation(shell, MATOP_INVERT_BLOCK_DIAGONAL, (void (*)(void)) & System::invert_own_blocks));
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

    /// The inverses of the nodes' own blocks, for PETSc's Jacobi by blocks. They are symmetric.
    static PetscErrorCode invert_own_blocks(Mat of, const PetscScalar** values) {
        System* self = nullptr;
        PetscCall(MatShellGetContext(of, &self));
        return guarded([&] {
            const BlockMatrix& matrix = self->blocks;
            self->inverses_.resize(9 * matrix.node_count());
            parallel_for(self->threads, matrix.node_count(), 4096, [&](std::size_t begin, std::size_t end) {
                for (std::size_t node = begin; node < end; ++node)
                    invert(matrix.values.data() + own_place(matrix, node), matrix.width(node),
                           self->inverses_.data() + 9 * node);
            });
            *values = self->inverses_.data();
        });
    }

    /// By cofactors: each row of the inverse is a product of the other two rows, over the determinant.
    static void invert(const double* block, std::size_t width, double* inverse) {
        const auto row = [&](std::size_t r) {
            const double* a = block + r % 3 * width;
            return Vec3{a[0], a[1], a[2]};
        };
        const double determinant = dot(row(0), cross(row(1), row(2)));
        for (std::size_t r = 0; r < 3; ++r) {
            const Vec3 cofactors = cross(row(r + 1), row(r + 2));
            for (int c = 0; c < 3; ++c) inverse[3 * r + std::size_t(c)] = cofactors[c] / determinant;
        }
    }

    static std::size_t own_place(const BlockMatrix& blocks, std::size_t node) {
        const auto first = blocks.neighbours.begin() + blocks.begins[node];
        const auto last = blocks.neighbours.begin() + blocks.ends[node];
        return blocks.place(node, std::size_t(std::find(first, last, std::int32_t(node)) - blocks.neighbours.begin()));
    }

    PetscErrorCode multiply(Vec in, Vec out) {
        const PetscScalar* x = nullptr;
        PetscScalar* y = nullptr;
        PetscCall(VecGetArrayRead(in, &x));
        PetscCall(VecGetArrayWrite(out, &y));
        PetscCall(guarded([&] { featuremesh::multiply(blocks, x, y, threads); }));
        PetscCall(VecRestoreArrayRead(in, &x));
        PetscCall(VecRestoreArrayWrite(out, &y));
        return PetscErrorCode(0);
    }

    static constexpr const char* owner = "featuremesh_system";

    RoundedBlocks rounded_{3, 3};
    std::vector<PetscInt> starts_, columns_;
    std::vector<double> inverses_;
    ProductsByBlocks products_{blocks, threads};
};

inline void name_rigid_motions(const System& system, std::span<const Vec3> points) {
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

}  // namespace featuremesh

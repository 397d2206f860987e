// SPDX-License-Identifier: GPL-3.0-or-later
// A part of a stiffness matrix as a matrix of PETSc's.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "statics/petsc_objects.h"
#include "statics/stiffness.h"

namespace featuremesh {

/// The rows and columns of some nodes of a matrix.
struct NodesBlock {
    std::vector<std::int32_t> nodes;
    Matrix matrix;

    void take(const BlockMatrix& blocks, std::vector<std::int32_t> chosen) {
        nodes = std::move(chosen);
        std::vector<std::int32_t> rank(blocks.node_count(), -1);
        for (std::size_t i = 0; i < nodes.size(); ++i) rank[std::size_t(nodes[i])] = std::int32_t(i);
        std::vector<std::pair<std::int32_t, std::size_t>> found;  // of a row: columns' ranks and places of their values
        starts_.assign(1, 0);
        columns_.clear(), values_.clear();
        for (std::size_t i = 0; i < size(); ++i) {
            const auto node = std::size_t(nodes[i / 3]);
            found.clear();
            for (std::size_t k = blocks.begin(node); k < blocks.end(node); ++k)
                if (const std::int32_t other = rank[std::size_t(blocks.neighbours[k])]; other >= 0)
                    found.emplace_back(other, blocks.place(node, k) + i % 3 * blocks.width(node));
            std::sort(found.begin(), found.end());
            for (const auto& [other, place] : found)
                for (std::size_t c = 0; c < 3; ++c) {
                    columns_.push_back(3 * other + PetscInt(c));
                    values_.push_back(blocks.values[place + c]);
                }
            starts_.push_back(PetscInt(columns_.size()));
        }
        check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, PetscInt(size()), PetscInt(size()), starts_.data(),
                                        columns_.data(), values_.data(), matrix.fresh()));
        check(MatSetBlockSize(matrix, 3));
        check(MatSetOption(matrix, MAT_SPD, PETSC_TRUE));
    }

    /// What the nodes resist with when all nodes of the whole matrix are displaced.
    std::vector<double> resisting(const BlockMatrix& blocks, std::span<const double> displacements) const {
        std::vector<double> forces(size(), 0.0);
        for (std::size_t i = 0; i < size(); ++i) {
            const auto node = std::size_t(nodes[i / 3]);
            const double* value = blocks.values.data() + 9 * blocks.begin(node) + i % 3 * blocks.width(node);
            for (std::size_t k = blocks.begin(node); k < blocks.end(node); ++k)
                for (std::size_t c = 0; c < 3; ++c)
                    forces[i] += *value++ * displacements[3 * std::size_t(blocks.neighbours[k]) + c];
        }
        return forces;
    }

    std::size_t size() const { return 3 * nodes.size(); }
    /// The component of the whole matrix that is the i-th here.
    std::size_t at(std::size_t i) const { return 3 * std::size_t(nodes[i / 3]) + i % 3; }

  private:
    std::vector<PetscInt> starts_, columns_;
    std::vector<double> values_;
};

}  // namespace featuremesh

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

/// The component of the whole matrix that is the i-th of some nodes'.
inline std::size_t component(std::span<const std::int32_t> nodes, std::size_t i) {
    return 3 * std::size_t(nodes[i / 3]) + i % 3;
}

/// What some nodes resist with, three numbers each, when all nodes of the matrix are displaced.
inline std::vector<double> resisting(const BlockMatrix& blocks, std::span<const std::int32_t> nodes,
                                     std::span<const double> displacements) {
    std::vector<double> forces(3 * nodes.size(), 0.0);
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const auto node = std::size_t(nodes[i / 3]);
        const double* value = blocks.values.data() + 9 * blocks.begin(node) + i % 3 * blocks.width(node);
        for (std::size_t k = blocks.begin(node); k < blocks.end(node); ++k)
            for (std::size_t c = 0; c < 3; ++c)
                forces[i] += *value++ * displacements[3 * std::size_t(blocks.neighbours[k]) + c];
    }
    return forces;
}

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

    std::size_t size() const { return 3 * nodes.size(); }

  private:
    std::vector<PetscInt> starts_, columns_;
    std::vector<double> values_;
};

/// The same in blocks of three by three, of which only those on the diagonal and above are held: half as much to read.
class NodesUpperHalf {
  public:
    Matrix matrix;

    NodesUpperHalf(const BlockMatrix& blocks, std::span<const std::int32_t> nodes) : blocks_(blocks) {
        rank_.assign(blocks.node_count(), -1);
        for (std::size_t i = 0; i < nodes.size(); ++i) rank_[std::size_t(nodes[i])] = std::int32_t(i);
        std::vector<PetscInt> in_row;
        for (const std::int32_t node : nodes) in_row.push_back(PetscInt(find_row(std::size_t(node)).size()));
        const auto size = PetscInt(3 * nodes.size());
        check(MatCreateSeqSBAIJ(PETSC_COMM_SELF, 3, size, size, 0, in_row.data(), matrix.fresh()));
        for (const std::int32_t node : nodes) add_row(std::size_t(node));
        check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
        check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
        check(MatSetOption(matrix, MAT_SPD, PETSC_TRUE));
    }

  private:
    using Found = std::vector<std::pair<std::int32_t, std::size_t>>;

    /// Columns' ranks and places of their values.
    const Found& find_row(std::size_t node) {
        found_.clear();
        for (std::size_t k = blocks_.begin(node); k < blocks_.end(node); ++k)
            if (const std::int32_t other = rank_[std::size_t(blocks_.neighbours[k])]; other >= rank_[node])
                found_.emplace_back(other, blocks_.place(node, k));
        std::sort(found_.begin(), found_.end());
        return found_;
    }

    void add_row(std::size_t node) {
        std::vector<PetscInt> columns;
        std::vector<double> values;
        for (const auto& [other, place] : find_row(node)) columns.push_back(other);
        for (std::size_t r = 0; r < 3; ++r)
            for (const auto& [other, place] : found_)
                for (std::size_t c = 0; c < 3; ++c)
                    values.push_back(blocks_.values[place + r * blocks_.width(node) + c]);
        const PetscInt row = rank_[node];
        check(MatSetValuesBlocked(matrix, 1, &row, PetscInt(columns.size()), columns.data(), values.data(),
                                  INSERT_VALUES));
    }

    const BlockMatrix& blocks_;
    std::vector<std::int32_t> rank_;
    Found found_;
};

}  // namespace featuremesh

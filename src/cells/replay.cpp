// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells/replay.h"

#include <optional>
#include <utility>
#include <vector>

#include "core/ids.h"

namespace featuremesh {

namespace {

using CellSet = std::vector<bool>;

using CellList = std::vector<std::size_t>;  // few of all cells, as a rule

void unite(CellSet& a, const CellList& b) {
    for (const std::size_t i : b) a[i] = true;
}
void subtract(CellSet& a, const CellList& b) {
    for (const std::size_t i : b) a[i] = false;
}
void intersect(CellSet& a, const CellList& b) {
    CellSet both(a.size());
    for (const std::size_t i : b) both[i] = a[i];
    a = std::move(both);
}
void unite(CellSet& a, const CellSet& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] || b[i];
}
void subtract(CellSet& a, const CellSet& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] && !b[i];
}
void intersect(CellSet& a, const CellSet& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] && b[i];
}
void exclude(CellSet& a, const CellSet& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] != b[i];
}

class Replay {
  public:
    Replay(const FeatureTree& tree, const std::vector<Cell>& cells) : tree_(tree), count_(cells.size()) {
        for (std::size_t f = 0; f < tree.features.size(); ++f) inside_.emplace_back(tree.features[f].volumes.size());
        for (std::size_t c = 0; c < count_; ++c)
            for (const Owner& owner : cells[c].owners) inside_[owner.feature.index()][owner.volume].push_back(c);
        results_.resize(tree.features.size());
    }

    const CellSet& result_of(FeatureId id) {
        auto& result = results_[id.index()];
        if (!result) result = evaluate(id);
        return *result;
    }

  private:
    CellSet evaluate(FeatureId id) {
        const Feature& feature = tree_[id];
        if (feature.combination == Combination::volumes) return united_volumes(id);
        CellSet result(count_);
        if (!feature.operands.empty()) result = result_of(feature.operands.front());
        if (feature.combination == Combination::chain) apply_volumes(id, result);
        for (std::size_t k = 1; k < feature.operands.size(); ++k)
            combine(feature.combination, result, result_of(feature.operands[k]));
        return result;
    }

    CellSet united_volumes(FeatureId id) const {
        CellSet result(count_);
        for (const CellList& volume : inside_[id.index()]) unite(result, volume);
        return result;
    }

    void apply_volumes(FeatureId id, CellSet& result) const {
        for (std::size_t v = 0; v < inside_[id.index()].size(); ++v) {
            const CellList& volume = inside_[id.index()][v];
            switch (tree_[id].volumes[v].step) {
                case Effect::adds:
                    unite(result, volume);
                    break;
                case Effect::removes:
                    subtract(result, volume);
                    break;
                case Effect::keeps_only:
                    intersect(result, volume);
                    break;
            }
        }
    }

    static void combine(Combination how, CellSet& result, const CellSet& operand) {
        switch (how) {
            case Combination::fuse:
                return unite(result, operand);
            case Combination::cut:
                return subtract(result, operand);
            case Combination::common:
                return intersect(result, operand);
            case Combination::exclusive:
                return exclude(result, operand);
            case Combination::volumes:
            case Combination::chain:
            case Combination::pass:
                return;
        }
    }

    const FeatureTree& tree_;
    std::size_t count_;
    std::vector<std::vector<CellList>> inside_;  // by feature and volume
    std::vector<std::optional<CellSet>> results_;
};

}  // namespace

std::vector<bool> replay(const FeatureTree& tree, const std::vector<Cell>& cells) {
    const auto last = tree.find(tree.object);
    return last ? Replay(tree, cells).result_of(*last) : std::vector<bool>(cells.size());
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers joined to sets.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace featuremesh {

/// Each set is named by its lowest number.
class JoinedSets {
  public:
    explicit JoinedSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
    std::int32_t root(std::int32_t n) {
        while (parent_[std::size_t(n)] != n)
            n = parent_[std::size_t(n)] = parent_[std::size_t(parent_[std::size_t(n)])];
        return n;
    }
    void join(std::int32_t m, std::int32_t n) {
        if (parent_[std::size_t(m)] == parent_[std::size_t(n)]) return;
        const auto a = root(m), b = root(n);
        parent_[std::size_t(std::max(a, b))] = std::min(a, b);
    }

  private:
    std::vector<std::int32_t> parent_;
};

}  // namespace featuremesh

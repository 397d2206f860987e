// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace featuremesh {

/// Marks of tets, all cleared at once.
class TetMarks {
  public:
    /// Clears them; `count` is that of the tets.
    void begin(std::size_t count) {
        if (marks_.size() < count) marks_.resize(count, 0);
        if (++stamp_ != 0) return;
        std::fill(marks_.begin(), marks_.end(), 0);
        stamp_ = 1;
    }
    void mark(int tet) { marks_[static_cast<std::size_t>(tet)] = stamp_; }
    bool is_marked(int tet) const { return marks_[static_cast<std::size_t>(tet)] == stamp_; }

  private:
    std::vector<std::uint32_t> marks_;
    std::uint32_t stamp_ = 0;
};

}  // namespace featuremesh

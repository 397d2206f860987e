// SPDX-License-Identifier: GPL-3.0-or-later
// One number per side (pair of nodes), without hashing: a short list at the side's smaller node.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/ids.h"

namespace featuremesh {

class SideTable {
  public:
    explicit SideTable(std::size_t node_count) : first_(node_count, -1) {}

    /// The number at side (a, b), in either direction; -1 until it is set. The reference holds until the next new side.
    std::int32_t& value(NodeId a, NodeId b) {
        const auto [low, high] = std::minmax(a.value, b.value);
        std::int32_t* link = &first_[static_cast<std::size_t>(low)];
        for (; *link >= 0; link = &entries_[static_cast<std::size_t>(*link)].next)
            if (entries_[static_cast<std::size_t>(*link)].other == high)
                return entries_[static_cast<std::size_t>(*link)].value;
        *link = static_cast<std::int32_t>(entries_.size());
        entries_.push_back({high, -1, -1});
        return entries_.back().value;
    }
    /// -1 when the side is not there or was not set.
    std::int32_t find(NodeId a, NodeId b) const {
        const auto [low, high] = std::minmax(a.value, b.value);
        for (std::int32_t e = first_[static_cast<std::size_t>(low)]; e >= 0;
             e = entries_[static_cast<std::size_t>(e)].next)
            if (entries_[static_cast<std::size_t>(e)].other == high) return entries_[static_cast<std::size_t>(e)].value;
        return -1;
    }

  private:
    struct Entry {
        std::int32_t other, value, next;
    };
    std::vector<std::int32_t> first_;
    std::vector<Entry> entries_;
};

}  // namespace featuremesh

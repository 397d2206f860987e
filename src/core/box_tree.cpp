// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/box_tree.h"

namespace featuremesh {

BoxTree::BoxTree(std::span<const Box> boxes) {
    items_.reserve(boxes.size());
    // an empty one is never met, and its middle has no place in any order
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (!boxes[i].is_empty()) items_.push_back({boxes[i], std::int32_t(i)});
    nodes_.reserve(items_.size());
    if (!items_.empty()) build(0, std::int32_t(items_.size()));
}

std::int32_t BoxTree::build(std::int32_t begin, std::int32_t end) {
    constexpr std::int32_t most_in_leaf = 4;
    const auto index = std::int32_t(nodes_.size());
    Box box;
    for (std::int32_t i = begin; i < end; ++i) box.add(items_[std::size_t(i)].box);
    nodes_.push_back({box, begin, end});
    if (end - begin <= most_in_leaf) return index;
    const Vec3 size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::int32_t middle = begin + (end - begin) / 2;
    std::nth_element(
        items_.begin() + begin, items_.begin() + middle, items_.begin() + end, [axis](const Item& a, const Item& b) {
            const double twice_a = a.box.low[axis] + a.box.high[axis], twice_b = b.box.low[axis] + b.box.high[axis];
            return twice_a != twice_b ? twice_a < twice_b : a.index < b.index;
        });
    const std::int32_t left = build(begin, middle), right = build(middle, end);
    nodes_[std::size_t(index)].left = left;
    nodes_[std::size_t(index)].right = right;
    return index;
}

}  // namespace featuremesh

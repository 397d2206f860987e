// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/box_tree.h"

#include <numeric>

namespace featuremesh {

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!boxes_.empty()) build(0, std::int32_t(boxes_.size()));
}

std::int32_t BoxTree::build(std::int32_t begin, std::int32_t end) {
    constexpr std::int32_t most_in_leaf = 4;
    const auto index = std::int32_t(nodes_.size());
    Box box;
    for (std::int32_t i = begin; i < end; ++i) box.add(boxes_[std::size_t(order_[std::size_t(i)])]);
    nodes_.push_back({box, begin, end});
    if (end - begin <= most_in_leaf) return index;
    const Vec3 size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::int32_t middle = begin + (end - begin) / 2;
    std::nth_element(
        order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](std::int32_t a, std::int32_t b) {
            const double ca = boxes_[std::size_t(a)].center()[axis], cb = boxes_[std::size_t(b)].center()[axis];
            return ca != cb ? ca < cb : a < b;
        });
    const std::int32_t left = build(begin, middle), right = build(middle, end);
    nodes_[std::size_t(index)].left = left;
    nodes_[std::size_t(index)].right = right;
    return index;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes in a tree, for finding those around a point or along a ray and the things nearest to a point.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/distances.h"
#include "core/geometry.h"

namespace featuremesh {

class BoxTree {
  public:
    explicit BoxTree(std::vector<Box> boxes);

    /// Calls visit(index) for every box that does_meet(box), which must be true of a box around one that it is true of.
    template <class Meets, class Visit>
    void visit_where(Meets does_meet, Visit visit) const {
        descend(0, does_meet, visit);
    }
    /// Calls visit(index) for every box that holds p.
    template <class Visit>
    void visit_around(const Vec3& p, Visit visit) const {
        descend(
            0, [&](const Box& box) { return box.contains(p); }, visit);
    }
    /// Index for which squared_distance(index) is smallest, the first of equals; it must not be below that of its box.
    /// -1 for an empty tree.
    template <class Distance>
    std::int32_t nearest(const Vec3& p, Distance squared_distance) const {
        std::int32_t best = -1;
        double least = std::numeric_limits<double>::infinity();
        descend(
            0, [&](const Box& box) { return squared_distance_to_box(p, box) <= least; },
            [&](std::int32_t i) {
                const double d = squared_distance(i);
                if (d < least || (d == least && i < best)) least = d, best = i;
            });
        return best;
    }

  private:
    struct Node {
        Box box;
        std::int32_t begin, end;  // of order_; a leaf where the children are none
        std::int32_t left = -1, right = -1;
    };
    std::int32_t build(std::int32_t begin, std::int32_t end);

    template <class Enter, class Visit>
    void descend(std::int32_t at, const Enter& enter, const Visit& visit) const {
        if (nodes_.empty() || !enter(nodes_[std::size_t(at)].box)) return;
        const Node& node = nodes_[std::size_t(at)];
        if (node.left >= 0) {
            descend(node.left, enter, visit);
            descend(node.right, enter, visit);
            return;
        }
        for (std::int32_t i = node.begin; i < node.end; ++i)
            if (const std::int32_t item = order_[std::size_t(i)]; enter(boxes_[std::size_t(item)])) visit(item);
    }

    std::vector<Box> boxes_;
    std::vector<std::int32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace featuremesh

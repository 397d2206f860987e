// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes in a tree, for finding those around a point or along a ray and the things nearest to a point.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/distances.h"
#include "core/geometry.h"

namespace featuremesh {

class BoxTree {
  public:
    explicit BoxTree(std::span<const Box> boxes);

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
        approach(
            p, [&](double of_box) { return of_box <= least; },
            [&](std::int32_t i) {
                const double d = squared_distance(i);
                if (best < 0 || d < least || (d == least && i < best)) least = d, best = i;
            });
        return best;
    }
    /// The smallest squared_distance(index) that is below `most`, else `most`; one that is below `enough` may be any of
    /// those.
    template <class Distance>
    double least_distance(const Vec3& p, double most, double enough, Distance squared_distance) const {
        double least = most;
        approach(
            p, [&](double of_box) { return of_box < least && least >= enough; },
            [&](std::int32_t i) { least = std::min(least, squared_distance(i)); });
        return least;
    }
    /// Around all boxes.
    Box box() const { return nodes_.empty() ? Box{} : nodes_[0].box; }

  private:
    struct Item {
        Box box;
        std::int32_t index;  // among those given
    };
    struct Node {
        Box box;
        std::int32_t begin, end;  // of items_; a leaf where the children are none
        std::int32_t left = -1, right = -1;
    };
    static constexpr std::size_t most_deep = 64;  // halves of what an index can count
    std::int32_t build(std::int32_t begin, std::int32_t end);

    /// Calls visit(index) for the boxes whose squared distance from p is of use, of two halves the nearer one first.
    template <class IsOfUse, class Visit>
    void approach(const Vec3& p, const IsOfUse& is_of_use, const Visit& visit) const {
        struct Waiting {
            std::int32_t node;
            double distance;
        };
        const auto with_distance = [&](std::int32_t node) {
            return Waiting{node, squared_distance_to_box(p, nodes_[std::size_t(node)].box)};
        };
        std::array<Waiting, most_deep> waiting;
        std::size_t count = 0;
        if (!nodes_.empty()) waiting[count++] = with_distance(0);
        while (count > 0) {
            const auto [at, distance] = waiting[--count];
            if (!is_of_use(distance)) continue;
            const Node& node = nodes_[std::size_t(at)];
            if (node.left < 0) {
                for (std::int32_t i = node.begin; i < node.end; ++i)
                    if (const Item& item = items_[std::size_t(i)]; is_of_use(squared_distance_to_box(p, item.box)))
                        visit(item.index);
                continue;
            }
            Waiting near = with_distance(node.left), far = with_distance(node.right);
            if (far.distance < near.distance) std::swap(near, far);
            waiting[count++] = far;
            waiting[count++] = near;
        }
    }

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
            if (const Item& item = items_[std::size_t(i)]; enter(item.box)) visit(item.index);
    }

    std::vector<Item> items_;  // those of a node lie together
    std::vector<Node> nodes_;
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/source_tree.h"

#include <algorithm>

namespace featuremesh {
namespace {

constexpr std::size_t balls_per_leaf = 4;
/// Above it, listing the candidates of every place costs more than it saves.
constexpr std::size_t most_listed = 50'000;

double squared_distance_to_box(const Vec3& p, const Vec3& low, const Vec3& high) {
    const double x = std::max({low.x - p.x, 0.0, p.x - high.x});
    const double y = std::max({low.y - p.y, 0.0, p.y - high.y});
    const double z = std::max({low.z - p.z, 0.0, p.z - high.z});
    return x * x + y * y + z * z;
}

}  // namespace

SourceTree::SourceTree(std::vector<SourceBall> sources, double slope, double limit, const Box& box)
    : balls_(std::move(sources)), slope_(slope), inverse_slope_(1.0 / std::max(slope, 1e-12)), limit_(limit) {
    if (balls_.empty()) return;
    nodes_.reserve(balls_.size());
    build(0, balls_.size());
    if (slope > 1e-6 && balls_.size() <= most_listed) candidates_ = CandidateOctree(balls_, slope, limit, box);
}

std::int32_t SourceTree::build(std::size_t begin, std::size_t end) {
    Box box, centers;
    double size = std::numeric_limits<double>::infinity();
    for (std::size_t i = begin; i < end; ++i) {
        const SourceBall& ball = balls_[i];
        const Vec3 r{ball.radius, ball.radius, ball.radius};
        box.add(ball.center - r), box.add(ball.center + r);
        centers.add(ball.center);
        size = std::min(size, ball.size);
    }
    const auto index = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back(
        {box.low, box.high, size, static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end - begin)});
    if (end - begin <= balls_per_leaf) return index;
    const Vec3 extent = centers.size();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(balls_.begin() + static_cast<std::ptrdiff_t>(begin),
                     balls_.begin() + static_cast<std::ptrdiff_t>(middle),
                     balls_.begin() + static_cast<std::ptrdiff_t>(end),
                     [axis](const SourceBall& a, const SourceBall& b) { return a.center[axis] < b.center[axis]; });
    build(begin, middle);
    const std::int32_t second = build(middle, end);
    nodes_[static_cast<std::size_t>(index)].first = second;
    nodes_[static_cast<std::size_t>(index)].count = 0;
    return index;
}

double SourceTree::at(const Vec3& p) const {
    const double listed = candidates_.at(balls_, p);
    return listed >= 0 ? listed : through_tree(p);
}

double SourceTree::through_tree(const Vec3& p) const {
    double best = limit_;
    if (nodes_.empty()) return best;
    // squared distance to the node's box, kept on the stack so that it is found once
    struct Waiting {
        std::int32_t node;
        double squared;
    };
    Waiting stack[64];
    int depth = 0;
    stack[depth++] = {0, squared_distance_to_box(p, nodes_[0].low, nodes_[0].high)};
    while (depth > 0) {
        const Waiting next = stack[--depth];
        const Node& node = nodes_[static_cast<std::size_t>(next.node)];
        const double far = reach(node, best);
        if (far <= 0 || next.squared >= far * far) continue;
        if (node.count > 0) {
            for (std::int32_t i = node.first; i < node.first + node.count; ++i)
                best = balls_[static_cast<std::size_t>(i)].lower(best, p, slope_, inverse_slope_);
            continue;
        }
        const std::int32_t a = next.node + 1, b = node.first;
        const Node &left = nodes_[static_cast<std::size_t>(a)], &right = nodes_[static_cast<std::size_t>(b)];
        const Waiting to_left{a, squared_distance_to_box(p, left.low, left.high)};
        const Waiting to_right{b, squared_distance_to_box(p, right.low, right.high)};
        const bool left_first =
            to_left.squared < to_right.squared || (to_left.squared == to_right.squared && left.size <= right.size);
        stack[depth++] = left_first ? to_right : to_left;
        stack[depth++] = left_first ? to_left : to_right;
    }
    return best;
}

}  // namespace featuremesh

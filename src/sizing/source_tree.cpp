// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/source_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace featuremesh {
namespace {

constexpr std::size_t balls_per_leaf = 4;
/// Reaches are raised by this share, which is more than the rounding errors of the few operations.
constexpr float over = 1 + 2e-6f;

/// The last query on this thread, of any tree: its point, the size found, and the leaf of balls that gave it. Most
/// queries are near the one before, where the same balls give nearly the smallest size again, so the search starts with
/// them. Where it starts changes its speed, never the minimum that it finds.
struct LastQuery {
    Vec3 point;
    double size = 0;
    std::int32_t first = 0, count = 0;

    /// Whether its balls ask for little more than the least at p.
    bool is_near(const Vec3& p, double slope) const {
        constexpr double little = 0.2;
        return slope * slope * squared_length(p - point) < little * little * size * size;
    }
};
thread_local constinit LastQuery last_query;

}  // namespace

SourceTree::SourceTree(std::vector<SourceBall> sources, double slope, double limit)
    : balls_(std::move(sources)), slope_(slope), inverse_slope_(1 / std::max(slope, 1e-12)), limit_(limit) {
    if (balls_.empty()) return;
    Box box;
    double widest = 0;
    for (const SourceBall& ball : balls_) {
        box.add(ball.center);
        widest = std::max(widest, ball.radius);
        smallest_ = std::min(smallest_, ball.size);
    }
    origin_ = box.center();
    margin_ = static_cast<float>(1e-6 * (box.diagonal() + widest));
    nodes_.reserve(balls_.size() / balls_per_leaf + 1);
    build({0, balls_.size()});
}

std::int32_t SourceTree::build(Range range) {
    const auto index = static_cast<std::size_t>(nodes_.size());
    nodes_.emplace_back();
    std::vector<Range> ranges{range};
    while (ranges.size() < width) {  // the longest first, so that leaves are about equally long
        const auto longest = std::max_element(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) {
            return a.end - a.begin < b.end - b.begin;
        });
        if (longest->end - longest->begin <= balls_per_leaf) break;
        const Range second = halve(*longest);
        ranges.push_back(second);  // after the halving, for the list may move
    }
    Node node;
    for (int slot = 0; slot < width; ++slot)
        bound(node, slot, static_cast<std::size_t>(slot) < ranges.size() ? ranges[slot] : Range{0, 0});
    for (std::size_t slot = 0; slot < ranges.size(); ++slot) {
        const auto count = static_cast<std::int32_t>(ranges[slot].end - ranges[slot].begin);
        const bool is_leaf = ranges[slot].end - ranges[slot].begin <= balls_per_leaf;
        node.below[slot] =
            is_leaf ? Below{static_cast<std::int32_t>(ranges[slot].begin), count} : Below{build(ranges[slot]), 0};
    }
    nodes_[index] = node;
    return static_cast<std::int32_t>(index);
}

/// The first half stays in `range`.
SourceTree::Range SourceTree::halve(Range& range) {
    const auto at = [&](std::size_t i) { return balls_.begin() + static_cast<std::ptrdiff_t>(i); };
    Box centers;
    for (std::size_t i = range.begin; i < range.end; ++i) centers.add(balls_[i].center);
    const Vec3 extent = centers.size();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::size_t middle = range.begin + (range.end - range.begin) / 2;
    std::nth_element(at(range.begin), at(middle), at(range.end),
                     [axis](const SourceBall& a, const SourceBall& b) { return a.center[axis] < b.center[axis]; });
    return {middle, std::exchange(range.end, middle)};
}

void SourceTree::bound(Node& node, int slot, Range range) {
    Box box;
    double size = std::numeric_limits<double>::infinity();
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const SourceBall& ball = balls_[i];
        const Vec3 r{ball.radius, ball.radius, ball.radius};
        box.add(ball.center - r), box.add(ball.center + r);
        size = std::min(size, ball.size);
    }
    for (int axis = 0; axis < 3; ++axis) {
        node.low[axis][slot / lanes][slot % lanes] =
            box.is_empty() ? 0.0f : static_cast<float>(box.low[axis] - origin_[axis]);
        node.high[axis][slot / lanes][slot % lanes] =
            box.is_empty() ? 0.0f : static_cast<float>(box.high[axis] - origin_[axis]);
    }
    node.size[slot / lanes][slot % lanes] = static_cast<float>(size);
}

/// Squared distances from four of the boxes, in mm^2.
SourceTree::Lanes SourceTree::squared_distances(const Node& node, int half, const Point& p) {
    Lanes squared{};
    for (int axis = 0; axis < 3; ++axis) {
        const Lanes below = node.low[axis][half] - p[axis], above = p[axis] - node.high[axis][half];
        const Lanes outside = below > above ? below : above, away = outside > 0 ? outside : Lanes{};
        squared += away * away;
    }
    return squared;
}

double SourceTree::lowest_of(const Below& leaf, const Vec3& p, double best) const {
    for (std::int32_t i = leaf.first; i < leaf.first + leaf.count; ++i)
        best = balls_[static_cast<std::size_t>(i)].lower(best, p, slope_, inverse_slope_);
    return best;
}

/// The leaf that is reached by following, at each node, the child that promises the smallest size.
SourceTree::Below SourceTree::first_guess(const Point& point) const {
    Below next;
    while (next.count == 0) {
        const Node& node = nodes_[static_cast<std::size_t>(next.first)];
        float least = std::numeric_limits<float>::infinity();
        int best = 0;
        for (int half = 0; half < 2; ++half) {
            const Lanes squared = squared_distances(node, half, point);
            for (int i = 0; i < lanes; ++i) {
                const float bound = node.size[half][i] + static_cast<float>(slope_) * std::sqrt(squared[i]);
                best = bound < least ? half * lanes + i : best;
                least = std::min(least, bound);
            }
        }
        next = node.below[static_cast<std::size_t>(best)];
    }
    return next;
}

/// By bit, the boxes that may hold balls which ask for less than `best`.
unsigned SourceTree::boxes_near(const Node& node, const Point& point, double best) const {
    const float most = static_cast<float>(best) * over, inverse = static_cast<float>(inverse_slope_) * over;
    unsigned near = 0;
    for (int half = 0; half < 2; ++half) {
        const Lanes reach = (most - node.size[half]) * inverse + margin_;
        const auto is_near = (reach > 0) & (squared_distances(node, half, point) < reach * reach * over);
        const auto bits = is_near & Bits{1, 2, 4, 8};
        near |= static_cast<unsigned>((bits[0] | bits[1]) | (bits[2] | bits[3])) << (half * lanes);
    }
    return near;
}

double SourceTree::at(const Vec3& p) const {
    if (nodes_.empty()) return limit_;
    const Vec3 from_origin = p - origin_;
    const Point point{static_cast<float>(from_origin.x), static_cast<float>(from_origin.y),
                      static_cast<float>(from_origin.z)};
    Below leaf{last_query.first, last_query.count};
    const bool is_here = static_cast<std::size_t>(leaf.first) + static_cast<std::size_t>(leaf.count) <= balls_.size();
    if (!is_here || !last_query.is_near(p, slope_)) leaf = first_guess(point);
    double best = lowest_of(leaf, p, limit_);
    std::array<std::int32_t, 128> stack;
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = nodes_[static_cast<std::size_t>(stack[--depth])];
        for (unsigned near = boxes_near(node, point, best); near != 0; near &= near - 1) {
            const Below& below = node.below[static_cast<std::size_t>(std::countr_zero(near))];
            if (below.count == 0)
                stack[depth++] = below.first;
            else if (const double lower = lowest_of(below, p, best); lower < best)
                best = lower, leaf = below;
        }
    }
    last_query = {p, best, leaf.first, leaf.count};
    return best;
}

std::vector<SourceBall> balls_of_one(const SourceTree& a, const SourceTree& b) {
    const auto before = [](const SourceBall& x, const SourceBall& y) {
        return std::tie(x.center.x, x.center.y, x.center.z, x.radius, x.size) <
               std::tie(y.center.x, y.center.y, y.center.z, y.radius, y.size);
    };
    std::array<std::vector<SourceBall>, 2> balls;
    for (const int i : {0, 1}) {
        const auto of_tree = (i == 0 ? a : b).balls();
        balls[i].assign(of_tree.begin(), of_tree.end());
        std::sort(balls[i].begin(), balls[i].end(), before);
    }
    std::vector<SourceBall> only;
    std::set_symmetric_difference(balls[0].begin(), balls[0].end(), balls[1].begin(), balls[1].end(),
                                  std::back_inserter(only), before);
    return only;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/candidate_octree.h"

#include <algorithm>
#include <cmath>

namespace featuremesh {
namespace {

constexpr std::size_t few = 16;   ///< a list this short needs no halving
constexpr std::size_t many = 64;  ///< a longer one is slower than a tree over the balls
constexpr int deepest = 7;
constexpr std::size_t most_nodes = 200'000;

}  // namespace

CandidateOctree::CandidateOctree(std::span<const SourceBall> balls, double slope, double limit, const Box& box)
    : slope_(slope), inverse_slope_(1.0 / std::max(slope, 1e-12)), limit_(limit) {
    if (balls.empty() || box.is_empty()) return;
    // a cube, so that halving keeps the cells as deep as they are wide
    const Vec3 size = box.size(), half = Vec3{1, 1, 1} * (0.5 * std::max({size.x, size.y, size.z}));
    box_ = {box.center() - half, box.center() + half};
    std::vector<std::int32_t> all(balls.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int32_t>(i);
    nodes_.emplace_back();
    build(0, box_, 0, balls, all);
}

void CandidateOctree::build(std::size_t node, const Box& box, int depth, std::span<const SourceBall> balls,
                            const std::vector<std::int32_t>& candidates) {
    const Vec3 center = box.center();
    const double radius = 0.5 * box.diagonal();
    double at_center = limit_;
    for (const std::int32_t i : candidates)
        at_center = balls[static_cast<std::size_t>(i)].lower(at_center, center, slope_, inverse_slope_);
    // the field is nowhere in the cell above this, and a ball that asks for more everywhere in the cell is out
    const double high = std::min(limit_, at_center + slope_ * radius);
    std::vector<std::int32_t> left;
    for (const std::int32_t i : candidates) {
        const SourceBall& ball = balls[static_cast<std::size_t>(i)];
        const double reach = (high - ball.size) * inverse_slope_ + ball.radius + radius;
        if (ball.size < high && squared_length(ball.center - center) < reach * reach) left.push_back(i);
    }
    const bool is_fine = radius < at_center || depth >= deepest || nodes_.size() >= most_nodes;
    if (left.size() <= few || is_fine) {
        if (left.size() > many) {
            nodes_[node] = {0, crowded};
            return;
        }
        nodes_[node] = {static_cast<std::int32_t>(candidates_.size()), static_cast<std::int32_t>(left.size())};
        candidates_.insert(candidates_.end(), left.begin(), left.end());
        return;
    }
    const std::size_t children = nodes_.size();
    nodes_.resize(children + 8);
    nodes_[node] = {static_cast<std::int32_t>(children), inner};
    const Vec3 half = box.size() * 0.5;
    for (int octant = 0; octant < 8; ++octant) {
        const Vec3 low{box.low.x + (octant & 1 ? half.x : 0), box.low.y + (octant & 2 ? half.y : 0),
                       box.low.z + (octant & 4 ? half.z : 0)};
        build(children + static_cast<std::size_t>(octant), {low, low + half}, depth + 1, balls, left);
    }
}

double CandidateOctree::at(std::span<const SourceBall> balls, const Vec3& p) const {
    if (nodes_.empty() || !box_.contains(p)) return -1;
    Vec3 center = box_.center();
    double quarter = 0.25 * (box_.high.x - box_.low.x);
    const Node* node = nodes_.data();
    while (node->count == inner) {
        const int x = p.x > center.x, y = p.y > center.y, z = p.z > center.z;
        node = nodes_.data() + node->first + x + 2 * y + 4 * z;
        center += {x ? quarter : -quarter, y ? quarter : -quarter, z ? quarter : -quarter};
        quarter *= 0.5;
    }
    if (node->count == crowded) return -1;
    double best = limit_;
    for (std::int32_t i = node->first; i < node->first + node->count; ++i)
        best = balls[static_cast<std::size_t>(candidates_[static_cast<std::size_t>(i)])].lower(best, p, slope_,
                                                                                               inverse_slope_);
    return best;
}

}  // namespace featuremesh

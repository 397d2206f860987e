// SPDX-License-Identifier: GPL-3.0-or-later
// The growth-limited minimum over many size sources.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sizing/candidate_octree.h"
#include "sizing/source_ball.h"

namespace featuremesh {

/// Immutable bounding volume tree. The field is the exact minimum of size_i + slope * max(0, |x - center_i| -
/// radius_i), so it is Lipschitz with the slope by itself; inside the given box a query reads one short list, elsewhere
/// it goes through the tree.
class SourceTree {
  public:
    SourceTree() = default;
    /// Queries get fast within `box`; the field is nowhere above `limit`.
    SourceTree(std::vector<SourceBall> sources, double slope, double limit, const Box& box);

    bool empty() const { return balls_.empty(); }
    double smallest() const { return nodes_.empty() ? std::numeric_limits<double>::infinity() : nodes_[0].size; }
    double at(const Vec3& p) const;
    std::span<const SourceBall> balls() const { return balls_; }

  private:
    struct Node {
        Vec3 low, high;      ///< of the balls
        double size;         ///< smallest one
        std::int32_t first;  ///< first ball of a leaf, else the second child; the first child follows its parent
        std::int32_t count;  ///< balls of a leaf, 0 for an inner node
    };
    std::int32_t build(std::size_t begin, std::size_t end);
    double reach(const Node& node, double best) const { return (best - node.size) * inverse_slope_; }

    double through_tree(const Vec3& p) const;

    std::vector<SourceBall> balls_;
    std::vector<Node> nodes_;
    double slope_ = 0, inverse_slope_ = 0, limit_ = std::numeric_limits<double>::infinity();
    CandidateOctree candidates_;
};

}  // namespace featuremesh

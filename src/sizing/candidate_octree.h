// SPDX-License-Identifier: GPL-3.0-or-later
// For every place the few balls that can be the smallest one there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sizing/source_ball.h"

namespace featuremesh {

/// Octree whose leaves list the balls that reach the minimum somewhere within them; a query goes through one list.
/// Leaves where too many balls compete (far away from many equal ones) have none, and the caller has to look elsewhere.
class CandidateOctree {
  public:
    CandidateOctree() = default;
    CandidateOctree(std::span<const SourceBall> balls, double slope, double limit, const Box& box);

    /// The minimum at p, at most the limit; negative when this tree does not know.
    double at(std::span<const SourceBall> balls, const Vec3& p) const;

  private:
    struct Node {
        std::int32_t first = 0;  ///< first of eight children, or of the candidates
        std::int32_t count = 0;  ///< candidates of a leaf; `inner` or `crowded`
    };
    static constexpr std::int32_t inner = -1, crowded = -2;
    void build(std::size_t node, const Box& box, int depth, std::span<const SourceBall> balls,
               const std::vector<std::int32_t>& candidates);

    Box box_;
    double slope_ = 0, inverse_slope_ = 0, limit_ = 0;
    std::vector<Node> nodes_;
    std::vector<std::int32_t> candidates_;
};

}  // namespace featuremesh

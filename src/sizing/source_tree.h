// SPDX-License-Identifier: GPL-3.0-or-later
// The growth-limited minimum over many size sources.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "sizing/source_ball.h"

namespace featuremesh {

/// Immutable tree of boxes, eight below each. The field is the exact minimum of size_i + slope * max(0, |x - center_i|
/// - radius_i), so it is Lipschitz with the slope by itself. A query begins with the balls that answered the one
/// before, if that was near, else it first goes down to where the least size is to be expected, which is mostly the
/// answer; then it goes into what may hold less still. Boxes are looked at four at a time, in single precision, rounded
/// to be safe; what the balls ask for is found in double precision.
class SourceTree {
  public:
    SourceTree() = default;
    /// The field is nowhere above `limit`.
    SourceTree(std::vector<SourceBall> sources, double slope, double limit);

    bool empty() const { return balls_.empty(); }
    double smallest() const { return smallest_; }
    double at(const Vec3& p) const;
    std::span<const SourceBall> balls() const { return balls_; }

  private:
    static constexpr int width = 8, lanes = 4;
    using Lanes =
        float __attribute__((vector_size(lanes * sizeof(float))));  ///< numbers for half of the boxes below a node
    using Bits = std::int32_t __attribute__((vector_size(lanes * sizeof(std::int32_t))));
    using Point = std::array<float, 3>;
    struct Range {
        std::size_t begin, end;
    };
    /// What is below a node: balls, or with count 0 another node.
    struct Below {
        std::int32_t first = 0, count = 0;
    };
    struct Node {
        std::array<std::array<Lanes, 2>, 3> low, high;  ///< of the balls, from the origin
        std::array<Lanes, 2> size;                      ///< smallest one; infinite where nothing is below
        std::array<Below, width> below;
    };

    std::int32_t build(Range range);
    Range halve(Range& range);
    void bound(Node& node, int slot, Range range);
    static Lanes squared_distances(const Node& node, int half, const Point& p);
    double lowest_of(const Below& leaf, const Vec3& p, double best) const;
    Below first_guess(const Point& point) const;
    unsigned boxes_near(const Node& node, const Point& point, double best) const;

    std::vector<SourceBall> balls_;
    std::vector<Node> nodes_;
    Vec3 origin_;
    float margin_ = 0;  ///< mm, rounding errors of boxes and points in single precision
    double slope_ = 0, inverse_slope_ = 0, limit_ = std::numeric_limits<double>::infinity();
    double smallest_ = std::numeric_limits<double>::infinity();
};

/// Balls that only one of the two has.
std::vector<SourceBall> balls_of_one(const SourceTree& a, const SourceTree& b);

}  // namespace featuremesh

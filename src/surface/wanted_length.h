// SPDX-License-Identifier: GPL-3.0-or-later
// The size field, made smaller where a first mesh of the surface crossed itself.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry.h"
#include "sizing/sizing_field.h"
#include "sizing/source_ball.h"
#include "sizing/source_tree.h"

namespace featuremesh {

class WantedLength {
  public:
    /// The field must outlive this.
    explicit WantedLength(const SizingField& field) : field_(field) {}
    explicit WantedLength(SizingField&&) = delete;

    /// mm
    double at(const Vec3& p) const { return std::min(field_.at(p), limits_.at(p)); }
    double largest() const { return field_.largest(); }
    bool is_uniform() const { return limits_.empty() && field_.is_uniform(); }
    /// Near the points no longer than this, growing away from them. A limit that others imply is left out.
    void limit(std::span<const SizeSource> sources) {
        std::vector<SourceBall> balls;
        for (const SizeSource& source : sources) {
            const auto implies = [&](const SourceBall& known) {
                return known.lower(infinity, source.point, growth, 1 / growth) <= 1.2 * source.size;
            };
            if (limits_.at(source.point) > 1.2 * source.size && std::none_of(balls.begin(), balls.end(), implies))
                balls.push_back({source.point, 0, source.size});
        }
        balls.insert(balls.end(), limits_.balls().begin(), limits_.balls().end());
        limits_ = SourceTree(std::move(balls), growth, infinity);
    }

  private:
    static constexpr double growth = 0.3, infinity = std::numeric_limits<double>::infinity();
    const SizingField& field_;
    SourceTree limits_;
};

}  // namespace featuremesh

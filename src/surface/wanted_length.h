// SPDX-License-Identifier: GPL-3.0-or-later
// The size field, made smaller where a first mesh of the surface crossed itself.
#pragma once

#include <algorithm>
#include <vector>

#include "core/geometry.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

class WantedLength {
  public:
    explicit WantedLength(const SizingField& field) : field_(field) {}

    /// mm
    double at(const Vec3& p) const {
        double h = field_.at(p);
        for (const SizeSource& limit : limits_) h = std::min(h, limit.size + growth * distance(p, limit.point));
        return h;
    }
    double largest() const { return field_.largest(); }
    bool is_uniform() const { return limits_.empty() && field_.is_uniform(); }
    /// Near the point no longer than this, growing away from it. A limit that others imply is left out.
    void limit(const SizeSource& source) {
        const auto implies = [&](const SizeSource& known) {
            return known.size + growth * distance(known.point, source.point) <= 1.2 * source.size;
        };
        if (std::none_of(limits_.begin(), limits_.end(), implies)) limits_.push_back(source);
    }

  private:
    static constexpr double growth = 0.3;
    const SizingField& field_;
    std::vector<SizeSource> limits_;
};

}  // namespace featuremesh

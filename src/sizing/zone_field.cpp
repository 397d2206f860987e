// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/zone_field.h"

#include <algorithm>
#include <limits>

namespace featuremesh {

namespace {
constexpr double endless = std::numeric_limits<double>::infinity();
}

GradedSize::GradedSize(const SizeZone& zone, double size, double steepest)
    : inner(zone.inner),
      outer(zone.outer > 0 ? std::min(zone.outer, std::max(size, zone.inner)) : std::max(size, zone.inner)),
      slope_of_field(steepest) {
    const double least = outer <= inner ? 0 : steepest > 0 ? (outer - inner) / steepest : endless;
    transition = std::max(zone.transition, least);
}

double GradedSize::at(double distance) const {
    if (distance >= transition) return outer + slope_of_field * (distance - transition);
    return inner + (outer - inner) / transition * distance;
}

double GradedSize::reach(double limit) const {
    if (limit <= inner) return 0;
    if (limit <= outer) return (limit - inner) / (outer - inner) * transition;
    return slope_of_field > 0 ? transition + (limit - outer) / slope_of_field : endless;
}

std::vector<Box> where_different(const ZoneField& a, const ZoneField& b, double limit) {
    if (!(a.graded_ == b.graded_)) return {a.felt_in(limit), b.felt_in(limit)};
    std::vector<Box> boxes = where_different(a.distance_, b.distance_);
    for (Box& box : boxes) box = box.grown(a.graded_.reach(limit));
    return boxes;
}

}  // namespace featuremesh

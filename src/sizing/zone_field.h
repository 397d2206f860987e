// SPDX-License-Identifier: GPL-3.0-or-later
// The size that one zone asks for at a point.
#pragma once

#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "sizing/size_zone.h"
#include "sizing/zone_distance.h"

namespace featuremesh {

/// The size by the distance from a zone: it grows evenly to the outer size over the transition, and from there on with
/// the slope of the field. The transition is long enough that it is nowhere steeper than that, so that the growth is a
/// Lipschitz bound of the zone, too.
struct GradedSize {
    double inner = 0, outer = 0;  ///< mm
    double slope_of_field = 0;    ///< growth - 1
    double transition = 0;        ///< mm; infinite where sizes do not grow

    /// `size` in mm is the global one.
    GradedSize(const SizeZone& zone, double size, double steepest);

    double at(double distance) const;
    double reach(double limit) const;  ///< mm to where the size is `limit`; infinite where sizes do not grow
    bool operator==(const GradedSize&) const = default;
};

class ZoneField {
  public:
    ZoneField(const Brep& brep, const SizeZone& zone, double size, double slope_of_field)
        : distance_(brep, zone), graded_(zone, size, slope_of_field) {}

    double smallest() const { return graded_.inner; }
    /// False where it asks for nothing below the global size, or is near nothing that the part has.
    bool asks_for_less_than(double size) const { return graded_.inner < size && !distance_.box().is_empty(); }
    /// The smaller of `best` and what is asked for at p.
    double lower(double best, const Vec3& p) const {
        return graded_.inner >= best ? best : std::min(best, graded_.at(distance_.at(p)));
    }
    /// Of p from the zone, mm.
    double distance(const Vec3& p) const { return distance_.at(p); }
    const GradedSize& graded() const { return graded_; }

    /// Boxes outside of which both ask for the same, or for `limit` or more.
    friend std::vector<Box> where_different(const ZoneField& a, const ZoneField& b, double limit);
    /// Outside of this box it asks for `limit` or more.
    Box felt_in(double limit) const { return distance_.box().grown(graded_.reach(limit)); }

  private:
    ZoneDistance distance_;
    GradedSize graded_;
};

std::vector<Box> where_different(const ZoneField& a, const ZoneField& b, double limit);

}  // namespace featuremesh

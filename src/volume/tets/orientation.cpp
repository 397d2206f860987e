// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/tets/orientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace featuremesh {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

Point converted(const Vec3& p) { return {p.x, p.y, p.z}; }

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return CGAL::orientation(converted(a), converted(b), converted(c), converted(d));
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/ignored_details.h"

#include <algorithm>

#include "sizing/sizing_field.h"
#include "surface/merged_entities.h"

namespace featuremesh {

double ignorable_below(const Brep& brep, const MeshOptions& options) {
    constexpr double share_of_size = 1e-3;
    if (options.ignore_below != 0 || options.ignored_below > 0) return 0;
    double smallest = options.sizing.size;
    for (const LocalSize& local : options.sizing.local) smallest = std::min(smallest, local.size);
    const double below = share_of_size * smallest;
    return MergedEntities(brep, below).is_same_as(MergedEntities(brep)) ? 0 : below;
}

}  // namespace featuremesh

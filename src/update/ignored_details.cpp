// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/ignored_details.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cstddef>

#include "core/ids.h"
#include "sizing/size_zone.h"
#include "sizing/sizing_field.h"
#include "surface/merged_entities.h"

namespace featuremesh {

namespace {

/// The mean thickness of a solid's walls, mm.
double thickness(const Brep& brep, SolidId solid) {
    GProp_GProps area;
    BRepGProp::SurfaceProperties(brep.solid(solid), area);
    return 2 * brep.volume_of(solid) / area.Mass();
}

/// The length, or less where a solid is so thin that it would go with what is below it.
double that_spares_solids(const Brep& brep, double length) {
    constexpr double share_of_thickness = 0.25;
    const double diagonal = brep.tolerances().diagonal;
    for (std::size_t s = 0; s < brep.solid_count(); ++s)
        if (brep.volume_of(SolidId(s)) < length * diagonal * diagonal)  // others are thicker
            length = std::min(length, share_of_thickness * thickness(brep, SolidId(s)));
    return length;
}

}  // namespace

double length_to_ignore(const Brep& brep, const MeshOptions& options) {
    constexpr double share_of_size = 5e-3, share_of_local = 0.02, share_of_diagonal = 5e-4;
    if (options.ignore_below != 0) return std::max(0.0, options.ignore_below);
    double below = std::min(share_of_size * options.sizing.size, share_of_diagonal * brep.tolerances().diagonal);
    for (const LocalSize& local : options.sizing.local) below = std::min(below, share_of_local * local.size);
    for (const SizeZone& zone : options.sizing.zones) below = std::min(below, share_of_local * zone.inner);
    return that_spares_solids(brep, below);
}

bool ignore_the_same(const Brep& brep, double length, double other) {
    return length == other || MergedEntities(brep, length).is_same_as(MergedEntities(brep, other));
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// The volumes between faces that vanished and faces that appeared, without intersecting anything.
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

#include "core/geometry.h"

namespace featuremesh {

/// The faces, oriented as in their solids, that only the shape before has and that only the one after has.
struct PatchInput {
    const std::vector<TopoDS_Shape>&vanished, &appeared;
    const std::vector<double>&flux_of_vanished, &flux_of_appeared;  ///< from `apex`, see flux.h
    Vec3 apex;
};

struct PatchVolumes {
    std::vector<TopoDS_Shape> added, removed;  ///< solids
    double change = 0;                         ///< volume of what was added less that of what was removed, mm^3
};

/// What lies between the shapes before and after a change, when all that is new in either ends along edges of the
/// other: a fillet, a chamfer, a pocket. The vanished faces and, turned round, those that appeared bound what was
/// removed less what was added; where both cover the same surface, only the difference of their trims counts
/// (surface_caps.h). The faces that are left are put together to shells along the edges that two of them share; their
/// orientation says what was removed and what added. Nothing where that is not enough: faces that cross each other,
/// more than two at an edge.
std::optional<PatchVolumes> patch_volumes(const PatchInput& input);

}  // namespace featuremesh

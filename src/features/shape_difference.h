// SPDX-License-Identifier: GPL-3.0-or-later
// What a feature added and removed, from the shapes before and after it.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

#include "core/run_context.h"
#include "features/same_faces.h"

namespace featuremesh {

struct ShapeDifference {
    std::vector<TopoDS_Shape> added, removed;  ///< solids
    bool closed = false;                       ///< their volumes account for the change of volume
    bool is_hopeless = false;                  ///< not closed, and not for want of time
    ChangeOutline outline = {};                ///< of the faces between which they lie
};

/// Works on the faces only that the two shapes do not share (see same_faces.h): they bound all that was added or
/// removed, and the rest of the part costs nothing. Where that does not account for the change of volume, whole
/// booleans. All attempts together may take `seconds` of the processor. Either shape may be null: nothing before, or
/// nothing left. `known`, of an earlier state of the feature, is the answer where the outline is the same, also when
/// nothing could be told then. Throws Cancelled.
ShapeDifference difference_of(const TopoDS_Shape& before, const TopoDS_Shape& after, double seconds,
                              RunContext& context, const ShapeDifference* known = nullptr);

}  // namespace featuremesh

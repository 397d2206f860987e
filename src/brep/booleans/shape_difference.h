// SPDX-License-Identifier: GPL-3.0-or-later
// What a feature added and removed, from the shapes before and after it.
#pragma once

#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <vector>

#include "brep/same_faces.h"
#include "core/run_context.h"
#include "core/work.h"

namespace featuremesh {

struct ShapeDifference {
    std::vector<TopoDS_Shape> added, removed;  ///< solids
    bool closed = false;                       ///< their volumes account for the change of volume
    bool is_hopeless = false;                  ///< not closed, and not because the work was over
    ChangeOutline outline = {};                ///< of the faces between which they lie
    std::uint64_t print = 0;                   ///< of those faces; none where it was not asked for
    Work work = 0;                             ///< that the kernel did for it
};

/// Works on the faces only that the two shapes do not share (see same_faces.h): they bound all that was added or
/// removed, and the rest of the part costs nothing. Where that does not account for the change of volume, whole
/// booleans. All attempts together may take the work `most`. Either shape may be null: nothing before, or nothing left.
/// `known`, of an earlier state of the feature, is the answer, also when nothing could be told then, where the faces
/// are the same to the last bit, or their outline is and the volumes account for the change.
/// Throws Cancelled.
ShapeDifference difference_of(const TopoDS_Shape& before, const TopoDS_Shape& after, Work most, RunContext& context,
                              const ShapeDifference* known = nullptr);

}  // namespace featuremesh

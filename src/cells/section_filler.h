// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's intersection, without the work for sections of faces that are edges of both faces already.
#pragma once

#include "brep/booleans/counted_filler.h"

namespace featuremesh {

/// Faces of features mostly meet where one of them ends: a hole is as long as the plate is thick, a boss stands on a
/// face. The intersection of edges with faces then finds all that the faces have in common, and the section of their
/// surfaces adds nothing. The kernel compares it with every edge in either face all the same: with n features on a
/// plate these are n^2 comparisons. Here sections that are lines and circles are dropped before if common edges cover
/// them.
class SectionFiller : public CountedFiller {
  public:
    void PerformFF(const Message_ProgressRange& range) override;
};

}  // namespace featuremesh

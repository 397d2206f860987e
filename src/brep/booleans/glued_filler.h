// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's intersection of faces that meet along edges only.
#pragma once

#include "brep/booleans/counted_filler.h"

namespace featuremesh {

/// Faces are glued, not intersected, so that all that can divide one of them are edges and vertices on its surface. The
/// kernel intersects every edge with every face around it all the same, which is most of its work where faces are
/// curved. Here only edges and vertices that lie on the face's surface are shown to it.
class GluedFiller : public CountedFiller {
  public:
    GluedFiller();

  protected:
    void Init(const Message_ProgressRange& range) override;
};

}  // namespace featuremesh

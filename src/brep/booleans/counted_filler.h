// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's intersection of shapes, which pays for its work before it does it.
#pragma once

#include <BOPAlgo_PaveFiller.hxx>

#include "brep/booleans/work_limit.h"

namespace featuremesh {

/// Nearly all work of the kernel's booleans are the intersections of pairs of edges and faces, and between two
/// questions whether to go on lies a whole one. So the pairs are counted before, each at the price of its curves and
/// surfaces.
class CountedFiller : public BOPAlgo_PaveFiller {
  public:
    CountedFiller() : BOPAlgo_PaveFiller(NCollection_BaseAllocator::CommonBaseAllocator()) {}

    /// `limit` pays for what is done from now on.
    void pay_from(const Handle(WorkLimit) & limit) { limit_ = limit; }

  protected:
    void PerformEE(const Message_ProgressRange& range) override;
    void PerformEF(const Message_ProgressRange& range) override;
    void PerformFF(const Message_ProgressRange& range) override;

  private:
    void pay_for(TopAbs_ShapeEnum one, TopAbs_ShapeEnum another);

    Handle(WorkLimit) limit_;
};

}  // namespace featuremesh

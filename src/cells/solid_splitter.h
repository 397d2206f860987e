// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's builder reduced to what cells need, without the steps that grow with the square of the features on a
// face.
#pragma once

#include <BOPAlgo_Builder.hxx>
#include <deque>
#include <vector>

#include "core/run_context.h"

namespace featuremesh {

/// A general fuse of solids that makes no more than the solids' and faces' images: no shells, no history and nothing
/// loose within solids. A solid is split by the faces within it. The kernel looks for them among all faces whose
/// boxes meet the solid's, and goes over all edges of these: over the face of a plate with n features once for each.
/// Here a face with a vertex outside of the solid's box is none of them and is not even shown to the kernel. Solids
/// must not be inside out.
class SolidSplitter : public BOPAlgo_Builder {
  public:
    /// Runs in parallel where `context` has several threads.
    explicit SolidSplitter(RunContext& context) : context_(context) {
        SetCheckInverted(false);
        SetRunParallel(context.threads > 1);
    }

    /// What became of a solid or a face of the arguments: itself if it was not divided, nothing if it is gone.
    std::vector<TopoDS_Shape> images_of(const TopoDS_Shape& shape) const;

  protected:
    void PerformInternal1(const BOPAlgo_PaveFiller& filler, const Message_ProgressRange& range) override;

  private:
    class Faces;
    struct Split;
    void split_faces(const Message_ProgressRange& range);
    void split_solids(const Message_ProgressRange& range);
    bool find_inner_faces(Faces& faces, int solid, Split& split, const Message_ProgressRange& range);
    void divide(std::deque<Split>& splits, const Message_ProgressRange& range);
    void join(const std::deque<Split>& splits);
    void collect();
    bool are_faces_divided(const TopoDS_Shape& shell) const;

    RunContext& context_;
};

}  // namespace featuremesh

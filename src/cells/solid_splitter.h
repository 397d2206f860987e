// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's builder of cells, with a search for the faces within each solid that does not grow with their square.
#pragma once

#include <BOPAlgo_Builder.hxx>

namespace featuremesh {

/// A solid is split by the faces within it. The kernel looks for them among all faces whose boxes meet the solid's, and
/// goes over all edges of these: over the face of a plate with n features once for each. Here a face with a vertex
/// outside of the solid's box is none of them and is not even shown to the kernel. Solids must not be inside out.
class SolidSplitter : public BOPAlgo_Builder {
  public:
    SolidSplitter() { SetCheckInverted(false); }

  protected:
    void FillIn3DParts(TopTools_DataMapOfShapeShape& drafts, const Message_ProgressRange& range) override;

  private:
    class Faces;
    void find_inner_faces(Faces& faces, int solid, TopTools_DataMapOfShapeShape& drafts,
                          const Message_ProgressRange& range);
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's builder of solids from faces, with a search for shells that does not grow with the square of a face's
// edges.
#pragma once

#include <BOPAlgo_BuilderSolid.hxx>
#include <BOPTools_ConnexityBlock.hxx>
#include <TopTools_ListOfShape.hxx>

namespace featuremesh {

/// The pieces into which faces divide a solid: SetShapes takes the faces of its border, and those within it twice, once
/// in either orientation; Areas() are the pieces. Having put together a shell the kernel goes over the edges of both
/// faces at every edge of it, in case one of them lies within a face: over the n edges of a plate's face n times.
/// Shells without such edges are found here, in the kernel's order and by its choice of the next face; all others by
/// the kernel.
class SolidPieces : public BOPAlgo_BuilderSolid {
  protected:
    void PerformLoops(const Message_ProgressRange& range) override;

  private:
    TopTools_ListOfShape shells_of(BOPTools_ConnexityBlock& block) const;
};

}  // namespace featuremesh

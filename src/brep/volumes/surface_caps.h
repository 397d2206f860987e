// SPDX-License-Identifier: GPL-3.0-or-later
// Where a surface is covered by faces before and not by faces after, or the other way round.
#pragma once

#include <vector>

#include "brep/volumes/merged_edges.h"
#include "brep/volumes/patch_faces.h"
#include "brep/volumes/period_shifts.h"

namespace featuremesh {

/// One connected region of a surface, without holes in its midst but those that its wires say.
struct SurfaceCap {
    /// A use of an edge in the region's border.
    struct Coedge {
        std::size_t face = 0;  ///< the face that the use is from, on the same surface
        MergedEdges::Use use;
        int sense = 1;     ///< along the use's piece or against it, with the region to the left in `on`
        Parameters shift;  ///< whole periods that bring the edge's curve on `face` to the region's border in `on`
    };
    std::size_t on = 0;     ///< the face, oriented forward, on whose surface it lies
    bool vanished = false;  ///< covered before
    std::vector<std::vector<Coedge>> wires;
};

/// The borders of the faces of each underlying surface (PatchFace::underlying), with those that appeared turned round,
/// cancel where both have them; what is left bounds the regions. Throws Standard_Failure where it does not bound any.
std::vector<SurfaceCap> surface_caps(const std::vector<PatchFace>& faces, const MergedEdges& edges);

}  // namespace featuremesh

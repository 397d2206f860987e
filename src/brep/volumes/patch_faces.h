// SPDX-License-Identifier: GPL-3.0-or-later
// The faces that only one of two shapes has, by the surfaces that they are cut from.
#pragma once

#include <TopoDS_Face.hxx>
#include <vector>

namespace featuremesh {

/// A face that only one of two shapes has, oriented as in its solid.
struct PatchFace {
    TopoDS_Face face;
    bool vanished = false;  ///< only the shape before has it, else only the one after
    /// The same for faces cut from one surface (for planes) with the same parameters (for others), with the material in
    /// the same direction, of which some vanished and some appeared; -1 for a face that is alone on its surface.
    int underlying = -1;
    std::size_t index = 0;  ///< among those that vanished or those that appeared
};

/// Those that are alone on their surfaces first, and of these those that appeared.
std::vector<PatchFace> patch_faces(const std::vector<TopoDS_Shape>& vanished,
                                   const std::vector<TopoDS_Shape>& appeared);

}  // namespace featuremesh

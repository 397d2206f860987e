// SPDX-License-Identifier: GPL-3.0-or-later
// Whether an edge meets a face elsewhere than in its border.
#pragma once

#include <TopoDS_Face.hxx>
#include <vector>

#include "brep/volumes/merged_edges.h"
#include "brep/volumes/patch_faces.h"
#include "core/geometry.h"

namespace featuremesh {

/// A face with the pieces of its border.
struct ContactSheet {
    TopoDS_Face face;
    Box box;
    bool vanished = false;    ///< of the shape before
    std::vector<int> border;  ///< pieces
};

/// Whether a piece of an edge that only one of the shapes has goes through a sheet of the other, or lies within it:
/// then the sheets cross or touch each other where no edge says so. `faces` are those that the edges are from.
bool any_contact(const std::vector<ContactSheet>& sheets, const std::vector<PatchFace>& faces,
                 const MergedEdges& edges);

}  // namespace featuremesh

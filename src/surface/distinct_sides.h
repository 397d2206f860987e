// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps coarse faces from sharing more than their edges.
#pragma once

#include <span>

#include "core/ids.h"
#include "mesh/mesh.h"
#include "surface/chart.h"
#include "surface/face_boundary.h"
#include "surface/fill_face.h"

namespace featuremesh {

/// One filled face.
struct FilledFace {
    const Chart* chart = nullptr;
    const FaceBoundary* boundary = nullptr;
    FaceFilling* filling = nullptr;
};

/// Where two faces (or both copies of a seam) join the same two edge nodes by an inner side, or the same three nodes by
/// a triangle, the surface would touch itself: an inner node is put in. `mesh` has the chains' nodes and the kept
/// triangles; `segments` are all sides of the chains. Returns how many nodes were added.
std::size_t make_sides_distinct(std::span<FilledFace> faces, std::span<const std::array<NodeId, 2>> segments,
                                const Mesh& mesh);

}  // namespace featuremesh

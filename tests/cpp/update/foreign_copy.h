// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh of ours as another program would hand it over.
#pragma once

#include <algorithm>

#include "mesh/mesh.h"

namespace featuremesh {

/// Nothing is known of the shape any more, and the corners of the tets are numbered as SMESH does.
inline Mesh foreign_copy(const Mesh& mesh) {
    Mesh foreign = mesh;
    std::fill(foreign.entities.begin(), foreign.entities.end(), Entity{});
    std::fill(foreign.parameters.begin(), foreign.parameters.end(), std::array<double, 2>{0, 0});
    std::fill(foreign.triangle_faces.begin(), foreign.triangle_faces.end(), FaceId());
    std::fill(foreign.segment_edges.begin(), foreign.segment_edges.end(), EdgeId());
    std::fill(foreign.tet_solids.begin(), foreign.tet_solids.end(), SolidId());
    for (auto& tet : foreign.tets) std::swap(tet[1], tet[2]);
    for (auto& m : foreign.tet_mids) m = {m[2], m[1], m[0], m[3], m[5], m[4]};
    return foreign;
}

}  // namespace featuremesh

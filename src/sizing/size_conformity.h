// SPDX-License-Identifier: GPL-3.0-or-later
// How well a mesh obeys the wanted edge lengths.
#pragma once

#include <array>
#include <cstdint>

#include "mesh/mesh.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// Edge lengths over the lengths wanted at the edges' middles.
struct SizeConformity {
    double share_within = 1;                   ///< of the edges, with a ratio of 0.7 to 1.4
    double mean = 1;                           ///< of the ratios
    std::array<std::int64_t, 20> histogram{};  ///< ratios in bins of 0.1; the last one has all from 1.9
};

/// The sides of at most about 900 tets (of triangles, or segments, where there are none), taken evenly from the mesh's
/// order; an edge counts once for each of these elements it is a side of.
SizeConformity measure_size_conformity(const Mesh& mesh, const SizingField& sizing);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Which nodes and elements of a mesh are those of the mesh before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/run_context.h"
#include "mesh/mesh.h"
#include "update/fill_part.h"
#include "update/made_for.h"

namespace featuremesh {

/// Indices in the mesh before, -1 for what is new. Elements are those that fill the part.
struct MeshOrigin {
    std::vector<std::int32_t> nodes, elements;
    MadeFor made_for = {};  ///< of kept nodes
};

/// Of a filling beside what was kept of the mesh `before`: all that the filling did not move or release.
MeshOrigin origin_of(const Filled& filled, MeshOrigin kept, const Mesh& before, std::size_t element_count,
                     const RunContext& context);

/// Of a mesh whose `later` origin is in a mesh that has the `earlier` one.
MeshOrigin through(const MeshOrigin& earlier, const MeshOrigin& later);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that are meshed and updated as most tests want it.
#pragma once

#include "update/part_mesh.h"

namespace featuremesh {

inline MeshOptions options_of(double size, int order = 1, Dimension dimension = Dimension::from_shape) {
    MeshOptions options;
    options.sizing.size = size;
    options.order = order;
    options.dimension = dimension;
    return options;
}

inline PartMeshResult meshed(const RawDocument& document, const MeshOptions& options, int threads = 1) {
    RunContext context;
    context.threads = threads;
    return mesh_part(document, options, context);
}

inline PartMeshResult updated(const PartMesh& old, const RawDocument& document, const MeshOptions& options,
                              int threads = 1) {
    RunContext context;
    context.threads = threads;
    return update_part(old, document, options, context);
}

}  // namespace featuremesh

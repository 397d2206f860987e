// SPDX-License-Identifier: GPL-3.0-or-later
// Small angles of a mesh from scratch are mended where they are.
#pragma once

#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/run_context.h"
#include "sizing/sizing_field.h"
#include "update/fill_part.h"
#include "update/options.h"
#include "update/size_request.h"

namespace featuremesh {

/// Where tets have angles below 10 degrees that the shape does not force, what is around them is filled again with
/// shorter edges, and the rest is kept, as in an update. Of `whole`, a mesh of tets that keeps nothing, only the mesh
/// changes. Each filling is noted in `rounds`. `sources` are the field's own.
void mend_small_angles(const Brep& brep, MeshOptions options, std::span<const SizeSource> sources, Filled& whole,
                       std::vector<Round>& rounds, RunContext& context);

}  // namespace featuremesh

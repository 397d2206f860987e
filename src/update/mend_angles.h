// SPDX-License-Identifier: GPL-3.0-or-later
// Small angles of new tets are mended where they are.
#pragma once

#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/run_context.h"
#include "sizing/sizing_field.h"
#include "update/fill_part.h"
#include "update/mesh_origin.h"
#include "update/options.h"
#include "update/size_request.h"

namespace featuremesh {

/// Where tets have angles below 10 degrees that the shape does not force, what is around them is filled again with
/// shorter edges, and the rest is kept, as in an update. Of `filled` only the mesh changes. `origin`: that of its mesh,
/// after an update, and then of the one that comes out; tets that were there before are left alone. None where all is
/// new. Each filling is noted in `rounds`; where the kernel fails the mesh stays. `sources` are the field's own.
void mend_small_angles(const Brep& brep, MeshOptions options, std::span<const SizeSource> sources, Filled& filled,
                       MeshOrigin* origin, std::vector<Round>& rounds, RunContext& context);

}  // namespace featuremesh

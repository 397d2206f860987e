// SPDX-License-Identifier: GPL-3.0-or-later
// What of another maker's mesh fits a shape, as a kept mesh of ours.
#pragma once

#include <vector>

#include "core/message.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "update/foreign_surface.h"
#include "update/keep.h"

namespace featuremesh {

struct ForeignFit {
    Kept kept;  ///< origins are indices in the foreign mesh; no rim, nothing is proven yet
    std::size_t released_tets = 0;
    std::size_t moved_mids = 0;    ///< mid-side nodes off the surface: their elements stay, and get new ones on it
    std::vector<Message> reasons;  ///< why tets were released
};

/// Takes points, numbers and connectivity of a foreign mesh as they are (all else is found anew) and releases the tets
/// that do not fit: inverted or folded ones, what touches boundary nodes off the surface, what covers no face or
/// follows no edge, what lies outside. `layers` more layers of tets around those are released. Throws InputError when
/// no tet fits.
ForeignFit fit_to_shape(const Brep& brep, Mesh foreign, int layers, RunContext& context);

}  // namespace featuremesh

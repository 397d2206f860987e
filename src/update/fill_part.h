// SPDX-License-Identifier: GPL-3.0-or-later
// The one operation of full meshes and updates alike: fills whatever of a part is not meshed yet.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/message.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "mesh/validation.h"
#include "sizing/sizing_field.h"
#include "surface/fill_surface.h"
#include "surface/merged_entities.h"
#include "update/keep.h"
#include "update/options.h"
#include "update/size_request.h"
#include "volume/fill_solids.h"

namespace featuremesh {

constexpr double elements_that_bend = 2;  ///< across a wall: no tet may span it then

/// What a valid mesh of the part has.
Expectation expectation_of(const Brep& brep);

struct Filled {
    Mesh mesh;
    SurfaceReport surface;
    VolumeReport volume = {};
    std::vector<TetId> released = {};
    std::vector<NodeId> moved = {};
    std::vector<Vec3> used_active = {};
    std::shared_ptr<const MergedEntities> merged = {};  ///< as they were filled
    std::optional<SizingField> sizing = {};             ///< as asked; what the mesher itself made shorter is not in it
    std::vector<SizeSource> shorter = {};               ///< edges than asked, where the mesher needed them
    bool refines_narrow_faces = false;                  ///< the sizing does
    /// Why some sides of 10-node tets are straight on a curved face (StraightSides); empty where none are.
    Message why_straight = {};
    std::size_t straight_sides = 0;  ///< on the shape, but straight
    double smallest_jacobian = 1;    ///< scaled, of new 10-node elements, where some miss the aim
};

/// What to fill a full mesh from.
Kept nothing_kept(NextNumbers next);

/// Surface, volume (of solids only), mid-side nodes and validation of all that is not kept. Whatever finds that a place
/// needs other lengths asks for them, and all is filled again with these, as often as `rounds` leaves room for; each is
/// noted there. `sources` are the field's own. Beside kept elements only folded ones ask, unless all may, as where a
/// filling without has failed. The refusal of the last where no valid mesh can be made.
std::variant<Filled, Message> fill_part(const Brep& brep, const SizingField& sizing, Kept kept,
                                        const MeshOptions& options, std::span<const SizeSource> sources,
                                        std::vector<Round>& rounds, RunContext& context, bool all_may_ask = false);

}  // namespace featuremesh

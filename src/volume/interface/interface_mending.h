// SPDX-License-Identifier: GPL-3.0-or-later
// Kept tets are released where tets at the interface would be bad or poor with them.
#pragma once

#include <cstdint>
#include <span>

#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "volume/improvement/objective.h"
#include "volume/interface/interface_region.h"

namespace featuremesh {

/// Takes the kept tets around bad tets at the interface into their regions, a ring more each time, and improves there.
/// `is_released` by TetId: what is taken in is marked.
void mend_interfaces(std::span<InterfaceRegion> regions, const Mesh& mesh, std::span<std::uint8_t> is_released,
                     const Objective& objective, RunContext& context);

/// Takes the kept tets around inner nodes of the interface in whose new tets are poor, and moves these nodes, and new
/// ones beside them, where the radius ratios gain much by that. `rim`: all kept tets with such nodes are among them
/// (empty: not known). Regions with needles stay as they are. Gives the number of kept tets that are not what they were
/// by that.
std::size_t relax_interfaces(std::span<InterfaceRegion> regions, const Mesh& mesh, std::span<const TetId> rim,
                             std::span<std::uint8_t> is_released, const Objective& objective, RunContext& context);

/// What was taken in and is as it was is kept after all. Gives the number of those that are not.
std::size_t give_back(InterfaceRegion& region, const Mesh& mesh, std::span<std::uint8_t> is_released);

}  // namespace featuremesh

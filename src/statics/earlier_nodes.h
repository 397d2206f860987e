// SPDX-License-Identifier: GPL-3.0-or-later
// Which nodes of a mesh another one had.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace featuremesh {

/// By node that of the same number before, -1 where there was none. Of either the numbers are given, each but once.
std::vector<std::int32_t> earlier_nodes(std::span<const Number> now, std::span<const Number> before);

/// Leaves out (-1) those nodes of whose components, three each, others are held than before.
void leave_alike_held(std::vector<std::int32_t>& earlier, std::span<const char> is_held,
                      std::span<const char> was_held);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Where new nodes start among those that have displacements already.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "statics/model.h"
#include "statics/stiffness.h"

namespace featuremesh {

/// The nodes and their neighbours; ascending. While they are fewer than `enough`, up to so many layers of these.
std::vector<std::int32_t> with_neighbours(std::vector<std::int32_t> nodes, const BlockMatrix& matrix, int layers = 1,
                                          std::size_t enough = 0);

/// Moves new nodes that hang together with the kept ones beside them, as one rigid body as nearly as one can. What is
/// left to be balanced among them is little then. `moved` is (n,3) mm, held components stay.
void move_with_kept(const StaticsModel& model, const BlockMatrix& matrix, std::span<const std::int32_t> fresh,
                    std::span<double> moved);

}  // namespace featuremesh

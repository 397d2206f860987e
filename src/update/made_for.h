// SPDX-License-Identifier: GPL-3.0-or-later
// The edge lengths that kept nodes were made for.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/ids.h"

namespace featuremesh {

/// Only of nodes for which that is not the length wanted there now: sizes that change little by little would release
/// nothing if they were compared with what was asked last.
struct MadeFor {
    std::vector<NodeId> nodes;  ///< ascending
    std::vector<double> sizes;  ///< mm, of each
    std::optional<double> of(NodeId node) const;
};

MadeFor without(MadeFor made_for, std::vector<NodeId> nodes);

}  // namespace featuremesh

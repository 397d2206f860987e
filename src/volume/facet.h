// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles between which solids are filled.
#pragma once

#include <array>

namespace featuremesh {

/// A triangle that bounds what is to be filled. Corners count within one cavity.
struct Facet {
    std::array<int, 3> corners{};
    /// What is to be filled behind the facet (against its right-hand normal) and before it: a solid's index, or -1 for
    /// nothing, because it is outside or already full.
    std::array<int, 2> regions{-1, -1};
};

}  // namespace featuremesh

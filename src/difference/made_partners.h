// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces of a feature's new volumes are those of its old ones.
#pragma once

#include <vector>

#include "difference/made_faces.h"

namespace featuremesh {

/// By index into the old MadeFaces::faces: indices into the new one's. Told by sketch elements and instances of
/// patterns where there are any, else by the order in which the kernel makes the faces of equal sweeps and primitives,
/// unless they point elsewhere now.
std::vector<std::vector<int>> partners_of_made_faces(const MadeFaces& was, const MadeFaces& is);

}  // namespace featuremesh

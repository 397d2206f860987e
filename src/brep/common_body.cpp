// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/common_body.h"

#include <algorithm>

#include "brep/brep.h"

namespace featuremesh {

bool have_common_body(const Brep& brep, FaceId f, FaceId g) {
    const auto a = brep.bodies_of(f), b = brep.bodies_of(g);
    return std::any_of(a.begin(), a.end(), [&](BodyId s) { return s.is_valid() && (s == b[0] || s == b[1]); });
}

}  // namespace featuremesh

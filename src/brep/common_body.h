// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ids.h"

namespace featuremesh {

class Brep;

/// Whether the faces belong to one solid, or to one sheet.
bool have_common_body(const Brep& brep, FaceId f, FaceId g);

}  // namespace featuremesh

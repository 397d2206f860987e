// SPDX-License-Identifier: GPL-3.0-or-later
// Linear statics for Python, apart from what the other binding files share.
#pragma once

#include "bindings.h"

namespace featuremesh {

void define_statics(py::module_& module);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace featuremesh {

/// The most memory that this process has used at once, in MB.
double peak_memory_mb();

}  // namespace featuremesh

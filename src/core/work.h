// SPDX-License-Identifier: GPL-3.0-or-later
// How much work something may take, counted and never timed.
#pragma once

#include <cstdint>

namespace featuremesh {

/// What is worth its work must not depend on how fast or how busy a machine is, so work is counted by what is to be
/// done. The unit is about a microsecond of one processor of the machine on which the prices were measured.
using Work = std::int64_t;

/// The work that took so many seconds of that processor.
constexpr Work work_of_seconds(double seconds) { return static_cast<Work>(1e6 * seconds); }

}  // namespace featuremesh

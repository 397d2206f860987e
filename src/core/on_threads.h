// SPDX-License-Identifier: GPL-3.0-or-later
// A library's own threads, no more of them than the caller allows.
#pragma once

#include <functional>

#include "core/run_context.h"

namespace featuremesh {

/// Runs the work of a library that spreads it by oneTBB itself on no more than `context.threads` threads.
void on_threads(const RunContext& context, const std::function<void()>& work);

}  // namespace featuremesh

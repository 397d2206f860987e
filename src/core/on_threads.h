// SPDX-License-Identifier: GPL-3.0-or-later
// oneTBB's threads, no more of them than the caller allows.
#pragma once

#include <cstddef>
#include <functional>

#include "core/run_context.h"

namespace featuremesh {

/// Runs the work of a library that spreads it by oneTBB itself on no more than `context.threads` threads.
void on_threads(const RunContext& context, const std::function<void()>& work);

/// Runs work(0), ..., work(count - 1), which must not throw, on no more than `context.threads` threads.
void run_on_threads(const RunContext& context, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Work in a process of its own, for libraries that may crash.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/run_context.h"

namespace featuremesh {

/// When a copy of the process no longer counts as one that works.
struct Patience {
    unsigned processor_seconds;   ///< that it may use
    unsigned idle_seconds = 300;  ///< in which it does not use the processor at all
};

/// What `work` returns, from a copy of this process that ends with it; none when the copy crashed or `work` threw
/// there. The copy is ended when the context is cancelled (throws Cancelled), and when the patience with it is at its
/// end (throws MeshError). So it does where somebody else ends the copy, and std::bad_alloc where the copy has too
/// little memory: no other mesh is made because a machine is slow or small. Where there is no fork, `work` runs here.
/// The copy is in a folder in which no file can be made, and is not heard in the terminal. It may use no context but
/// the one that it is given: in the copy, one without a caller.
std::optional<std::vector<std::byte>> run_isolated(
    const std::function<std::vector<std::byte>(const RunContext& context)>& work, const Patience& patience,
    const RunContext& context);

}  // namespace featuremesh

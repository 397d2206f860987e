// SPDX-License-Identifier: GPL-3.0-or-later
// How much work something is, told without a clock: how often it asks for memory. The same in each run, however slow
// the machine is.
#pragma once

#include <cstdint>

namespace featuremesh::test {

/// How often this process has called `operator new` so far.
std::uint64_t blocks_asked_for();

/// How often `work` calls it.
template <class Work>
std::uint64_t blocks_asked_for_by(const Work& work) {
    const std::uint64_t before = blocks_asked_for();
    work();
    return blocks_asked_for() - before;
}

}  // namespace featuremesh::test

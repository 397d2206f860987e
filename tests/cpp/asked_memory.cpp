// SPDX-License-Identifier: GPL-3.0-or-later
#include "asked_memory.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> blocks = 0;

}  // namespace

// The other forms of the standard library call these two.
void* operator new(std::size_t bytes) {
    ++blocks;
    if (void* const block = std::malloc(bytes ? bytes : 1)) return block;
    throw std::bad_alloc();
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }

namespace featuremesh::test {

std::uint64_t blocks_asked_for() { return blocks; }

}  // namespace featuremesh::test

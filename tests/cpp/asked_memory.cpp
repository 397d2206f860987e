// SPDX-License-Identifier: GPL-3.0-or-later
#include "asked_memory.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> blocks = 0;

}  // namespace

// All forms, since those of a sanitizer's library do not call these.
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    ++blocks;
    return std::malloc(bytes ? bytes : 1);
}
void* operator new(std::size_t bytes) {
    if (void* const block = operator new(bytes, std::nothrow)) return block;
    throw std::bad_alloc();
}
void* operator new[](std::size_t bytes, const std::nothrow_t& nothrow) noexcept { return operator new(bytes, nothrow); }
void* operator new[](std::size_t bytes) { return operator new(bytes); }
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { std::free(block); }
void operator delete[](void* block) noexcept { std::free(block); }
void operator delete[](void* block, std::size_t) noexcept { std::free(block); }
void operator delete[](void* block, const std::nothrow_t&) noexcept { std::free(block); }

namespace featuremesh::test {

std::uint64_t blocks_asked_for() { return blocks; }

}  // namespace featuremesh::test

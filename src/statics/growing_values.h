// SPDX-License-Identifier: GPL-3.0-or-later
// Large vectors of numbers that are written once only, on all threads, and grow behind without being moved.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace featuremesh {

/// Numbers that are not set when a vector of them grows.
template <class T>
struct UnsetValues : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UnsetValues<U>;
    };
    template <class U>
    void construct(U* at) noexcept {
        ::new (static_cast<void*>(at)) U;
    }
    template <class U, class... Arguments>
    void construct(U* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
    }
};

template <class T>
using GrowingValues = std::vector<T, UnsetValues<T>>;

/// A matrix with so many blocks has room for some more, an eighth of them. Room that is not used takes no memory.
inline std::size_t with_room(std::size_t blocks) { return blocks + blocks / 8; }

}  // namespace featuremesh

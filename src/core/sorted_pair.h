// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace featuremesh {

/// The two, the lesser first: the same key for a side from both of its ends.
template <class T>
std::array<T, 2> sorted_pair(T a, T b) {
    return b < a ? std::array<T, 2>{b, a} : std::array<T, 2>{a, b};
}

}  // namespace featuremesh

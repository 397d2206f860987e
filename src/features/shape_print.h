// SPDX-License-Identifier: GPL-3.0-or-later
// A number that two shapes share when they are the same to the last bit.
#pragma once

#include <cstdint>

class TopoDS_Shape;

namespace featuremesh {

/// 64 bits of everything the kernel would save of the shape but triangulations. Equal for shapes with the same
/// geometry, topology and place, whatever document they were read from; different ones share it by chance as rarely as
/// a memory error.
std::uint64_t print_of(const TopoDS_Shape& shape);

}  // namespace featuremesh

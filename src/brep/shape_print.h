// SPDX-License-Identifier: GPL-3.0-or-later
// A number that two shapes share when they are the same to the last bit.
#pragma once

#include <cstdint>
#include <span>

class TopoDS_Shape;

namespace featuremesh {

/// 64 bits of topology, orientations, places, surfaces, curves in space and points. Left out is what the kernel adds to
/// a shape that others are cut with: curves in parameter planes (they follow from the rest) and tolerances. Equal for
/// the same shape whatever document it was read from; different ones share it by chance as rarely as a memory error.
std::uint64_t print_of(const TopoDS_Shape& shape);
/// Of all, in their order.
std::uint64_t print_of(std::span<const TopoDS_Shape> shapes);

}  // namespace featuremesh

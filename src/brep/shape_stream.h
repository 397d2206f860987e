// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes as the bytes in which FreeCAD hands them over.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

class TopoDS_Shape;

namespace featuremesh {

/// The children of the compound in FreeCAD's binary BREP form. Throws StateError when it is not one. The kernel trusts
/// what follows its header, so whoever stores the bytes guards them with a checksum.
std::vector<TopoDS_Shape> read_shapes(std::span<const std::byte> bytes);

}  // namespace featuremesh

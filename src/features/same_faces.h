// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces two shapes have in common.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

namespace featuremesh {

/// Faces of the solids of `shape` that those of `other` do not have, oriented as in their solid. The same face is the
/// same TShape in the same place, or, since sharing is lost when a document is saved, a face of the same kind with the
/// same border, inner point and side of material to 1e-9 of the size.
std::vector<TopoDS_Shape> unshared_faces(const TopoDS_Shape& shape, const TopoDS_Shape& other);

}  // namespace featuremesh

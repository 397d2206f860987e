// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two shapes are the same solids in the same place.
#pragma once

class TopoDS_Shape;

namespace featuremesh {

/// The same faces by identity, or the same volume, centre of mass, inertia and box to about 1e-8 of the size. A face
/// split in two makes no difference.
bool same_solids(const TopoDS_Shape& a, const TopoDS_Shape& b);

}  // namespace featuremesh

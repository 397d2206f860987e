// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two shapes are the same solids in the same place.
#pragma once

class TopoDS_Shape;

namespace featuremesh {

/// The same faces, or the same volume, centre of mass, inertia and box to about 1e-8 of the size, and the faces that
/// only one of them has lie on those of the other. A face split in two makes no difference. False
/// where the kernel cannot tell.
bool same_solids(const TopoDS_Shape& a, const TopoDS_Shape& b);

}  // namespace featuremesh

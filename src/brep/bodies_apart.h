// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of one shape that have nothing in common though they are made of the same pieces in the same place.
#pragma once

#include <TopoDS_Shape.hxx>

namespace featuremesh {

/// Have some of the bodies in a compound faces, edges or vertices in common?
bool has_joined_bodies(const TopoDS_Shape& shape);

/// The shape, in which no more bodies have something in common than in `by_kernel`, the same shape where the kernel
/// tells equal places apart.
TopoDS_Shape with_bodies_apart(const TopoDS_Shape& shape, const TopoDS_Shape& by_kernel);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Small shapes, made by the kernel.
#pragma once

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>

namespace featuremesh::test {

inline TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Solid();
}
inline TopoDS_Shape cylinder(gp_Pnt base, gp_Dir axis, double radius, double height) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(base, axis), radius, height).Solid();
}
inline TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Cut(a, b).Shape(); }
inline TopoDS_Shape fused(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Fuse(a, b).Shape(); }

}  // namespace featuremesh::test

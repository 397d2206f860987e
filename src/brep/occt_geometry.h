// SPDX-License-Identifier: GPL-3.0-or-later
// Between the kernel's points and ours, and small questions to faces.
#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <Bnd_Box.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>
#include <vector>

#include "core/geometry.h"

namespace featuremesh {

inline Vec3 to_vec3(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }
inline Vec3 to_vec3(const gp_Vec& v) { return {v.X(), v.Y(), v.Z()}; }
inline gp_Pnt to_pnt(const Vec3& p) { return {p.x, p.y, p.z}; }
inline gp_Vec to_vec(const Vec3& v) { return {v.x, v.y, v.z}; }

inline gp_Trsf to_trsf(const RigidMotion& m) {
    const auto& r = m.rotation;
    gp_Trsf trsf;
    if (!m.is_identity())
        trsf.SetValues(r[0], r[1], r[2], m.translation.x, r[3], r[4], r[5], m.translation.y, r[6], r[7], r[8],
                       m.translation.z);
    return trsf;
}

inline RigidMotion to_motion(const gp_Trsf& trsf) {
    RigidMotion m;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) m.rotation[3 * i + j] = trsf.Value(i + 1, j + 1);
    m.translation = {trsf.Value(1, 4), trsf.Value(2, 4), trsf.Value(3, 4)};
    return m;
}

/// Axis-aligned box that holds the shape (not the tightest); empty for a shape without geometry.
Box box_of(const TopoDS_Shape& shape);

/// Makes the bounds hold the shape, too.
void add_bounds(const TopoDS_Shape& shape, Bnd_Box& bounds);

/// The edges of a face's border as they are in the face when that is oriented forward.
std::vector<TopoDS_Edge> border_of(const TopoDS_Face& face);

inline Box to_box(const Bnd_Box& bounds) {
    Box box;
    if (!bounds.IsVoid()) bounds.Get(box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z);
    return box;
}

/// Unit normal out of the material that the oriented face bounds, from the derivatives of its surface; zero at a pole.
inline Vec3 outward_normal(const TopoDS_Face& face, const gp_Vec& du, const gp_Vec& dv) {
    const gp_Vec normal = du.Crossed(dv);
    if (normal.Magnitude() < 1e-12 * (1e-12 + du.Magnitude() * dv.Magnitude())) return {};
    return normalized(to_vec3(normal)) * (face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0);
}

inline Vec3 outward_normal(const BRepAdaptor_Surface& surface, const TopoDS_Face& face, double u, double v) {
    gp_Pnt point;
    gp_Vec du, dv;
    surface.D1(u, v, point, du, dv);
    return outward_normal(face, du, dv);
}

}  // namespace featuremesh

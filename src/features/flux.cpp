// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/flux.h"

#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "features/occt_geometry.h"

namespace featuremesh {

double flux(const TopoDS_Shape& faces, const Vec3& apex) {
    double sum = 0;
    for (TopExp_Explorer it(faces, TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face& face = TopoDS::Face(it.Current());
        if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED) continue;
        BRepGProp_Face integrand(face);
        if (face.NbChildren() == 0) {
            sum += BRepGProp_Vinert(integrand, to_pnt(apex)).Mass();
        } else {
            BRepGProp_Domain domain(face);
            sum += BRepGProp_Vinert(integrand, domain, to_pnt(apex)).Mass();
        }
    }
    return sum;
}

}  // namespace featuremesh

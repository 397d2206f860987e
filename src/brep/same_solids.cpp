// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/same_solids.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>

#include "brep/occt_geometry.h"
#include "brep/same_faces.h"
#include "core/geometry.h"

namespace featuremesh {

bool same_solids(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    if (a.IsNull() || b.IsNull()) return a.IsNull() && b.IsNull();
    if (unshared_faces(a, b).empty() && unshared_faces(b, a).empty()) return true;
    const Box box_a = box_of(a), box_b = box_of(b);
    const double size = box_a.diagonal(),
                 close = 1e-6 * size;  // boxes are widened by tolerances, hence looser than the rest
    if (distance(box_a.low, box_b.low) > close || distance(box_a.high, box_b.high) > close) return false;
    GProp_GProps mass_a(to_pnt(box_a.center())), mass_b(to_pnt(box_a.center()));
    BRepGProp::VolumeProperties(a, mass_a);
    BRepGProp::VolumeProperties(b, mass_b);
    const double volume = std::abs(mass_a.Mass());
    if (std::abs(mass_a.Mass() - mass_b.Mass()) > 1e-8 * volume) return false;
    if (mass_a.CentreOfMass().Distance(mass_b.CentreOfMass()) > 1e-8 * size) return false;
    for (int row = 1; row <= 3; ++row)
        for (int column = 1; column <= 3; ++column)
            if (std::abs(mass_a.MatrixOfInertia().Value(row, column) - mass_b.MatrixOfInertia().Value(row, column)) >
                1e-7 * volume * size * size)
                return false;
    return true;
}

}  // namespace featuremesh

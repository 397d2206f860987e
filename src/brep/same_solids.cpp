// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/same_solids.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "brep/face_probe.h"
#include "brep/occt_geometry.h"
#include "brep/same_faces.h"
#include "core/geometry.h"

namespace featuremesh {

namespace {

/// Each of the faces has a point inside that lies on one of the others, with the material on the same side.
bool lie_on(const std::vector<TopoDS_Shape>& faces, const std::vector<TopoDS_Shape>& others, double close) {
    std::vector<FaceProbe> probes;
    for (const TopoDS_Shape& other : others) probes.emplace_back(TopoDS::Face(other));
    return std::all_of(faces.begin(), faces.end(), [&](const TopoDS_Shape& face) {
        const FaceProbe probe(TopoDS::Face(face));
        const std::optional<Vec3>& p = probe.inner_point();
        return !p || std::any_of(probes.begin(), probes.end(), [&](const FaceProbe& other) {
            return other.contains(*p, close) && dot(other.normal_at(*p), probe.normal_at(*p)) > 0;
        });
    });
}

/// Of two that there are.
bool are_same(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    const std::vector<TopoDS_Shape> only_a = unshared_faces(a, b), only_b = unshared_faces(b, a);
    if (only_a.empty() && only_b.empty()) return true;
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
    // a disc with a square hole that is turned on the spot has all of that in common
    return lie_on(only_a, only_b, close) && lie_on(only_b, only_a, close);
}

}  // namespace

bool same_solids(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    if (a.IsNull() || b.IsNull()) return a.IsNull() && b.IsNull();
    try {
        return are_same(a, b);
    } catch (const Standard_Failure&) {
        return false;
    }
}

}  // namespace featuremesh

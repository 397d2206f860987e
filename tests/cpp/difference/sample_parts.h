// SPDX-License-Identifier: GPL-3.0-or-later
// Parts made of primitives, as trees of features with volumes.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "difference/feature_difference.h"

namespace featuremesh::test {

/// One feature of a sample part.
struct Primitive {
    std::string name;
    Effect effect = Effect::adds;
    std::vector<TopoDS_Shape> instances;
    std::vector<std::pair<std::string, double>> parameters;
};

TopoDS_Shape box(const Vec3& corner, const Vec3& size);
TopoDS_Shape cylinder(const Vec3& base, const Vec3& axis, double radius, double height);
TopoDS_Shape cone(const Vec3& base, const Vec3& axis, double radius, double top_radius, double height);
TopoDS_Shape sphere(const Vec3& centre, double radius);
TopoDS_Shape torus(const Vec3& centre, const Vec3& axis, double radius, double tube);
/// A bent rod between free-form walls: a closed spline swept along z.
TopoDS_Shape blob(const Vec3& base, double size, double height);
/// A spline turned about an axis, between two discs; `radius` at the ends.
TopoDS_Shape vase(const Vec3& base, const Vec3& axis, double radius, double height);
/// Bounded by B-spline surfaces.
TopoDS_Shape ellipsoid(const Vec3& centre, const Vec3& half_axes);
TopoDS_Shape moved(const TopoDS_Shape& shape, const RigidMotion& motion);
RigidMotion shift(const Vec3& by);
/// About an axis through `centre`.
RigidMotion turn(const Vec3& centre, const Vec3& axis, double angle);

/// The features applied in order; neighbours with the same effect at once.
TopoDS_Shape evaluate(const std::vector<Primitive>& features);
/// With an empty cellular model.
PartState part(const std::vector<Primitive>& features);
PartState part_with_cells(const std::vector<Primitive>& features);

/// 120 x 80 x 15 mm plate with a boss, a bore, a rib and six holes; the first hole at `hole`.
std::vector<Primitive> bracket(const Vec3& hole);
/// A plate with `count` features: a third of them bosses, then holes.
std::vector<Primitive> many_features(int count);

}  // namespace featuremesh::test

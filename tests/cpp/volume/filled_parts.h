// SPDX-License-Identifier: GPL-3.0-or-later
// Parts filled from scratch or between kept tets, and what must hold for each.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "brep/brep.h"
#include "mesh/validation.h"
#include "sizing/sizing_field.h"
#include "surface/fill_surface.h"
#include "volume/fill_cavity.h"
#include "volume/fill_solids.h"

namespace featuremesh::testing {

TopoDS_Shape box_part(const Vec3& low, const Vec3& size);
/// An L of boxes around a hole, in one solid.
TopoDS_Shape drilled_part();
/// Two boxes that share a part of a face, as two solids.
TopoDS_Shape two_solids();
/// A box with a box-shaped void.
TopoDS_Shape hollow_part();
/// A prism over a triangle with this angle, 40 long.
TopoDS_Shape wedge_part(double angle_deg);
/// A tube, 1 thick.
TopoDS_Shape tube_part(double radius, double length);
/// Two cylinders, one solid each, that share nothing but a line.
TopoDS_Shape touching_cylinders();
/// Two cylinders across one another that share nothing but a point.
TopoDS_Shape cylinders_at_a_point();
/// Two boxes that touch without sharing anything: a compound that nobody glued.
TopoDS_Shape unglued_boxes();
/// A long block with a slot 0.3 wide at one end.
TopoDS_Shape slotted_block();
/// A plate 30 x 20 x 3 with so many slits of this width side by side, as far apart as they are wide.
TopoDS_Shape comb_part(int slits, double width);
/// A block 30 x 20 x 10 with a chamfer of this width along a vertical edge.
TopoDS_Shape cut_corner(double width);
/// A thin wall whose two sides have a step as high as this, opposite each other.
TopoDS_Shape wall_with_steps(double step);
/// A block 30 x 20 x 10 with a shallow pocket: a star of this many corners, with sides so long.
TopoDS_Shape engraved_block(int corners, double side, double depth);
TopoDS_Shape turned(const TopoDS_Shape& shape, double angle, const Vec3& shift);

struct Part {
    Brep brep;
    SizingField sizing;
    Mesh surface;
};
Part prepare(const TopoDS_Shape& shape, const SizingOptions& options);
Part prepare(const TopoDS_Shape& shape, double size);

VolumeResult fill(const Part& part, int threads = 1);
/// Of the tets in that region.
double volume_of(const CavityFill& fill, int region);
Expectation expectation_of(const Brep& brep);
/// Broken invariants in words, one per line; empty for a valid mesh.
std::string findings(const Brep& brep, const Mesh& mesh);
bool are_same_bytes(const Mesh& a, const Mesh& b);

}  // namespace featuremesh::testing

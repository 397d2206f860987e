// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for every surface mesh, and the shapes it is tried on.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "brep/brep.h"
#include "mesh/mesh.h"
#include "surface/fill_surface.h"

namespace featuremesh::testing {

struct NamedShape {
    std::string name;
    TopoDS_Shape shape;
    double size;  ///< mm
    int euler;    ///< of the whole boundary
};
/// Boxes, cylinders, cones with their apex, spheres, tori, fillets, lofts, plates with holes: turned by an odd angle.
std::vector<NamedShape> named_shapes();

/// A free-form face with a pole at either end of the third axis.
TopoDS_Shape ellipsoid(const Vec3& half_axes);

SurfaceResult mesh_surface(const Brep& brep, double size, Mesh kept = {}, int threads = 1);
/// With the sizes that curved and thin faces ask for.
SurfaceResult mesh_surface(const Brep& brep, double size, NarrowFaces narrow);

/// Nodes on their entities, chains complete, triangles the right way round, every side shared as the shape says. In
/// words; empty when all is well.
std::vector<std::string> surface_findings(const Brep& brep, const Mesh& mesh);
int euler_characteristic(const Mesh& mesh);
/// Degrees.
double smallest_angle(const Mesh& mesh);
double smallest_angle(const Mesh& mesh, TriangleId triangle);
double area(const Mesh& mesh);

}  // namespace featuremesh::testing

// SPDX-License-Identifier: GPL-3.0-or-later
// Load vectors of the tets and triangles of a mesh, as CalculiX and FreeCAD's writer of its input make them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "mesh/mesh.h"
#include "statics/model.h"

namespace featuremesh {

/// Adds the weight of all tets to `loads`, (n,3) N; `gravity` in mm/s^2.
void add_weight(const Mesh& mesh, std::span<const Material> materials, std::span<const std::int32_t> tet_materials,
                const Vec3& gravity, std::vector<double>& loads);

/// Adds `pressure`, MPa, against some triangles to `loads`, (n,3) N. Where triangles have mid-side nodes they count
/// curved (CalculiX's *DLOAD on C3D4 and C3D10). A triangle between two tets is loaded from where its CAD
/// face's outside is.
void add_pressure(const Mesh& mesh, std::span<const std::int32_t> triangles, double pressure,
                  std::vector<double>& loads);

/// By node the part of the triangles' area, mm^2, that is its own where a force is spread over them: a third for every
/// corner of a 4-node tet's facet; all for the mid-side nodes of a 10-node tet's, whose area is that of its four plane
/// triangles (as FreeCAD counts it).
std::vector<double> area_shares(const Mesh& mesh, std::span<const std::int32_t> triangles);

/// By node the part of the segments' length, mm: halves, or with mid-side nodes a sixth, two thirds, a sixth.
std::vector<double> length_shares(const Mesh& mesh, std::span<const std::int32_t> segments);

}  // namespace featuremesh

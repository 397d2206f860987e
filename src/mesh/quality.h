// SPDX-License-Identifier: GPL-3.0-or-later
// Quality of straight-sided tets, and of triangles where there are no tets.
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"

namespace featuremesh {

struct DihedralRange {
    double smallest_deg, largest_deg;
};

/// Smallest and largest of the six dihedral angles of a tet, degrees.
DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// 3 r_in / R, 1 for the regular tet, 0 for a flat one.
double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// 2 r_in / R, 1 for the equilateral triangle, 0 for one without area.
double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c);

/// Figures of a whole mesh (corner nodes only). Of a mesh without tets they are those of its triangles: their corners'
/// angles for the dihedral ones, and what the edges force is where two of them meet, and what is opposite one of a
/// single piece.
struct QualityReport {
    static constexpr double small_angle_deg = 25;

    double min_dihedral = 0, mean_min_dihedral = 0, max_dihedral = 0;  ///< degrees
    double mean_radius_ratio = 0, min_radius_ratio = 0;
    double min_scaled_jacobian = 1;  ///< of the 10-node tets, or 6-node triangles, with curved sides
    std::int64_t below_10 = 0, below_20 = 0, below_25 = 0;  ///< elements by smallest angle, degrees
    std::int64_t forced_by_cad =
        0;        ///< of the tets below 25 degrees, those a sharper CAD angle or a far shorter CAD edge forces
    TetId worst;  ///< with the smallest angle; none when all are 25 degrees or more
    double min_dihedral_unforced = 0;          ///< degrees, of all the others
    std::array<std::int64_t, 36> histogram{};  ///< all dihedral angles in bins of 5 degrees
};
/// The same figures, bit for bit, for any number of threads.
QualityReport measure_quality(const Mesh& mesh, RunContext& context);
QualityReport measure_quality(const Mesh& mesh);

}  // namespace featuremesh

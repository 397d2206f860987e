// SPDX-License-Identifier: GPL-3.0-or-later
// Where the new inner nodes of a face start: near their final places, so that little is left to improve.
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "surface/chart.h"
#include "surface/chart_domain.h"
#include "surface/face_boundary.h"
#include "surface/heartbeat.h"
#include "surface/wanted_length.h"

namespace featuremesh {

struct Seeds {
    std::vector<Vec2> points;
    std::vector<double> wanted;   ///< side length at each, mm
    std::size_t fixed_count = 0;  ///< so many at the front stay where they are
};

/// Points of the hexagonal lattice of edge length `size`, anchored at the chart's origin, inside the boundary and not
/// nearer to it than about half a size.
std::vector<Vec2> lattice_seeds(const FaceBoundary& boundary, double size);

/// For any chart and any sizing: from each piece of the boundary inwards and from each seed to its six neighbours in
/// space, one wanted edge length away, as long as no other point is near. Lengths are those on the surface. `wanted` is
/// the side length at each point of the boundary.
Seeds front_seeds(const FaceBoundary& boundary, std::span<const double> wanted, const ChartDomain& domain,
                  const Chart& chart, const WantedLength& sizing, const Mesh& mesh, const Heartbeat& heart);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Fills what is not meshed yet of one CAD face.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"
#include "mesh/mesh.h"
#include "surface/chart_domain.h"
#include "surface/face_boundary.h"
#include "surface/heartbeat.h"
#include "surface/wanted_length.h"

namespace featuremesh {

/// New nodes and triangles of a face. A corner below `boundary node count` is that point of the FaceBoundary, others
/// are new nodes.
struct FaceFilling {
    std::vector<Vec3> points;
    std::vector<std::array<double, 2>> parameters;
    std::vector<std::array<int, 3>> triangles;  ///< right-hand normal as the face is oriented in the shape
    double smallest_angle = 0;                  ///< radians
    /// Pairs of edges so near one another that a triangle between a piece of the one and a node of the other stands
    /// across the surface: the arc is higher than the strip is wide. It was split; with nodes opposite one another it
    /// need not be.
    std::vector<std::array<EdgeId, 2>> beside;
};

/// Fills the region with nearly equilateral triangles of the wanted size and checks that they cover it exactly once.
/// `opposite`: parameters of places that get nodes where there is room for them. Throws MeshError that names the face.
FaceFilling fill_face(const Brep& brep, FaceId face, const Chart& chart, const FaceBoundary& boundary,
                      ChartDomain& domain, const WantedLength& sizing, const Mesh& mesh,
                      std::span<const std::array<double, 2>> opposite, const Heartbeat& heart);

}  // namespace featuremesh

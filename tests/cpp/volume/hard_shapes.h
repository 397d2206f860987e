// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes that meshers stumble over.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

namespace featuremesh::testing {

struct HardShape {
    std::string name;
    TopoDS_Shape shape;
    double scale = 1;  ///< sizes are multiplied by it
};

/// Thin walls, sharp wedges, narrow slots, poles, sweeps and lofts, voids, shared faces, very small, very large, far
/// away.
std::vector<HardShape> hard_shapes();
TopoDS_Shape scaled(const TopoDS_Shape& shape, double factor);

}  // namespace featuremesh::testing

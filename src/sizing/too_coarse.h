// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes whose elements are too long to follow the part.
#pragma once

#include <vector>

#include "core/errors.h"
#include "core/ids.h"
#include "features/brep.h"
#include "mesh/mesh.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// Tells where shorter edges would help.
struct TooCoarse : MeshError {
    TooCoarse(const std::string& message, std::string at, std::vector<SizeSource> lengths, bool shape_too = false)
        : MeshError(message), place(std::move(at)), shorter(std::move(lengths)), may_be_shape(shape_too) {}
    std::string place;                ///< names of faces, or of a solid
    std::vector<SizeSource> shorter;  ///< half the elements' lengths
    bool may_be_shape;                ///< that cannot be meshed, whatever the lengths: not worth more than one more try
};

/// Half the longest side of a triangle, at its middle.
SizeSource half_length_of(const Vec3& a, const Vec3& b, const Vec3& c);

/// For triangles that lie the wrong way round on their faces; at least one.
TooCoarse turned_over(const Mesh& mesh, const std::vector<TriangleId>& turned);

/// The solids whose tets have a volume that is off by more than the share `tolerance`.
std::vector<SolidId> solids_off_volume(const Mesh& mesh, const Brep& brep, double tolerance);

/// For the first of such solids, with what the validation says.
TooCoarse off_volume(const Mesh& mesh, const Brep& brep, SolidId solid, const std::string& finding);

}  // namespace featuremesh

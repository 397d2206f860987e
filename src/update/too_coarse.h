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
    TooCoarse(const std::string& message, std::string at, std::vector<SizeSource> lengths)
        : MeshError(message), place(std::move(at)), shorter(std::move(lengths)) {}
    std::string place;                ///< name of a face, or of a solid
    std::vector<SizeSource> shorter;  ///< half the elements' lengths
};

/// For triangles that lie the wrong way round on their faces; at least one.
TooCoarse turned_over(const Mesh& mesh, const std::vector<TriangleId>& turned);

/// The solids whose tets have a volume that is off by more than the share `tolerance`.
std::vector<SolidId> solids_off_volume(const Mesh& mesh, const Brep& brep, double tolerance);

/// For the first of such solids, with what the validation says.
TooCoarse off_volume(const Mesh& mesh, const Brep& brep, SolidId solid, const std::string& finding);

}  // namespace featuremesh

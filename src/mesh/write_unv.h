// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh as a UNV file: what FreeCAD reads with numbers and groups, on every version.
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace featuremesh {

struct MeshGroup {
    enum class Kind { node, edge, face, volume };
    std::string name;
    Kind kind = Kind::node;
    std::vector<Number> numbers;   ///< of nodes, segments, triangles or tets
};

/// Writes nodes (all 17 digits), segments, triangles and tets with their numbers, and the groups. Throws Error when the file cannot be written.
/// FreeCAD's reader closes the gaps between numbers (so does FreeCAD when it opens a saved document): node k of the file's sorted numbers becomes node k.
/// Numbers with gaps have to be handed over by addNode and its like instead.
void write_unv(const Mesh& mesh, const std::vector<MeshGroup>& groups, const std::string& path);

}  // namespace featuremesh

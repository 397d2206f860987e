// SPDX-License-Identifier: GPL-3.0-or-later
// The edge lengths that kept nodes were made for.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/mesh.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// Only of nodes for which that is not the length wanted there now: sizes that change little by little would release
/// nothing if they were compared with what was asked last.
struct MadeFor {
    std::vector<NodeId> nodes;  ///< ascending
    std::vector<double> sizes;  ///< mm, of each
    std::optional<double> of(NodeId node) const;
};

/// A mesh with the field it was wanted with, and the lengths its nodes were made for.
struct SizedMesh {
    const Mesh& mesh;
    const SizingField& sizing;
    const MadeFor& made_for;
    double made_for_at(NodeId node) const { return made_for.of(node).value_or(sizing.at(mesh.point(node))); }
};

/// Of the corner nodes of a mesh that keeps some of an old one; `origin` by node as in PartMesh.
MadeFor made_for(const Mesh& mesh, const SizingField& sizing, const SizedMesh& old,
                 const std::vector<std::int32_t>& origin);

}  // namespace featuremesh

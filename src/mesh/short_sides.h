// SPDX-License-Identifier: GPL-3.0-or-later
// Where the CAD shape has edges, or edges beside one another, far shorter than the elements.
#pragma once

#include <array>
#include <optional>

#include "core/ids.h"
#include "mesh/mesh.h"
#include "mesh/side_table.h"

namespace featuremesh {

/// A tet with two nodes on CAD edges or vertices far nearer to one another than its others are has an angle opposite
/// that side which no mesh with both nodes can have larger.
class ShortSides {
  public:
    /// Of the tet's longest side; the angle is below a degree then.
    static constexpr double share = 0.01;

    explicit ShortSides(const Mesh& mesh);

    /// The side for which the shape is to blame: a whole CAD edge, or one between two entities. None for other tets,
    /// and where it is a piece of an edge that was divided so.
    std::optional<std::array<NodeId, 2>> forced_side(TetId tet) const;
    /// The segment of the mesh between two nodes; -1 for none.
    std::int32_t segment_at(NodeId a, NodeId b) const { return segment_at_.find(a, b); }

  private:
    bool is_forced(NodeId a, NodeId b) const;

    const Mesh& mesh_;
    SideTable segment_at_;
};

}  // namespace featuremesh

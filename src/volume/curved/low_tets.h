// SPDX-License-Identifier: GPL-3.0-or-later
// Finds 10-node tets that are folded or nearly so, again and again while nodes move.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// The tets that have a node, by node, mid-side nodes, too; ascending.
class TetsAtNode {
  public:
    TetsAtNode(const Mesh& mesh, const RunContext& context);

    std::span<const TetId> of(NodeId node) const;
    /// Those that have one of the nodes, ascending.
    std::vector<TetId> of(std::span<const NodeId> nodes) const;

  private:
    std::vector<std::size_t> first_;  ///< by node, and the end
    std::vector<TetId> tets_;
};

/// Lower bound of the scaled Jacobian without subdivision, minus infinity where it is found to be no larger than
/// `limit`. Nothing is worse than a tet whose corners are turned over.
double quick_bound(const std::array<Vec3, 10>& nodes, double limit = -std::numeric_limits<double>::infinity());

/// The tets whose scaled Jacobian is at most `limit` somewhere, proved by its Bernstein coefficients. Only tets with a
/// curved side are looked at.
std::vector<TetId> tets_at_most(const Mesh& mesh, double limit, RunContext& context);

/// The same while nodes move: only tets with a node that has moved are looked at again.
class LowTets {
  public:
    LowTets(const Mesh& mesh, double limit, RunContext& context);

    const std::vector<TetId>& found() const { return found_; }
    void look_again(const TetsAtNode& tets_at);

  private:
    std::vector<NodeId> moved_nodes();

    const Mesh& mesh_;
    const double limit_;
    RunContext& context_;
    std::vector<TetId> found_;
    std::vector<Vec3> points_;  ///< of the nodes at the last look
};

}  // namespace featuremesh

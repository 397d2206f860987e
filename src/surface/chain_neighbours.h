// SPDX-License-Identifier: GPL-3.0-or-later
// Which CAD edges pass through a point of another edge.
#pragma once

#include <utility>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "surface/projection.h"

namespace featuremesh {

/// The edges of a part by where their chains run.
class ChainNeighbours {
  public:
    struct Place {
        double t;
        Vec3 point;
    };
    /// `chains`: by edge, the places of its chain's nodes; none for an edge without.
    ChainNeighbours(const Brep& brep, const Projector& projector, std::vector<std::vector<Place>> chains);

    /// Whether another edge of the same solid, with no end in common with this one, passes by p nearer than `reach` mm,
    /// while the edges are not both straight.
    bool is_on_another(EdgeId edge, const Vec3& p, double reach) const;

  private:
    struct Extent {
        Box box;
        double sagitta = 0;  ///< no point of the edge is further from its chain, mm
        bool is_straight = false;
    };
    bool may_touch(EdgeId a, EdgeId b) const;
    bool is_near_chain(std::size_t edge, const Vec3& p, double reach) const;
    /// Of the edge between two places, whose chord is halved so often before the kernel is asked for the nearest point.
    bool is_near_piece(EdgeId edge, const std::array<Place, 2>& ends, const Vec3& p, double reach, int halvings) const;

    const Brep& brep_;
    const Projector& projector_;
    std::vector<std::vector<Place>> chains_;
    std::vector<Extent> extents_;                         ///< by edge
    std::vector<std::pair<double, std::size_t>> by_low_;  ///< lowest x of the box, edge
    double widest_ = 0;                                   ///< box along x, mm
};

}  // namespace featuremesh

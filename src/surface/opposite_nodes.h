// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes opposite one another on edges that run beside one another.
#pragma once

#include <array>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"
#include "surface/projection.h"
#include "surface/wanted_length.h"

namespace featuremesh {

/// Pairs of edges of one face so near one another that chains of their own would cross.
class EdgesBeside {
  public:
    void add(EdgeId a, EdgeId b) { pairs_.insert(std::minmax(a, b)); }
    bool has(EdgeId a, EdgeId b) const { return pairs_.contains(std::minmax(a, b)); }
    std::vector<EdgeId> of(EdgeId edge) const;
    bool is_empty() const { return pairs_.empty(); }

  private:
    std::set<std::pair<EdgeId, EdgeId>> pairs_;
};

/// The parameters of the edge strictly between the two that are opposite the points, ascending: those of points nearer
/// than a quarter of the wanted length. They keep 0.3 of it from both ends and, the earlier first, from one another.
std::vector<double> parameters_opposite(const Projector& projector, const WantedLength& sizing, EdgeId edge,
                                        const std::array<double, 2>& between, std::span<const Vec3> points);

}  // namespace featuremesh

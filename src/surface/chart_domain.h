// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a chart that is to be filled, triangulated with its boundary as constraints.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "surface/chart.h"
#include "surface/face_boundary.h"
#include "surface/heartbeat.h"
#include "surface/triangle_patch.h"

namespace featuremesh {

/// Two pieces of the boundary that cross, or a piece that runs through a point of another; twice the same piece where
/// it cuts off a lone point.
struct Crossing {
    std::size_t first = 0, second = 0;  ///< index in FaceBoundary::segments
};

/// Constrained Delaunay triangulation of the boundary; inside is what is left of its segments, labelled from triangle
/// to triangle.
class ChartDomain {
  public:
    explicit ChartDomain(const FaceBoundary& boundary);
    ~ChartDomain();
    ChartDomain(ChartDomain&&) noexcept;

    /// Empty when the boundary's loops bound a region without crossing; else nothing below may be called.
    const std::vector<Crossing>& crossings() const;
    bool is_valid() const;

    /// Whether a point is inside; `hint` is the place where the last search ended (0 at first) and makes near points
    /// cheap. Only before insert().
    bool contains(Vec2 p, void*& hint) const;
    /// Adds inner points.
    void insert(std::span<const Vec2> seeds, const Heartbeat& heart);
    /// The triangles inside. Its points are the boundary's, then the seeds; places are not set.
    TrianglePatch patch() const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace featuremesh

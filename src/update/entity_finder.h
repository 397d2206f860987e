// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertex, edge or face of a shape a point lies on.
#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

#include "brep/brep.h"
#include "core/box_tree.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "surface/projection.h"

namespace featuremesh {

/// An entity and the point's parameters on it, as a node of a mesh has them.
struct PointPlace {
    Entity entity;
    std::array<double, 2> parameters{0, 0};
};

/// One object per thread.
class EntityFinder {
  public:
    /// Points are on an entity that is no further away than `tolerance`, mm.
    EntityFinder(const Brep& brep, double tolerance);
    /// Of the same shape, for another thread.
    EntityFinder another() const { return {brep_, tolerance_, projector_.another(), boxes_}; }

    /// The entity of lowest dimension that the point lies on, the nearest of several; none (dimension 3) off the
    /// boundary.
    PointPlace find(const Vec3& p) const;

    const Projector& projector() const { return projector_; }

  private:
    using BoxTrees = std::array<BoxTree, 3>;  // by dimension, without what no solid uses
    EntityFinder(const Brep& brep, double tolerance, Projector projector, std::shared_ptr<const BoxTrees> boxes);
    /// The point on an entity, if it is no further away than `nearest`, which it lowers.
    std::optional<PointPlace> place_on(Entity entity, const Vec3& p, double& nearest) const;

    const Brep& brep_;
    double tolerance_;
    Projector projector_;
    std::shared_ptr<const BoxTrees> boxes_;
};

/// What an entity touches: itself, and what it bounds. Each ascending.
std::vector<FaceId> faces_at(const Brep& brep, Entity entity);
std::vector<EdgeId> edges_at(const Brep& brep, Entity entity);
/// Those that both lists have; the lists are ascending.
template <class Id>
std::vector<Id> in_both(const std::vector<Id>& a, const std::vector<Id>& b) {
    std::vector<Id> both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Start positions of inner nodes: a body-centred cubic lattice, graded by an octree.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "core/run_context.h"
#include "volume/facet.h"
#include "volume/tets/circumsphere.h"
#include "volume/wanted_size.h"

namespace featuremesh {

struct SeedOptions {
    double clearance = 0.65;     ///< distance from the facets, in wanted edge lengths
    double spacing = 0.7;        ///< distance from active points, in wanted edge lengths
    bool spares_facets = false;  ///< none inside the ball around a facet, which Delaunay would not have any more
};

/// The lattice's constant (edge of its cubes) whose Delaunay tets have the wanted edge length: two edges of each are as
/// long as the constant, four are 0.866 of it, which is the length asked for.
constexpr double lattice_constant(double edge_length) { return edge_length * 1.1547005383792515; }

struct Seeds {
    std::vector<Vec3> points;
    std::size_t active_count = 0;  ///< those in front are active points, the others the lattice's
};

/// Where seeds may be: inside the regions that the facets bound, not nearer to a facet than the clearance, and not
/// inside a ball (such as the circumsphere of a kept tet). Keeps the spans of points and facets; they must outlive it.
class SeedSpace {
  public:
    SeedSpace(std::span<const Vec3> points, std::span<const Facet> facets, std::span<const Ball> balls,
              const WantedSize& size, const SeedOptions& options, const RunContext& context);
    ~SeedSpace();

    /// The `active` points, as far as they have room (less of it than others need), then points of the lattice, apart
    /// from one another. The lattice is anchored at the origin of space, so that the same place and root size give the
    /// same points whatever is around it. Always the same order. Coordinates are off the exact lattice by 1e-6 of its
    /// constant, since exactly coplanar points cost exact arithmetic.
    Seeds seeds(std::span<const Vec3> active);

    /// Those of the candidates that are where seeds may be, with these distances (a clearance of at most the space's),
    /// in their order.
    std::vector<Vec3> with_room(std::span<const Vec3> candidates, const SeedOptions& options);

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace featuremesh

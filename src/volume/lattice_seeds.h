// SPDX-License-Identifier: GPL-3.0-or-later
// Start positions of inner nodes: a body-centred cubic lattice, graded by an octree.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "core/run_context.h"
#include "volume/circumsphere.h"
#include "volume/facet.h"
#include "volume/region_locator.h"

namespace featuremesh {

/// The wanted edge length, mm, as a function, with its largest value; what the seeds know of the sizing field.
struct WantedSize {
    std::function<double(const Vec3&)> at;
    double largest = 0;
    bool is_uniform = true;
};

struct SeedOptions {
    double clearance = 0.65;  ///< distance from the facets, in wanted edge lengths
    double spacing = 0.7;     ///< distance from active points, in wanted edge lengths
};

/// The lattice's constant (edge of its cubes) whose Delaunay tets have the wanted edge length: two edges of each are as
/// long as the constant, four are 0.866 of it, which is the length asked for.
constexpr double lattice_constant(double edge_length) { return edge_length * 1.1547005383792515; }

/// Facets that bound regions, ready to be asked. Keeps the spans; they must outlive it.
class SeedRegion {
  public:
    SeedRegion(std::span<const Vec3> points, std::span<const Facet> facets);

    std::span<const Vec3> points() const { return points_; }
    std::span<const Facet> facets() const { return facets_; }
    std::span<const Box> boxes() const { return boxes_; }  ///< by facet
    const RegionLocator& locator() const { return locator_; }

  private:
    std::span<const Vec3> points_;
    std::span<const Facet> facets_;
    std::vector<Box> boxes_;
    RegionLocator locator_;
};

/// The `active` points, as far as they have room (less of it than others need), then points of the lattice: all inside
/// the regions that the facets bound, not nearer to a facet than the clearance, not inside a ball (such as the
/// circumsphere of a kept tet), and apart from one another. The lattice is anchored at the origin of space, so that the
/// same place gives the same points whatever is around it. Always the same order. Coordinates are off the exact lattice
/// by 1e-6 of its constant, since exactly coplanar points cost exact arithmetic.
std::vector<Vec3> find_seeds(const SeedRegion& region, std::span<const Ball> balls, std::span<const Vec3> active,
                             const WantedSize& size, const SeedOptions& options, const RunContext& context);

/// Those of the candidates that are as find_seeds wants them, apart from one another by the spacing, in their order.
std::vector<Vec3> seeds_with_room(std::span<const Vec3> candidates, const SeedRegion& region,
                                  std::span<const Ball> balls, const WantedSize& size, const SeedOptions& options,
                                  const RunContext& context);

}  // namespace featuremesh

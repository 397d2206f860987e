// SPDX-License-Identifier: GPL-3.0-or-later
// Some tets of a filling, taken out to be made anew.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "volume/cavity.h"
#include "volume/delaunay/triangulation.h"
#include "volume/fill_cavity.h"

namespace featuremesh {

/// The chosen tets as a cavity of their own. Its border is what they share with the other tets, which stay.
class Neighbourhood {
  public:
    /// References stay in use. `is_inner` by tet; the points `dropped`, ascending, are not among the new tets' corners,
    /// and all tets at them are inner.
    Neighbourhood(const Cavity& cavity, const CavityFill& fill, std::vector<std::uint8_t> is_inner,
                  std::span<const int> dropped = {});

    /// The tets' points; the border, normals outward, and the whole's facets within it, with those that are missing.
    const Cavity& cavity() const { return sub_; }
    bool is_small() const { return 2 * inner_count_ < fill_.triangulation.tets.size(); }
    bool is_border(int facet) const { return facet < static_cast<int>(border_count_); }
    /// The whole's facet, -1 for none; the whole's point.
    int facet_of(int facet) const { return facet_of_sub_[static_cast<std::size_t>(facet)]; }
    int point_of(int point) const { return point_of_sub_[static_cast<std::size_t>(point)]; }

    /// The tets outside as they were, then the new ones within. `local` has the cavity's points, then `added` ones,
    /// which come after the whole cavity's own. None where the border is not met.
    std::optional<Triangulation> merge(const Triangulation& local, std::size_t added) const;

  private:
    const std::vector<std::array<int, 4>>& tets() const { return fill_.triangulation.tets; }
    void number_points(std::span<const int> dropped);
    void add_facet(const std::array<int, 3>& corners, int facet, bool is_border);
    void collect_facets();
    std::vector<int> label_inside(const Triangulation& local, const FacetPlaces& places) const;
    int outside_at(const std::array<int, 3>& corners, int index, const std::vector<int>& outer_index,
                   Triangulation& all) const;

    const Cavity& cavity_;
    const CavityFill& fill_;
    std::vector<std::uint8_t> is_inner_;
    std::size_t inner_count_ = 0, border_count_ = 0;
    std::vector<int> sub_index_, point_of_sub_, facet_of_sub_;
    std::vector<int> place_;                           ///< by point of the whole: its number without the dropped ones
    std::map<std::array<int, 3>, int> border_facets_;  ///< the tet beyond
    Cavity sub_;
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Which tets of an old mesh stay, when it is known which of its nodes do.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "difference/feature_difference.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// A motion of a node that does not stay.
constexpr std::int32_t dropped = -1;

class KeptEntities;
class SolidLocator;

class KeptTets {
  public:
    /// Tets stay when all their nodes do, under one motion, and when their connected region is inside a new solid.
    /// `motions`: by old node, index of its carried region. `near_change`: by old node, it stays for the tets of
    /// untouched solids only (empty: no such node). `is_resized`: by old node, it goes since another size is wanted
    /// (likewise); beside such nodes inner ones that would keep few of their tets keep none. `places`: where nodes lie
    /// on the new shape; where that is not given a ray tells on which side of its faces a region is.
    KeptTets(const Mesh& old, std::span<const std::int32_t> motions, std::span<const CarriedRegion> regions,
             const Brep& old_brep, const Brep& new_brep, std::span<const char> near_change = {},
             std::span<const char> untouched_solids = {}, std::span<const char> is_resized = {},
             const KeptEntities* places = nullptr);

    /// Old tets that do not stay, in order.
    std::span<const std::int32_t> dropped_tets() const { return dropped_; }
    /// Those that stay and have a node in common with one that does not, in order.
    std::span<const std::int32_t> tets_at_rim() const { return at_rim_; }
    /// Of the mesh of those that stay, in order: with a marked node. Quick where no other nodes are marked than those
    /// at the rim.
    std::vector<TetId> tets_at(const Mesh& kept, std::span<const char> is_marked,
                               std::span<const std::int32_t> node_origin) const;
    bool is_kept(std::size_t tet) const { return is_kept_[tet]; }
    /// Of a kept tet.
    SolidId solid_of(std::size_t tet) const {
        return solids_.empty() ? solid_of_group(old_.tet_solids[tet], motion_of(tet)) : solids_[tet];
    }
    /// All kept tets of one old solid under one motion are in the same new one.
    bool is_uniform() const { return solids_.empty(); }
    /// That of all kept tets, where it is the same one.
    SolidId only_solid() const;
    SolidId solid_of_group(SolidId old_solid, std::int32_t motion) const {
        return solid_of_group_[old_solid.index() * regions_.size() + std::size_t(motion)];
    }
    /// A tet around the old corner node is not kept.
    bool is_rim(std::size_t node) const { return is_rim_[node]; }
    bool has_kept_tet(std::size_t node) const {
        return motions_[node] != dropped && (!is_rim_[node] || is_used_[node]);
    }
    /// By carried region.
    std::vector<std::size_t> counts() const;

  private:
    std::int32_t motion_of(std::size_t tet) const { return motions_[old_.tets[tet][0].index()]; }
    bool has_one_motion(std::size_t tet) const;  ///< its corners, and none of them goes
    bool stays(std::size_t tet) const;
    bool may_stay_near_change(std::size_t tet) const;
    void mark_rim();
    bool drop_frayed();
    void find_successors(const Brep& old_brep, const Brep& new_brep);
    bool settle_at_rim(const Brep& new_brep);
    SolidId solid_at(const std::vector<std::int32_t>& piece, const SolidLocator& locator) const;
    std::vector<std::int32_t> pieces_of(std::span<const std::int32_t> tets, SolidId solid) const;
    std::vector<std::vector<std::int32_t>> pieces_of_rim(SolidId solid) const;
    void drop_islands(const std::vector<std::vector<std::int32_t>>& rims);
    bool is_settled() const;
    void settle_everywhere(const Brep& new_brep);
    std::size_t group_of(std::size_t tet) const {
        return old_.tet_solids[tet].index() * regions_.size() + std::size_t(motion_of(tet));
    }
    SolidId solid_at_centre(std::size_t tet, const SolidLocator& locator) const;
    Vec3 carried_centre(std::size_t tet) const;

    const Mesh& old_;
    std::span<const std::int32_t> motions_;
    std::span<const CarriedRegion> regions_;
    std::span<const char> near_change_, untouched_solids_, is_resized_;
    const KeptEntities* places_;
    std::size_t solid_count_;
    std::vector<char> occurs_;  // by motion: a node has it
    std::vector<char> is_kept_, is_rim_, is_used_;
    std::vector<std::int32_t> dropped_, at_rim_;
    std::vector<std::vector<char>> successors_;  // by old solid and motion: the new solids that it may be in
    std::vector<SolidId> solid_of_group_;        // by old solid and motion
    std::vector<SolidId> solids_;                // by tet, where those of a group differ
};

}  // namespace featuremesh

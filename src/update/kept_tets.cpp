// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/kept_tets.h"

#include <algorithm>
#include <map>

#include "brep/enclosure.h"
#include "core/joined_sets.h"
#include "mesh/tets_at_nodes.h"
#include "update/kept_entities.h"

namespace featuremesh {

namespace {

/// Its nodes.
void join(JoinedSets& sets, const std::array<NodeId, 4>& tet) {
    for (std::size_t k = 1; k < 4; ++k) sets.join(tet[0].value, tet[k].value);
}

/// The piece of each of the tets, where those with a common node are one.
std::vector<std::int32_t> pieces_by_nodes(const Mesh& mesh, std::span<const std::int32_t> tets) {
    JoinedSets nodes(mesh.corner_count);
    for (const std::int32_t t : tets) join(nodes, mesh.tets[std::size_t(t)]);
    std::vector<std::int32_t> pieces;
    for (const std::int32_t t : tets) pieces.push_back(nodes.root(mesh.tets[std::size_t(t)][0].value));
    return pieces;
}

/// The piece of each of the tets, where those with a common facet are one: two solids may touch at an edge.
std::vector<std::int32_t> pieces_by_facets(const Mesh& mesh, std::span<const std::int32_t> tets) {
    struct Facet {
        std::array<NodeId, 3> nodes;
        std::int32_t place;  // of its tet in the list
    };
    std::vector<Facet> facets;
    facets.reserve(4 * tets.size());
    for (const std::int32_t t : tets) {
        std::array<NodeId, 4> sorted = mesh.tets[std::size_t(t)];
        std::sort(sorted.begin(), sorted.end());
        const auto& [a, b, c, d] = sorted;
        for (const std::array<NodeId, 3>& nodes : {std::array{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}})
            facets.push_back({nodes, std::int32_t(facets.size() / 4)});
    }
    std::sort(facets.begin(), facets.end(), [](const Facet& f, const Facet& g) { return f.nodes < g.nodes; });
    JoinedSets places(tets.size());
    for (std::size_t f = 1; f < facets.size(); ++f)
        if (facets[f].nodes == facets[f - 1].nodes) places.join(facets[f].place, facets[f - 1].place);
    std::vector<std::int32_t> pieces;
    for (std::size_t i = 0; i < tets.size(); ++i) pieces.push_back(places.root(std::int32_t(i)));
    return pieces;
}

}  // namespace

KeptTets::KeptTets(const Mesh& old, std::span<const std::int32_t> motions, std::span<const CarriedRegion> regions,
                   const Brep& old_brep, const Brep& new_brep, std::span<const char> near_change,
                   std::span<const char> untouched_solids, std::span<const char> is_resized, const KeptEntities* places)
    : old_(old),
      motions_(motions),
      regions_(regions),
      near_change_(near_change),
      untouched_solids_(untouched_solids),
      is_resized_(is_resized),
      places_(places),
      solid_count_(old_brep.solid_count()),
      occurs_(regions.size(), 0),
      is_kept_(old.tets.size()) {
    for (const std::int32_t motion : motions_)
        if (motion != dropped) occurs_[std::size_t(motion)] = 1;
    if (old.order == 1 && near_change.empty())
        for (std::size_t t = 0; t < is_kept_.size(); ++t) is_kept_[t] = has_one_motion(t);
    else
        for (std::size_t t = 0; t < is_kept_.size(); ++t) is_kept_[t] = stays(t);
    mark_rim();
    if (drop_frayed()) mark_rim();
    find_successors(old_brep, new_brep);
    if (settle_at_rim(new_brep)) return;
    settle_everywhere(new_brep);
    mark_rim();
}

std::vector<TetId> KeptTets::tets_at(const Mesh& kept, std::span<const char> is_marked,
                                     std::span<const std::int32_t> node_origin) const {
    for (std::size_t n = 0; n < is_marked.size(); ++n)
        if (is_marked[n] && !is_rim_[std::size_t(node_origin[n])]) return tets_at_nodes(kept, is_marked);
    std::vector<TetId> tets;
    std::size_t dropped_before = 0;
    for (const std::int32_t t : at_rim_) {
        while (dropped_before < dropped_.size() && dropped_[dropped_before] < t) ++dropped_before;
        tets.emplace_back(std::size_t(t) - dropped_before);
    }
    return tets;
}

// Without branches: nearly all tets are asked, and those that go lie anywhere among them.
bool KeptTets::has_one_motion(std::size_t tet) const {
    const auto& [a, b, c, d] = old_.tets[tet];
    const std::int32_t motion = motions_[a.index()];
    return (motion != dropped) & (motions_[b.index()] == motion) & (motions_[c.index()] == motion) &
           (motions_[d.index()] == motion);
}

bool KeptTets::stays(std::size_t tet) const {
    if (!has_one_motion(tet) || !may_stay_near_change(tet)) return false;
    const auto has_it = [&](NodeId n) { return motions_[n.index()] == motion_of(tet); };
    return old_.order == 1 || std::all_of(old_.tet_mids[tet].begin(), old_.tet_mids[tet].end(), has_it);
}

bool KeptTets::may_stay_near_change(std::size_t tet) const {
    if (near_change_.empty() || untouched_solids_[old_.tet_solids[tet].index()]) return true;
    const auto& corners = old_.tets[tet];
    return std::none_of(corners.begin(), corners.end(), [&](NodeId n) { return near_change_[n.index()] != 0; });
}

void KeptTets::mark_rim() {
    dropped_.clear(), at_rim_.clear();
    is_rim_.assign(old_.corner_count, 0);
    is_used_.assign(old_.corner_count, 0);
    for (std::size_t t = 0; t < is_kept_.size(); ++t)
        if (!is_kept_[t]) dropped_.push_back(std::int32_t(t));
    for (const std::int32_t t : dropped_)
        for (const NodeId n : old_.tets[std::size_t(t)]) is_rim_[n.index()] = 1;
    if (dropped_.empty()) return;
    for (std::size_t t = 0; t < is_kept_.size(); ++t) {
        const auto& [a, b, c, d] = old_.tets[t];
        if (!is_kept_[t] || !(is_rim_[a.index()] | is_rim_[b.index()] | is_rim_[c.index()] | is_rim_[d.index()]))
            continue;
        at_rim_.push_back(std::int32_t(t));
        for (const NodeId n : old_.tets[t]) is_used_[n.index()] = 1;
    }
}

// Where nodes go for their size, what stays ends wherever that changed by so much, and frays. New tets between what is
// left of the star of a node and itself would be poor; as a start position it serves better.
bool KeptTets::drop_frayed() {
    constexpr double least_share_left = 0.35;
    if (std::find(is_resized_.begin(), is_resized_.end(), 1) == is_resized_.end()) return false;
    struct Star {
        int gone = 0, left = 0;
        bool is_beside_resized = false;
        bool is_frayed() const { return is_beside_resized && left < least_share_left * (gone + left); }
    };
    std::vector<Star> stars(old_.corner_count);
    for (const std::int32_t t : dropped_) {
        const auto& nodes = old_.tets[std::size_t(t)];
        const bool is_resized =
            std::any_of(nodes.begin(), nodes.end(), [&](NodeId n) { return is_resized_[n.index()] != 0; });
        for (const NodeId n : nodes) ++stars[n.index()].gone, stars[n.index()].is_beside_resized |= is_resized;
    }
    for (const std::int32_t t : at_rim_)
        for (const NodeId n : old_.tets[std::size_t(t)]) ++stars[n.index()].left;
    bool is_any = false;
    for (const std::int32_t t : at_rim_) {
        const auto& nodes = old_.tets[std::size_t(t)];
        if (std::none_of(nodes.begin(), nodes.end(),
                         [&](NodeId n) { return old_.entities[n.index()].dim == 3 && stars[n.index()].is_frayed(); }))
            continue;
        is_kept_[std::size_t(t)] = 0;
        is_any = true;
    }
    return is_any;
}

// Solids may overlap, so a point may be in several. A new solid with faces of old ones takes the tets of these alone.
void KeptTets::find_successors(const Brep& old_brep, const Brep& new_brep) {
    std::vector<char> has_old_faces(new_brep.solid_count(), 0);
    successors_.assign(solid_count_ * regions_.size(), has_old_faces);
    for (std::size_t r = 0; r < regions_.size(); ++r)
        for (std::size_t f = 0; f < regions_[r].new_face_of.size(); ++f) {
            const FaceId now = regions_[r].new_face_of[f];
            if (!now.is_valid()) continue;
            for (const SolidId is : new_brep.solids_beside(now))
                for (const SolidId was : old_brep.solids_beside(FaceId(f)))
                    if (is.is_valid() && was.is_valid())
                        has_old_faces[is.index()] = successors_[was.index() * regions_.size() + r][is.index()] = 1;
        }
    for (std::vector<char>& may_be : successors_)
        for (std::size_t s = 0; s < may_be.size(); ++s) may_be[s] |= !has_old_faces[s];
}

SolidId KeptTets::solid_at_centre(std::size_t tet, const SolidLocator& locator) const {
    return locator.solid_at(carried_centre(tet), successors_[group_of(tet)]);
}

// Finds the new solid of all kept tets from points at the rim alone. The mesh of a solid is in one piece, and two tets
// that share a node move alike if both are kept. So every region of kept tets, unless it is a whole solid, reaches the
// rim: one point for each piece of the rim decides for its region. False when these points disagree.
bool KeptTets::settle_at_rim(const Brep& new_brep) {
    const SolidLocator locator(new_brep);
    solid_of_group_.assign(solid_count_ * regions_.size(), SolidId());
    std::vector<std::vector<std::int32_t>> outside;
    const auto settle = [&](std::size_t tet, SolidId solid) {
        SolidId& known = solid_of_group_[group_of(tet)];
        if (known.is_valid() && known != solid) return false;
        known = solid;
        return true;
    };
    for (std::size_t s = 0; s < solid_count_; ++s)  // two solids may meet at shared nodes: each has its own regions
        for (std::vector<std::int32_t>& piece : pieces_of_rim(SolidId(s))) {
            const std::size_t first = std::size_t(piece.front());
            const SolidId solid = solid_at(piece, locator);
            if (!solid.is_valid())
                outside.push_back(std::move(piece));
            else if (!settle(first, solid))
                return false;
        }
    if (!outside.empty()) drop_islands(outside);
    if (is_settled()) return true;
    for (std::size_t t = 0; t < is_kept_.size(); ++t)
        if (is_kept_[t] && !solid_of(t).is_valid() && !settle(t, solid_at_centre(t, locator))) return false;
    return is_settled();
}

// A node inside a face of the new shape knows what is behind it and before it. A ray, which has to look at faces that
// it may meet, is asked only where the piece has none.
SolidId KeptTets::solid_at(const std::vector<std::int32_t>& piece, const SolidLocator& locator) const {
    for (const std::int32_t t : piece)
        for (const NodeId n : old_.tets[std::size_t(t)])
            if (places_ && old_.entities[n.index()].dim == 2)
                if (const auto solid = places_->solid_beside(n.index(), carried_centre(std::size_t(t)))) return *solid;
    return solid_at_centre(std::size_t(piece.front()), locator);
}

// Of tets of an old solid, those that are in one new solid. Where they may be in several, two of these may touch at
// nodes that were inside the old one or on its surface, and its tets on both sides still share them.
std::vector<std::int32_t> KeptTets::pieces_of(std::span<const std::int32_t> tets, SolidId solid) const {
    const auto first = successors_.begin() + std::ptrdiff_t(solid.index() * regions_.size());
    const bool may_be_in_several =
        std::any_of(first, first + std::ptrdiff_t(regions_.size()),
                    [](const std::vector<char>& may_be) { return std::count(may_be.begin(), may_be.end(), 1) > 1; });
    return may_be_in_several ? pieces_by_facets(old_, tets) : pieces_by_nodes(old_, tets);
}

// Tets at the rim that belong together, each list in order.
std::vector<std::vector<std::int32_t>> KeptTets::pieces_of_rim(SolidId solid) const {
    std::vector<std::int32_t> mine;
    for (const std::int32_t t : at_rim_)
        if (old_.tet_solids[std::size_t(t)] == solid) mine.push_back(t);
    std::vector<std::vector<std::int32_t>> pieces;
    if (mine.empty()) return pieces;
    const std::vector<std::int32_t> piece_of = pieces_of(mine, solid);
    std::map<std::int32_t, std::size_t> place_of;
    for (std::size_t i = 0; i < mine.size(); ++i) {
        const auto [place, is_new] = place_of.try_emplace(piece_of[i], pieces.size());
        if (is_new) pieces.emplace_back();
        pieces[place->second].push_back(mine[i]);
    }
    return pieces;
}

// Drops kept tets that lie outside the new part. The surface around such a region has vanished, and the tets near that
// surface are not kept. So the rim surrounds the whole region, which lies within the rim's box.
void KeptTets::drop_islands(const std::vector<std::vector<std::int32_t>>& rims) {
    std::vector<Box> boxes;
    for (const auto& rim : rims) {
        Box& box = boxes.emplace_back();
        for (const std::int32_t t : rim)
            for (const NodeId n : old_.tets[std::size_t(t)]) box.add(old_.point(n));
    }
    std::vector<char> is_near(old_.corner_count);
    for (std::size_t n = 0; n < is_near.size(); ++n)
        is_near[n] =
            std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return box.contains(old_.points[n]); });
    std::vector<std::size_t> near;
    for (std::size_t t = 0; t < is_kept_.size(); ++t) {
        const auto& [a, b, c, d] = old_.tets[t];
        if (is_kept_[t] && (is_near[a.index()] & is_near[b.index()] & is_near[c.index()] & is_near[d.index()]))
            near.push_back(t);
    }
    for (std::size_t s = 0; s < solid_count_; ++s) {
        JoinedSets regions(old_.corner_count);
        for (const std::size_t t : near)
            if (old_.tet_solids[t] == SolidId(s)) join(regions, old_.tets[t]);
        std::vector<std::int32_t> gone;
        for (const auto& rim : rims)
            if (old_.tet_solids[std::size_t(rim.front())] == SolidId(s))
                gone.push_back(regions.root(old_.tets[std::size_t(rim.front())][0].value));
        std::sort(gone.begin(), gone.end());
        for (const std::size_t t : near)
            if (old_.tet_solids[t] == SolidId(s) &&
                std::binary_search(gone.begin(), gone.end(), regions.root(old_.tets[t][0].value)))
                is_kept_[t] = 0;
    }
    mark_rim();
}

SolidId KeptTets::only_solid() const {
    if (!solids_.empty() || !is_settled()) return {};
    SolidId only;
    for (std::size_t g = 0; g < solid_of_group_.size(); ++g) {
        if (!occurs_[g % regions_.size()]) continue;
        if (only.is_valid() && solid_of_group_[g] != only) return {};
        only = solid_of_group_[g];
    }
    return only;
}

bool KeptTets::is_settled() const {
    for (std::size_t g = 0; g < solid_of_group_.size(); ++g)
        if (occurs_[g % regions_.size()] && !solid_of_group_[g].is_valid()) return false;
    return true;
}

// One point for each piece of kept tets.
void KeptTets::settle_everywhere(const Brep& new_brep) {
    const SolidLocator locator(new_brep);
    solids_.assign(is_kept_.size(), SolidId());
    std::vector<std::vector<std::int32_t>> kept(solid_count_);
    for (std::size_t t = 0; t < is_kept_.size(); ++t)
        if (is_kept_[t]) kept[old_.tet_solids[t].index()].push_back(std::int32_t(t));
    for (std::size_t s = 0; s < solid_count_; ++s) {
        const std::vector<std::int32_t>& mine = kept[s];
        const std::vector<std::int32_t> piece_of = pieces_of(mine, SolidId(s));
        std::map<std::int32_t, SolidId> solid_of_piece;
        for (std::size_t i = 0; i < mine.size(); ++i) {
            const std::size_t t = std::size_t(mine[i]);
            const auto [solid, is_new] = solid_of_piece.try_emplace(piece_of[i]);
            if (is_new) solid->second = solid_at_centre(t, locator);
            solids_[t] = solid->second;
            is_kept_[t] = solid->second.is_valid();
        }
    }
}

Vec3 KeptTets::carried_centre(std::size_t tet) const {
    const RigidMotion& motion = regions_[std::size_t(motion_of(tet))].motion;
    Vec3 sum;
    for (const NodeId n : old_.tets[tet]) sum += motion.apply(old_.point(n));
    return sum / 4;
}

std::vector<std::size_t> KeptTets::counts() const {
    std::vector<std::size_t> counts(regions_.size(), 0);
    if (std::count(occurs_.begin(), occurs_.end(), 1) == 1) {
        counts[std::size_t(std::find(occurs_.begin(), occurs_.end(), 1) - occurs_.begin())] =
            is_kept_.size() - dropped_.size();
        return counts;
    }
    for (std::size_t t = 0; t < is_kept_.size(); ++t)
        if (is_kept_[t]) ++counts[std::size_t(motion_of(t))];
    return counts;
}

}  // namespace featuremesh

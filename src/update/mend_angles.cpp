// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/mend_angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "core/dimension.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/message.h"
#include "difference/feature_difference.h"
#include "mesh/mesh.h"
#include "mesh/quality.h"
#include "mesh/sharp_angles.h"
#include "update/keep.h"
#include "update/our_errors.h"

namespace featuremesh {

namespace {

constexpr double smallest_wanted_deg = 10;
constexpr double hopeless_below_deg = 0.5;  ///< the shortest edges asked for leave less than 3 degrees of it
constexpr std::size_t one_tet_in = 100;     ///< where more are small, it is not for a few places
constexpr std::size_t few_tets = 300;       ///< so many may be small in any mesh
constexpr double most_tets_more = 1.25;
constexpr std::size_t cheap_tets = 2000;  ///< so many more are no burden, where they do no more than double the mesh
constexpr std::size_t most_tries = 3;     ///< of a place
constexpr double most_longer = 4;         ///< than an angle asks for, see longer_
constexpr std::size_t most_tets_again = 2'000'000;  ///< in all rounds; each goes through the whole mesh once
constexpr double margin_of_first_try = 1.5;         ///< edge lengths around the tets; as much again in each other try
constexpr double reach_of_place = 3;  ///< edge lengths: what is filled again, and what mends its interface

/// A tet with an angle below 10 degrees that the shape does not force.
struct SmallTet {
    TetId tet;
    double angle_deg;
    Vec3 center;
    double longest;  ///< side, mm
};

std::array<Vec3, 4> corners_of(const Mesh& mesh, TetId tet) {
    const auto& [a, b, c, d] = mesh.tets[tet.index()];
    return {mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(d)};
}

SmallTet small_tet(const Mesh& mesh, TetId tet, double angle_deg) {
    const std::array<Vec3, 4> p = corners_of(mesh, tet);
    double longest = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, distance(p[i], p[j]));
    return {tet, angle_deg, (p[0] + p[1] + p[2] + p[3]) / 4, longest};
}

/// Of those that are new.
std::vector<SmallTet> small_tets(const Mesh& mesh, const MeshOrigin* origin) {
    std::vector<SmallTet> small;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        if (origin && origin->elements[t] >= 0) continue;
        const auto& [a, b, c, d] = corners_of(mesh, TetId(t));
        const double angle_deg = dihedral_range(a, b, c, d).smallest_deg;
        if (angle_deg < smallest_wanted_deg) small.push_back(small_tet(mesh, TetId(t), angle_deg));
    }
    if (small.empty()) return small;
    const SharpAngles sharp(mesh, QualityReport::small_angle_deg);
    std::erase_if(small, [&](const SmallTet& tet) { return sharp.force(tet.tet); });
    return small;
}

/// What is filled again together, and how good it is.
struct Place {
    Box box;
    std::vector<SmallTet> tets;

    double smallest_deg() const {
        double smallest = smallest_wanted_deg;
        for (const SmallTet& tet : tets) smallest = std::min(smallest, tet.angle_deg);
        return smallest;
    }
    /// With the small tets that it has now.
    Place as_in(const std::vector<SmallTet>& all) const {
        Place now{box, {}};
        for (const SmallTet& tet : all)
            if (box.contains(tet.center)) now.tets.push_back(tet);
        return now;
    }
    /// The smallest angle counts, and how many there are where it is about the same.
    bool is_better_than(const Place& other) const {
        constexpr double same_deg = 0.5;  // less is not worth the tets
        const double gain_deg = smallest_deg() - other.smallest_deg();
        return gain_deg > same_deg || (gain_deg > -same_deg && tets.size() < other.tets.size());
    }
};

/// Of all small tets those in none of the places.
Place beside(const std::vector<Place>& places, const std::vector<SmallTet>& all) {
    Place rest;
    for (const SmallTet& tet : all)
        if (std::none_of(places.begin(), places.end(),
                         [&](const Place& place) { return place.box.contains(tet.center); }))
            rest.tets.push_back(tet);
    return rest;
}

/// Boxes that reach `lengths` around the tets; those that meet are one place.
std::vector<Place> places_of(const std::vector<SmallTet>& small, const SizingField& sizing, double lengths) {
    std::vector<Place> places;
    for (const SmallTet& tet : small) {
        Box box;
        box.add(tet.center);
        Place place{box.grown(lengths * sizing.at(tet.center) + tet.longest), {tet}};
        for (std::size_t p = 0; p < places.size();) {
            if (!places[p].box.overlaps(place.box)) {
                ++p;
                continue;
            }
            place.box.add(places[p].box);
            place.tets.insert(place.tets.end(), places[p].tets.begin(), places[p].tets.end());
            places.erase(places.begin() + std::ptrdiff_t(p));
            p = 0;
        }
        places.push_back(std::move(place));
    }
    return places;
}

/// The tets count as changed, at each face that has one of their nodes and in space.
ChangedBoundary changed_at(const Brep& brep, const Mesh& mesh, const std::vector<Place>& places) {
    const std::size_t in_space = brep.face_count();
    std::vector<std::vector<std::array<Vec3, 3>>> of_face(in_space + 1);
    for (const Place& place : places)
        for (const SmallTet& tet : place.tets) {
            std::set<std::size_t> faces{in_space};
            for (const NodeId n : mesh.tets[tet.tet.index()])
                for (const FaceId face : brep.faces_at(mesh.entities[n.index()])) faces.insert(face.index());
            const auto& [a, b, c, d] = corners_of(mesh, tet.tet);
            for (const std::size_t face : faces)
                of_face[face].insert(of_face[face].end(), {{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}});
        }
    std::vector<std::array<Vec3, 3>> triangles;
    std::vector<std::size_t> ends;
    for (const auto& some : of_face) {
        triangles.insert(triangles.end(), some.begin(), some.end());
        ends.push_back(triangles.size());
    }
    return {std::move(triangles), ends};
}

/// Of a part to itself. No face is said to be as it was, so that whatever lies near the change may go.
FeatureDifference nothing_but(ChangedBoundary changed, const Brep& brep) {
    CarriedRegion all;
    all.changed = std::move(changed);
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        all.surface_of_old_face.push_back(int(f));
        all.new_face_of.emplace_back(f);
        all.new_faces_of.push_back({FaceId(f)});
    }
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        all.new_edge_of.emplace_back(e);
        all.new_edges_of.push_back({EdgeId(e)});
    }
    for (std::size_t v = 0; v < brep.vertex_count(); ++v) all.new_vertex_of.emplace_back(v);
    FeatureDifference difference;
    difference.regions.push_back(std::move(all));
    return difference;
}

double most_tets_for(std::size_t tets) {
    return std::max(most_tets_more * double(tets), double(tets + std::min(tets, cheap_tets)));
}

class AngleMender {
  public:
    AngleMender(const Brep& brep, MeshOptions options, std::span<const SizeSource> sources, Filled& filled,
                MeshOrigin* origin, std::vector<Round>& rounds, RunContext& context)
        : brep_(brep),
          options_(std::move(options)),
          sources_(sources.begin(), sources.end()),
          filled_(filled),
          origin_(origin),
          most_tets_(most_tets_for(filled.mesh.tets.size())),
          rounds_(rounds),
          context_(context) {
        options_.sizing.refines_narrow_faces = filled.refines_narrow_faces;
        options_.volume.smallest_asked = filled.sizing->smallest();
        options_.volume.moves_kept_nodes = true;
        options_.volume.looks_ahead_beside_kept = !origin;
        sources_.insert(sources_.end(), filled.shorter.begin(), filled.shorter.end());
        if (origin) first_tets_ = std::size_t(std::count(origin->elements.begin(), origin->elements.end(), -1));
        filled_tets_ = first_tets_;
    }

    void run() {
        std::vector<SmallTet> small = small_tets(filled_.mesh, origin_);
        if (small.empty() || small.size() > std::max(few_tets, filled_.mesh.tets.size() / one_tet_in)) return;
        field_ = with_sources(*filled_.sizing, sources_);
        const std::size_t rounds = std::max<std::size_t>(1, most_tets_again / filled_.mesh.tets.size());
        for (std::size_t round = 0; round < rounds && rounds_.size() < most_rounds && !is_dear(); ++round) {
            const std::vector<Place> places = places_to_mend(small);
            if (places.empty() || !fill_again(places, small)) return;
        }
    }

  private:
    /// An update is to stay cheap beside a filling of the whole part.
    bool is_dear() const {
        return origin_ && filled_tets_ > std::min(std::max(2 * first_tets_, cheap_tets), filled_.mesh.tets.size());
    }

    /// Those where it failed come last, and are left after some tries.
    std::vector<Place> places_to_mend(const std::vector<SmallTet>& small) const {
        std::vector<std::vector<Place>> by_tries(most_tries + 1);
        for (Place& place : places_of(small, *field_, reach_of_place))
            if (place.smallest_deg() >= hopeless_below_deg)
                by_tries[std::min(tries(place), most_tries)].push_back(std::move(place));
        for (std::size_t t = 0; t < most_tries; ++t)
            if (!by_tries[t].empty()) return by_tries[t];
        return {};
    }

    std::size_t tries(const Place& place) const {
        return std::size_t(
            std::count_if(failed_.begin(), failed_.end(), [&](const Box& box) { return box.overlaps(place.box); }));
    }

    /// An angle is about a height over the length; with this length it is a good one. In any case it is another field
    /// than before.
    SizeSource wanted(const SmallTet& tet, std::size_t tries) const {
        constexpr double wanted_deg = 20, least_share = 0.15, shorter = 0.8;
        const double length = longer_ * tet.longest * std::max(least_share, tet.angle_deg / wanted_deg);
        return shorter_than_asked(
            *field_, {tet.center, std::min(length, std::pow(shorter, double(tries + 1)) * field_->at(tet.center))});
    }

    /// Takes the filling where some place is better and none worse. False where nothing can be kept beside the places,
    /// or they cannot be filled so (nor could they with more around them in any of 160 parts), or there is no room for
    /// more tets.
    bool fill_again(const std::vector<Place>& places, std::vector<SmallTet>& small) {
        std::vector<SizeSource> sources = sources_;
        for (const Place& place : places)
            for (const SmallTet& tet : place.tets) sources.push_back(wanted(tet, tries(place)));
        const SizingField shorter = with_sources(*field_, sources);
        Kept kept = kept_beside(places, shorter);
        if (kept.node_origin.empty()) return false;
        const SolidId first = filled_.mesh.tet_solids[places.front().tets.front().tet.index()];
        rounds_.push_back({"small angles", as_parameter(first), "shorter edges there", {}});
        MeshOrigin origin{std::move(kept.node_origin), std::move(kept.tet_origin)};
        const std::size_t kept_tets = kept.mesh.tets.size(), first_round = rounds_.size();
        auto filled = fill_part(brep_, shorter, std::move(kept), options_, sources, rounds_, context_);
        auto* again = std::get_if<Filled>(&filled);
        if (!again) return false;
        const std::size_t tets = again->mesh.tets.size();
        filled_tets_ += (tets - std::min(tets, kept_tets)) * (1 + rounds_.size() - first_round);
        if (origin_) origin = through(*origin_, origin_of(*again, std::move(origin), filled_.mesh, tets, context_));
        auto now = small_tets_of(*again, origin_ ? &origin : nullptr);
        if (!is_gain(places, small, now ? *now : small)) return double(tets) <= most_tets_ || ask_for_longer();
        has_gained_ = true;
        small = *std::move(now);
        filled_.mesh = std::move(again->mesh);
        if (origin_) *origin_ = std::move(origin);
        sources_ = std::move(sources);
        field_ = shorter;
        return true;
    }

    /// For the next tries, where the last one took too many tets. False when that would be in vain.
    bool ask_for_longer() {
        if (has_gained_ || longer_ >= most_longer) return false;
        longer_ *= 2;
        return true;
    }

    /// None where it is no mesh that may be taken.
    std::optional<std::vector<SmallTet>> small_tets_of(const Filled& again, const MeshOrigin* origin) const {
        if (!again.why_straight.empty() || again.smallest_jacobian < filled_.smallest_jacobian ||
            double(again.mesh.tets.size()) > most_tets_)
            return std::nullopt;
        return small_tets(again.mesh, origin);
    }

    Kept kept_beside(const std::vector<Place>& places, const SizingField& shorter) const {
        const FeatureDifference difference = nothing_but(changed_at(brep_, filled_.mesh, places), brep_);
        const double margin = margin_of_first_try * double(1 + tries(places.front()));
        return keep({filled_.mesh,
                     brep_,
                     brep_,
                     difference,
                     *field_,
                     shorter,
                     {},
                     margin,
                     AskedSizes::same_lengths,
                     options_.ignored_below},
                    context_);
    }

    /// Notes where nothing was gained.
    bool is_gain(const std::vector<Place>& places, const std::vector<SmallTet>& before,
                 const std::vector<SmallTet>& now) {
        const bool is_rest_worse = beside(places, before).is_better_than(beside(places, now));
        bool is_any_worse = is_rest_worse, is_any_better = false;
        for (const Place& place : places) {
            const Place then = place.as_in(now);
            is_any_worse |= place.is_better_than(then);
            const bool gains =
                !is_rest_worse && then.is_better_than(place) && (longer_ == 1 || then.tets.size() < place.tets.size());
            is_any_better |= gains;
            if (!gains) failed_.push_back(place.box);
        }
        return is_any_better && !is_any_worse;
    }

    const Brep& brep_;
    MeshOptions options_;
    std::vector<SizeSource> sources_;  ///< the field's own, and what was asked for since
    std::optional<SizingField> field_;
    std::vector<Box> failed_;  ///< places
    double longer_ = 1;  ///< times the length that an angle asks for, which took too many tets: fewer are to be small
    bool has_gained_ = false;
    Filled& filled_;
    MeshOrigin* origin_;                            ///< of its mesh
    std::size_t first_tets_ = 0, filled_tets_ = 0;  ///< by the first filling, and by all
    double most_tets_;
    std::vector<Round>& rounds_;
    RunContext& context_;
};

}  // namespace

void mend_small_angles(const Brep& brep, MeshOptions options, std::span<const SizeSource> sources, Filled& filled,
                       MeshOrigin* origin, std::vector<Round>& rounds, RunContext& context) {
    if (brep.dimension() != Dimension::solids || !filled.why_straight.empty()) return;
    const Message why =
        why_failed([&] { AngleMender(brep, std::move(options), sources, filled, origin, rounds, context).run(); });
    if (!why.empty()) rounds.push_back({"small angles", {}, "they stay", why});
}

}  // namespace featuremesh

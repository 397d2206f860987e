// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/partners.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "brep/solid_probe.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "difference/boundary_model.h"
#include "difference/place_partners.h"
#include "difference/underlying_geometry.h"

namespace featuremesh {
namespace {
class PartnerFinder {
  public:
    PartnerFinder(const BoundaryPair& pair, const BoundaryMatch& match)
        : pair_(pair),
          match_(match),
          old_borders_(pair.old_model.faces().size()),
          new_borders_(pair.new_model.faces().size()) {}

    /// Finds the new edges for each old edge. Edges of touching solids lie on one another, so there may be several:
    /// first those of the same solid, then those with the most faces at the old edge as neighbours, then those that
    /// overlap it most and go beyond it least. What is another old solid's is none.
    void find_edges(CarriedRegion& region) const {
        std::vector<std::vector<EdgeId>> new_edges_on(match_.curves.size());
        for (std::size_t e = 0; e < match_.new_edges.size(); ++e)
            if (match_.new_edges[e].curve >= 0)
                new_edges_on[std::size_t(match_.new_edges[e].curve)].push_back(EdgeId(e));
        region.new_edge_of.assign(match_.old_edges.size(), EdgeId());
        region.new_edges_of.assign(match_.old_edges.size(), {});
        for (std::size_t e = 0; e < match_.old_edges.size(); ++e) {
            if (match_.old_edges[e].curve < 0) continue;
            std::vector<std::tuple<Kinship, int, double, EdgeId>> found;
            for (const EdgeId candidate : new_edges_on[std::size_t(match_.old_edges[e].curve)]) {
                const Stretch &was = match_.old_edges[e], &is = match_.new_edges[candidate.index()];
                const double common = overlap(was, is);
                if (common == 0) continue;
                const Kinship kinship = kinship_of(faces_at(EdgeId(e), false), faces_at(candidate, true));
                if (kinship == Kinship::none) continue;
                found.emplace_back(kinship, -faces_in_common(EdgeId(e), candidate, region),
                                   -common / (was.last - was.first + is.last - is.first - common), candidate);
            }
            std::sort(found.begin(), found.end());
            for (const auto& [kinship, faces, share, id] : found) region.new_edges_of[e].push_back(id);
            if (!found.empty()) region.new_edge_of[e] = std::get<EdgeId>(found[0]);
        }
    }

    /// Of vertices in one place (solids that touch) the one at which most of the old one's edges go on.
    void find_vertices(CarriedRegion& region) const {
        region.new_vertex_of = match_.new_vertex_of;
        const Brep &old_brep = pair_.old_model.brep(), &new_brep = pair_.new_model.brep();
        for (std::size_t v = 0; v < region.new_vertex_of.size(); ++v) {
            VertexId& partner = region.new_vertex_of[v];
            if (!partner.is_valid()) continue;
            const Vec3 place = new_brep.point_of(partner);
            std::map<VertexId, int> votes;
            for (const EdgeId e : old_brep.edges_of(VertexId(v)))
                if (const EdgeId now = region.new_edge_of[e.index()]; now.is_valid())
                    for (const VertexId end : new_brep.ends_of(now))
                        if (end.is_valid() && distance(new_brep.point_of(end), place) <= pair_.sameness.length)
                            ++votes[end];
            int most = votes.contains(partner) ? votes.at(partner) : 0;
            for (const auto& [vertex, count] : votes)
                if (count > most) most = count, partner = vertex;
        }
    }

    /// Those of the same solid first, then those that have most of their border in common.
    void find_faces(CarriedRegion& region) {
        std::vector<std::vector<std::pair<double, FaceId>>> candidates(match_.group_of_old_face.size());
        for (const SurfaceGroup& group : match_.groups)
            for (const FaceId f : group.in_domain ? group.old_faces : std::vector<FaceId>{}) {
                const bool alone = group.is_unchanged() && group.old_faces.size() == 1 && group.new_faces.size() == 1;
                for (const FaceId candidate : group.new_faces)
                    if (const double share = alone ? 1.0 : overlap(f, candidate); share > 0)
                        candidates[f.index()].emplace_back(-share, candidate);
            }
        for (auto& found : candidates) std::sort(found.begin(), found.end());
        find_solids(candidates);
        region.new_face_of.assign(candidates.size(), FaceId());
        region.new_faces_of.assign(candidates.size(), {});
        for (std::size_t f = 0; f < candidates.size(); ++f) {
            const FaceId old_face(f);
            const auto kinship = [&](const auto& found) { return kinship_of({&old_face, 1}, {&found.second, 1}); };
            std::erase_if(candidates[f], [&](const auto& found) { return kinship(found) == Kinship::none; });
            std::stable_partition(candidates[f].begin(), candidates[f].end(),
                                  [&](const auto& found) { return kinship(found) == Kinship::own; });
            for (const auto& [share, id] : candidates[f]) region.new_faces_of[f].push_back(id);
            if (!candidates[f].empty()) region.new_face_of[f] = candidates[f][0].second;
        }
    }

    /// Whether they have a border in common or one reaches into the other.
    bool do_overlap(FaceId old_face, FaceId new_face) const {
        const double share = overlap(old_face, new_face);
        return share > barely ||
               (share > 0 && (reaches_into(new_face, true, old_face) || reaches_into(old_face, false, new_face)));
    }

    /// Every edge of the old face is an edge of the new one, and no other.
    bool same_trim(FaceId old_face, FaceId new_face) const {
        const std::vector<Border>&old_border = border(old_face, false), &new_border = border(new_face, true);
        return old_border.size() == new_border.size() &&
               std::equal(old_border.begin(), old_border.end(), new_border.begin(),
                          [&](const Border& a, const Border& b) {
                              return a.curve == b.curve && a.left == b.left &&
                                     std::abs(a.first - b.first) <= tolerance(a.curve) &&
                                     std::abs(a.last - b.last) <= tolerance(a.curve);
                          });
    }

  private:
    static constexpr double barely = 1e-9;

    /// A stretch of a face's border, seen so that it compares.
    struct Border {
        int curve;
        bool left;
        double first, last;
        bool operator<(const Border& b) const {
            return std::tie(curve, left, first, last) < std::tie(b.curve, b.left, b.first, b.last);
        }
    };

    /// Which new solid each old one became: the one that has most of its faces, each but once. Where solids coincide,
    /// the one that is counted alike.
    void find_solids(const std::vector<std::vector<std::pair<double, FaceId>>>& candidates) {
        const Brep &old_brep = pair_.old_model.brep(), &new_brep = pair_.new_model.brep();
        if (old_brep.solid_count() < 2 || new_brep.solid_count() < 2) return;
        std::map<std::pair<SolidId, SolidId>, int> votes;
        for (std::size_t f = 0; f < candidates.size(); ++f)
            for (const auto& [share, face] : candidates[f])
                for (const SolidId was : old_brep.solids_beside(FaceId(f)))
                    for (const SolidId is : new_brep.solids_beside(face))
                        if (was.is_valid() && is.is_valid()) ++votes[{was, is}];
        std::vector<std::tuple<int, bool, SolidId, SolidId>> ranked;
        for (const auto& [pair, count] : votes)
            ranked.emplace_back(-count, pair.first != pair.second, pair.first, pair.second);
        std::sort(ranked.begin(), ranked.end());
        is_taken_.assign(new_brep.solid_count(), 0);
        new_solid_of_.assign(old_brep.solid_count(), SolidId());
        for (const auto& [count, differs, was, is] : ranked)
            if (!new_solid_of_[was.index()].is_valid() && !std::exchange(is_taken_[is.index()], 1))
                new_solid_of_[was.index()] = is;
    }

    std::span<const FaceId> faces_at(EdgeId edge, bool is_new) const {
        return (is_new ? pair_.new_model : pair_.old_model).brep().faces_of(edge);
    }

    enum class Kinship { own, possible, none };

    /// Of new faces with old ones: their own where both bound one solid, before and after; none where what the new ones
    /// bound is what another old solid became, and the old ones' solid became something else; else possible.
    Kinship kinship_of(std::span<const FaceId> old_faces, std::span<const FaceId> new_faces) const {
        if (new_solid_of_.empty()) return Kinship::possible;
        bool is_of_another = false;
        for (const FaceId was : old_faces)
            for (const SolidId solid : pair_.old_model.brep().solids_beside(was))
                for (const FaceId is : new_faces)
                    for (const SolidId other : pair_.new_model.brep().solids_beside(is)) {
                        if (!solid.is_valid() || !other.is_valid()) continue;
                        const SolidId now = new_solid_of_[solid.index()];
                        if (now == other) return Kinship::own;
                        is_of_another = is_of_another || (now.is_valid() && is_taken_[other.index()]);
                    }
        return is_of_another ? Kinship::none : Kinship::possible;
    }

    /// How many faces at the old edge have a partner at the new one.
    int faces_in_common(EdgeId old_edge, EdgeId new_edge, const CarriedRegion& region) const {
        const auto at_new = faces_at(new_edge, true);
        int count = 0;
        for (const FaceId f : faces_at(old_edge, false)) {
            const std::vector<FaceId>& partners = region.new_faces_of[f.index()];
            count += std::any_of(partners.begin(), partners.end(), [&](FaceId partner) {
                return std::find(at_new.begin(), at_new.end(), partner) != at_new.end();
            });
        }
        return count;
    }

    double tolerance(int curve) const {
        const UnderlyingCurve& c = match_.curves[std::size_t(curve)];
        return period_of(c) > 0 ? pair_.sameness.length / c.radius : pair_.sameness.length;
    }

    /// Length in curve parameters that both have in common.
    double overlap(const Stretch& a, const Stretch& b) const {
        const double period = period_of(match_.curves[std::size_t(a.curve)]);
        double share = 0;
        for (int turn = period > 0 ? -1 : 0; turn <= (period > 0 ? 1 : 0); ++turn)
            share +=
                std::max(0.0, std::min(a.last, b.last + turn * period) - std::max(a.first, b.first + turn * period));
        return share > tolerance(a.curve) ? share : 0;
    }

    double length_of(int curve, double share) const {
        const UnderlyingCurve& c = match_.curves[std::size_t(curve)];
        return period_of(c) > 0 ? share * c.radius : share;
    }

    const std::vector<Border>& border(FaceId id, bool is_new) const {
        std::optional<std::vector<Border>>& known = (is_new ? new_borders_ : old_borders_)[id.index()];
        if (!known) known = border_of(id, is_new);
        return *known;
    }

    std::vector<Border> border_of(FaceId id, bool is_new) const {
        const BoundaryFace& face = (is_new ? pair_.new_model : pair_.old_model).faces()[id.index()];
        const bool as_group = (is_new ? match_.new_normal_as_group : match_.old_normal_as_group)[id.index()] != 0;
        std::vector<Border> result;
        for (const EdgeUse& use : face.uses) {
            const Stretch& s = (is_new ? match_.new_edges : match_.old_edges)[use.edge.index()];
            result.push_back({s.curve, (use.forward == s.along) == as_group, s.first, s.last});
        }
        std::sort(result.begin(), result.end());
        return result;
    }

    bool boxes_meet(FaceId old_face, FaceId new_face) const {
        const Box was = moved(pair_.old_model.faces()[old_face.index()].box, pair_.motion).grown(pair_.sameness.length);
        const Box& is = pair_.new_model.faces()[new_face.index()].box;
        return was.overlaps(is) && (!pair_.domain || (pair_.domain->overlaps(was) && pair_.domain->overlaps(is)));
    }

    /// Border that both have left of them, or both right, mm; `barely` when there is none but their boxes meet; 0 when
    /// they are apart.
    double overlap(FaceId old_face, FaceId new_face) const {
        if (!boxes_meet(old_face, new_face)) return 0;
        const std::vector<Border>&was = border(old_face, false), &is = border(new_face, true);
        double share = 0;
        for (const Border& a : was)
            for (auto b = std::lower_bound(is.begin(), is.end(), Border{a.curve, a.left, -1e300, 0});
                 a.curve >= 0 && b != is.end() && b->curve == a.curve && b->left == a.left; ++b)
                share += length_of(a.curve,
                                   overlap(Stretch{a.curve, a.first, a.last}, Stretch{b->curve, b->first, b->last}));
        return share > 0 ? share : barely;
    }

    /// The whole edge is on edges of the other state's face, so no point of it is inside: to ask for one is what the
    /// kernel is slowest at.
    bool runs_along_border(EdgeId edge, bool is_new, const BoundaryFace& other) const {
        const Stretch& own = (is_new ? match_.new_edges : match_.old_edges)[edge.index()];
        if (own.curve < 0) return false;
        double covered = 0;
        std::set<EdgeId> edges;  // a seam is used twice
        for (const EdgeUse& use : other.uses) {
            const Stretch& border = (is_new ? match_.old_edges : match_.new_edges)[use.edge.index()];
            if (border.curve == own.curve && edges.insert(use.edge).second) covered += overlap(own, border);
        }
        return covered >= own.last - own.first - tolerance(own.curve);
    }

    /// Whether a point of the border of one face is inside the other state's face.
    bool reaches_into(FaceId id, bool is_new, FaceId other) const {
        const BoundaryModel& model = is_new ? pair_.new_model : pair_.old_model;
        const BoundaryModel& other_model = is_new ? pair_.old_model : pair_.new_model;
        const BoundaryFace& target = other_model.faces()[other.index()];
        if (target.underlying.kind == SurfaceKind::free_form) return true;
        const RigidMotion motion = is_new ? pair_.motion.inverse() : pair_.motion;
        const Box near_target = target.box.grown(pair_.sameness.length);
        for (const EdgeUse& use : model.faces()[id.index()].uses) {
            const BoundaryEdge& edge = model.edges()[use.edge.index()];
            if (!moved(edge.box, motion).grown(pair_.sameness.length).overlaps(near_target)) continue;
            if (runs_along_border(use.edge, is_new, target)) continue;
            const UnderlyingCurve& curve = edge.curve;
            for (int i = 0; i < 8; ++i) {
                const Vec3 p = motion.apply(point_at(curve, curve.first + (curve.last - curve.first) * i / 8));
                if (near_target.contains(p) &&
                    other_model.classify(other, parameters_of(target.underlying, p)) == Containment::inside)
                    return true;
            }
        }
        return false;
    }

    const BoundaryPair& pair_;
    const BoundaryMatch& match_;
    mutable std::vector<std::optional<std::vector<Border>>> old_borders_, new_borders_;  // those asked for
    std::vector<SolidId> new_solid_of_;  // by old solid; empty where there is but one
    std::vector<char> is_taken_;         // by new solid, whether it is one of these
};

}  // namespace

void find_partners(const BoundaryPair& pair, const BoundaryMatch& match, CarriedRegion& region) {
    PartnerFinder finder(pair, match);
    finder.find_faces(region);
    finder.find_edges(region);
    finder.find_vertices(region);
}

namespace {
/// What became of the old faces. One that has a twin, a face of the same border, has nothing to do with any other:
/// those of one solid do not overlap, and another solid's is its own.
class FaceHistory {
  public:
    FaceHistory(const BoundaryPair& pair, const BoundaryMatch& match, const CarriedRegion& region)
        : match_(match),
          region_(region),
          finder_(pair, match),
          twins_of_(match.group_of_old_face.size()),
          has_twin_(match.group_of_new_face.size(), 0),
          has_partner_(match.group_of_new_face.size(), 0) {
        for (std::size_t f = 0; f < twins_of_.size(); ++f)
            for (const FaceId partner : region.new_faces_of[f])
                if (finder_.same_trim(FaceId(f), partner))
                    twins_of_[f].push_back(partner), has_twin_[partner.index()] = 1;
    }

    std::vector<FaceChange> changes() {
        std::vector<FaceChange> changes;
        for (std::size_t f = 0; f < twins_of_.size(); ++f) changes.push_back(change_of(FaceId(f)));
        for (std::size_t f = 0; f < has_partner_.size(); ++f)
            if (!has_partner_[f] && !has_twin_[f])
                changes.push_back({BoundaryVerdict::appeared, FaceId(), FaceId(f), {}, {}, false, {}});
        return changes;
    }

  private:
    /// Marks the new faces that overlap the old one.
    FaceChange change_of(FaceId f) {
        FaceChange change{BoundaryVerdict::vanished, f, FaceId(), {}, {}, false, {}};
        if (const std::vector<FaceId>& twins = twins_of_[f.index()]; !twins.empty()) {
            change.verdict = BoundaryVerdict::kept;
            change.new_faces = {twins.front()};
        }
        for (const FaceId partner : region_.new_faces_of[f.index()]) {
            if (change.verdict == BoundaryVerdict::kept || has_twin_[partner.index()] ||
                !finder_.do_overlap(f, partner))
                continue;
            has_partner_[partner.index()] = 1;
            change.new_faces.push_back(partner);
        }
        if (change.new_faces.empty()) return change;
        change.new_face = change.new_faces.front();
        if (change.verdict == BoundaryVerdict::vanished)
            change.verdict = match_.groups[std::size_t(match_.group_of_old_face[f.index()])].is_unchanged()
                                 ? BoundaryVerdict::kept
                                 : BoundaryVerdict::trimmed_differently;
        return change;
    }

    const BoundaryMatch& match_;
    const CarriedRegion& region_;
    const PartnerFinder finder_;
    std::vector<std::vector<FaceId>> twins_of_;  // by old face
    std::vector<char> has_twin_, has_partner_;   // by new face
};
}  // namespace

std::vector<FaceChange> face_changes(const BoundaryPair& pair, const BoundaryMatch& match,
                                     const CarriedRegion& region) {
    return FaceHistory(pair, match, region).changes();
}

namespace {
/// The comparison of two shapes by place, with all that it needs.
struct PlaceComparison {
    PlaceComparison(const Brep& from, const Brep& to, const RigidMotion& motion)
        : from_model(from),
          to_model(to),
          pair{from_model, to_model, motion, std::nullopt, sameness_of(from.box(), to.box())} {
        match = match_boundaries(pair);
        find_partners(pair, match, region);
    }

    const BoundaryModel from_model, to_model;
    const BoundaryPair pair;
    BoundaryMatch match;
    CarriedRegion region;
};
}  // namespace

std::vector<FaceChange> faces_in_place(const Brep& from, const Brep& to, const RigidMotion& motion) {
    const PlaceComparison found(from, to, motion);
    return face_changes(found.pair, found.match, found.region);
}

PlacePartners partners_in_place(const Brep& from, const Brep& to) {
    PlaceComparison found(from, to, RigidMotion{});
    PlacePartners partners{std::vector<std::vector<FaceId>>(from.face_count()), std::move(found.region.new_edges_of),
                           std::move(found.region.new_vertex_of)};
    for (const FaceChange& change : face_changes(found.pair, found.match, found.region))
        if (change.old_face.is_valid()) partners.faces[change.old_face.index()] = change.new_faces;
    return partners;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/followed_faces.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "brep/occt_geometry.h"
#include "brep/solid_probe.h"
#include "core/geometry.h"
#include "difference/array_elements.h"
#include "difference/made_partners.h"
#include "difference/made_pieces.h"
#include "difference/place_partners.h"
#include "difference/underlying_geometry.h"
#include "features/feature_tree.h"

namespace featuremesh {

namespace {
constexpr double most_of_it = 0.3;  // share of a face that two faces have in common when one is a piece of the other
constexpr double nearby = 0.2;      // of a face's diagonal: how far one may have gone, or grown, that is the same one

template <class List, class T>
bool contains(const List& list, const T& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

class FaceFollower {
  public:
    FaceFollower(const MadeFaces& was, const MadeFaces& is)
        : old_(was.state()),
          new_(is.state()),
          was_(was),
          is_(is),
          partners_(partners_of_made_faces(was, is)),
          pieces_(was, is),
          elements_(old_.tree, new_.tree) {
        followed_.resize(old_.brep.face_count());
        in_place_.resize(followed_.size());
        claimed_.assign(new_.brep.face_count(), 0);
        taken_ = claimed_;
        old_boxes_.resize(followed_.size());
        new_boxes_.resize(claimed_.size());
        for (std::size_t f = 0; f < followed_.size(); ++f) followed_[f].old_face = FaceId(f);
        for (const FaceChange& change : faces_in_place(old_.brep, new_.brep, RigidMotion{}))
            if (change.old_face.is_valid()) in_place_[change.old_face.index()] = change;
    }

    std::vector<FollowedFace> run() {
        motion_ = motion_of_all();
        if (motion_) follow_motion(*motion_);
        find_candidates();
        for (std::size_t f = 0; f < followed_.size(); ++f) follow_kept(FaceId(f));
        const std::vector<char> kept = claimed_;
        for (std::size_t f = 0; f < followed_.size(); ++f)
            if (is_open(FaceId(f))) follow_origin(FaceId(f), kept);
        follow_moved_solids();
        for (std::size_t f = 0; f < followed_.size(); ++f) follow_place(FaceId(f), BoundaryVerdict::kept);
        while (follow_neighbours()) {
        }
        for (std::size_t f = 0; f < followed_.size(); ++f)
            follow_place(FaceId(f), BoundaryVerdict::trimmed_differently);
        while (follow_neighbours()) {
        }
        for (FollowedFace& followed : followed_) find_pieces_within(followed);
        return std::move(followed_);
    }

  private:
    /// A volume of a feature and, of a copy, those that it copies.
    using Origin = std::vector<VolumeName>;

    void follow(FaceId f, const std::vector<FaceId>& faces, FollowedBy by) {
        FollowedFace& followed = followed_[f.index()];
        followed.new_faces = faces;
        std::sort(followed.new_faces.begin(), followed.new_faces.end());
        followed.by = by;
        for (const FaceId g : faces) taken_[g.index()] = 1, claimed_[g.index()] |= by != FollowedBy::place;
    }
    bool is_open(FaceId f) const { return followed_[f.index()].by == FollowedBy::nothing; }

    // By what made the face

    /// New faces of the final shape on the made faces that those of the old one became.
    void find_candidates() {
        candidates_.resize(followed_.size());
        is_of_other_solid_.assign(followed_.size(), 0);
        for (std::size_t f = 0; f < followed_.size(); ++f) {
            std::set<FaceId> found;
            for (const int m : was_.made(FaceId(f)))
                for (const int n : partners_[std::size_t(m)])
                    found.insert(pieces_.new_on(n).begin(), pieces_.new_on(n).end());
            candidates_[f].assign(found.begin(), found.end());
        }
        if (old_.brep.solid_count() > 1) leave_other_solids_theirs();
    }

    /// Two parts may be made of one feature, of which only one moved, so that the feature tells of that one alone.
    void leave_other_solids_theirs() {
        solids_now_ = find_solids_now();
        std::vector<char> is_own(claimed_.size(), 0);  // by new face: a candidate of what became its solid
        for (std::size_t f = 0; f < followed_.size(); ++f)
            for (const FaceId g : candidates_[f]) is_own[g.index()] |= became_solid_of(FaceId(f), g);
        for (std::size_t f = 0; f < followed_.size(); ++f) {
            if (!has_solid_now(FaceId(f))) continue;
            const auto is_in_own = [&](FaceId g) { return became_solid_of(FaceId(f), g); };
            const bool has_own = std::any_of(candidates_[f].begin(), candidates_[f].end(), is_in_own);
            is_of_other_solid_[f] =
                std::erase_if(candidates_[f], [&](FaceId g) {
                    return !is_in_own(g) && (is_own[g.index()] || (has_own && is_of_known_solid(g)));
                }) > 0;
        }
    }

    bool has_solid_now(FaceId f) const {
        const auto solids = old_.brep.solids_beside(f);
        return std::any_of(solids.begin(), solids.end(),
                           [&](SolidId was) { return was.is_valid() && solids_now_[was.index()].is_valid(); });
    }

    bool is_of_known_solid(FaceId g) const {
        const auto solids = new_.brep.solids_beside(g);
        return std::any_of(solids.begin(), solids.end(),
                           [&](SolidId is) { return is.is_valid() && contains(solids_now_, is); });
    }

    bool became_solid_of(FaceId f, FaceId g) const {
        for (const SolidId was : old_.brep.solids_beside(f))
            for (const SolidId is : new_.brep.solids_beside(g))
                if (was.is_valid() && is.is_valid() && solids_now_[was.index()] == is) return true;
        return false;
    }

    /// By old solid the new one that has most candidates of its faces, of several old ones that of most, but first what
    /// lies in the same volumes; none where it is that of another one.
    std::vector<SolidId> find_solids_now() const {
        struct Pair {
            SolidId was, is;
            bool in_same_volumes = false;
            int candidates = 0, kept = 0;  ///< faces that have one there, and that are there in their place
        };
        const std::vector<std::set<Origin>> olds = volumes_around_solids(was_), news = volumes_around_solids(is_);
        std::map<std::pair<SolidId, SolidId>, Pair> met;
        for (std::size_t f = 0; f < followed_.size(); ++f) {
            std::set<SolidId> found;
            for (const FaceId g : candidates_[f])
                for (const SolidId is : new_.brep.solids_beside(g)) found.insert(is);
            const FaceChange& place = in_place_[f];
            for (const SolidId was : old_.brep.solids_beside(FaceId(f)))
                for (const SolidId is : found) {
                    if (!was.is_valid() || !is.is_valid()) continue;
                    const bool same = !olds[was.index()].empty() && olds[was.index()] == news[is.index()];
                    Pair& pair = met.try_emplace({was, is}, Pair{was, is, same}).first->second;
                    ++pair.candidates;
                    if (place.verdict == BoundaryVerdict::kept)
                        pair.kept += contains(new_.brep.solids_beside(place.new_face), is);
                }
        }
        std::vector<Pair> pairs;
        for (const auto& [solids, pair] : met) pairs.push_back(pair);
        std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
            return std::tuple(a.in_same_volumes, a.candidates, a.kept) >
                   std::tuple(b.in_same_volumes, b.candidates, b.kept);
        });
        std::vector<SolidId> now(old_.brep.solid_count());
        for (const Pair& pair : pairs)
            if (!now[pair.was.index()].is_valid() && !contains(now, pair.is)) now[pair.was.index()] = pair.is;
        return now;
    }

    /// By solid those that it lies in.
    std::vector<std::set<Origin>> volumes_around_solids(const MadeFaces& made) const {
        const Brep& brep = made.state().brep;
        std::vector<std::optional<Vec3>> points;
        for (std::size_t s = 0; s < brep.solid_count(); ++s) points.push_back(point_inside(brep.solid(SolidId(s))));
        std::vector<std::set<Origin>> around(points.size());
        for (const MadePiece& piece : made.pieces()) {
            if (piece.effect != Effect::adds) continue;
            const Box box = box_of(piece.solid);
            std::optional<SolidProbe> probe;
            for (std::size_t s = 0; s < points.size(); ++s) {
                if (!points[s] || !box.contains(*points[s])) continue;
                if (!probe) probe.emplace(piece.solid);
                if (probe->containment_of(*points[s]) == Containment::inside) around[s].insert(origin_of(made, piece));
            }
        }
        return around;
    }

    /// Where it is also kept in place, that is it.
    void follow_kept(FaceId f) {
        const FaceChange& place = in_place_[f.index()];
        if (place.verdict == BoundaryVerdict::kept && contains(candidates_[f.index()], place.new_face))
            follow(f, {place.new_face}, FollowedBy::origin);
    }

    /// Points tell which pieces of a made face belong together. What another face was `kept` as is none of them, though
    /// solids that overlap have both on one made face.
    void follow_origin(FaceId f, const std::vector<char>& kept) {
        std::vector<FaceId> candidates = candidates_[f.index()];
        std::erase_if(candidates, [&](FaceId g) { return kept[g.index()]; });
        if (candidates.empty()) return;
        const bool is_one = candidates.size() == 1 && !has_siblings(f);
        if (!is_one || stays(f)) std::erase_if(candidates, [&](FaceId g) { return !share_points(f, g); });
        if (!candidates.empty()) follow(f, candidates, FollowedBy::origin);
    }

    /// Are there other faces of the old final shape on one of its made faces?
    bool has_siblings(FaceId f) const {
        return std::any_of(was_.made(f).begin(), was_.made(f).end(),
                           [&](int m) { return pieces_.old_on(m).size() > 1; });
    }

    bool stays(FaceId f) const {
        return std::all_of(was_.made(f).begin(), was_.made(f).end(), [&](int m) {
            const std::vector<int>& to = partners_[std::size_t(m)];
            return std::all_of(to.begin(), to.end(), [&](int n) { return is_image_in_place(m, n); });
        });
    }

    bool is_image_in_place(int m, int n) const {
        return was_.faces()[std::size_t(m)].probe.box().is_close_to(is_.faces()[std::size_t(n)].probe.box(),
                                                                    boolean_tolerance);
    }

    /// Does most of one lie on the other, where the made face takes it along?
    bool share_points(FaceId f, FaceId g) {
        for (const int m : was_.made(f))
            for (const int n : partners_[std::size_t(m)])
                if (contains(is_.made(g), n) && pieces_.in_common(f, m, g, n) > most_of_it) return true;
        return false;
    }

    static bool is_between_solids(const Brep& brep, FaceId f) {
        const auto solids = brep.solids_beside(f);
        return solids[0].is_valid() && solids[1].is_valid();
    }

    /// Those that are of no old face.
    void find_pieces_within(FollowedFace& followed) {
        const FaceId f = followed.old_face;
        if (followed.new_faces.empty() || is_between_solids(old_.brep, f)) return;
        std::set<FaceId> found;
        for (const int m : was_.made(f))
            for (const int n : partners_[std::size_t(m)])
                for (const FaceId g : pieces_.new_on(n))
                    if (!taken_[g.index()] && is_between_solids(new_.brep, g) && share_points(f, g)) found.insert(g);
        followed.within.assign(found.begin(), found.end());
    }

    // By its place

    /// The motion of the part as a whole; none when it stayed or only some of it moved.
    std::optional<RigidMotion> motion_of_all() const {
        const auto old_id = old_.tree.find(old_.tree.object), new_id = new_.tree.find(new_.tree.object);
        if (!old_id || !new_id) return std::nullopt;
        const RigidMotion motion = compose(new_.tree[*new_id].frame, old_.tree[*old_id].frame.inverse());
        return motion.is_identity() ? std::nullopt : std::optional(motion);
    }

    void follow_motion(const RigidMotion& motion) {
        for (const FaceChange& change : faces_in_place(old_.brep, new_.brep, motion))
            if (change.old_face.is_valid()) in_place_[change.old_face.index()] = change;
    }

    /// Solids that moved as a whole, by the motion of some feature.
    void follow_moved_solids() {
        std::vector<char> is_left(solids_now_.size(), 0);
        for (std::size_t f = 0; f < followed_.size() && !solids_now_.empty(); ++f)
            for (const SolidId was : old_.brep.solids_beside(FaceId(f)))
                if (was.is_valid() && is_open(FaceId(f))) is_left[was.index()] = solids_now_[was.index()].is_valid();
        if (std::count(is_left.begin(), is_left.end(), 1) == 0) return;
        for (const RigidMotion& motion : motions_of_features()) {
            std::vector<FaceId> there(followed_.size());
            for (const FaceChange& change : faces_in_place(old_.brep, new_.brep, motion))
                for (const FaceId g : change.new_faces)  // of solids that overlap several may lie there
                    if (change.old_face.is_valid() && became_solid_of(change.old_face, g))
                        there[change.old_face.index()] = g;
            std::vector<char> moved = is_left;
            for (std::size_t f = 0; f < followed_.size(); ++f)
                for (const SolidId was : old_.brep.solids_beside(FaceId(f)))
                    if (was.is_valid() && !there[f].is_valid()) moved[was.index()] = 0;
            for (std::size_t f = 0; f < followed_.size(); ++f)
                for (const SolidId was : old_.brep.solids_beside(FaceId(f)))
                    if (was.is_valid() && moved[was.index()] && is_open(FaceId(f)))
                        follow(FaceId(f), {there[f]}, FollowedBy::place);
        }
    }

    std::vector<RigidMotion> motions_of_features() const {
        std::vector<RigidMotion> motions;
        for (const Feature& feature : old_.tree.features)
            if (const auto now = new_.tree.find(feature.name)) {
                const RigidMotion motion = compose(new_.tree[*now].frame, feature.frame.inverse());
                if (!motion.is_identity() && !contains(motions, motion)) motions.push_back(motion);
            }
        return motions;
    }

    void follow_place(FaceId f, BoundaryVerdict verdict) {
        const FaceChange& place = in_place_[f.index()];
        if (!is_open(f) || place.verdict != verdict) return;
        std::vector<FaceId> faces = place.new_faces;
        std::erase_if(faces, [&](FaceId g) { return is_stranger(f, g); });
        if (!faces.empty()) follow(f, faces, FollowedBy::place);
    }

    /// Is it known that the new face, though it lies where the old one was, is another one?
    bool is_stranger(FaceId f, FaceId g) const {
        if (claimed_[g.index()]) return true;
        return !is_of_other_solid_[f.index()] && is_partnered(f) && !is_.made(g).empty();
    }

    /// Is it known what the made face of the old face is now, and that the new face is on another one?
    bool is_known_elsewhere(FaceId f, FaceId g) const {
        return is_partnered(f) && !is_.made(g).empty() && !contains(candidates_[f.index()], g);
    }

    bool is_partnered(FaceId f) const {
        return std::any_of(was_.made(f).begin(), was_.made(f).end(),
                           [&](int m) { return !partners_[std::size_t(m)].empty(); });
    }

    // By the faces around it

    /// Jaccard index of what the neighbours of the old face became and the neighbours of the new one; 0 when they have
    /// fewer than two in common.
    double likeness(FaceId f, FaceId g) const {
        const std::set<FaceId> around = neighbours(new_.brep, g);
        std::size_t common = 0, known = 0;
        std::set<FaceId> met;
        for (const FaceId h : neighbours(old_.brep, f)) {
            const std::vector<FaceId>& now = followed_[h.index()].new_faces;
            if (now.empty()) continue;
            ++known;
            bool meets = false;
            for (const FaceId n : now)
                if (around.contains(n)) met.insert(n), meets = true;
            common += meets;
        }
        if (common < 2) return 0;
        return double(common) / double(known + around.size() - met.size());
    }

    static std::set<FaceId> neighbours(const Brep& brep, FaceId f) {
        std::set<FaceId> found;
        for (const EdgeId e : brep.edges_of(f))
            for (const FaceId h : brep.faces_of(e))
                if (h != f) found.insert(h);
        return found;
    }

    /// Gives each new face that is of no old one to the one that it is most like, of several to the one that lay there.
    /// Returns whether there was one.
    bool follow_neighbours() {
        std::vector<std::vector<FaceId>> became(taken_.size());  // by new face: old ones
        for (const FollowedFace& followed : followed_)
            for (const FaceId g : followed.new_faces) became[g.index()].push_back(followed.old_face);
        std::map<FaceId, std::vector<Candidate>> given;
        for (std::size_t g = 0; g < taken_.size(); ++g) {
            if (taken_[g]) continue;
            FaceId best;
            std::pair<double, bool> most, second;
            for (const FaceId f : open_beside(FaceId(g), became)) {
                if (!may_be(f, FaceId(g))) continue;
                const double around = likeness(f, FaceId(g));
                const std::pair like(around, around > 0 && stayed_nearby(f, box_now(FaceId(g))));
                if (like > most)
                    second = most, most = like, best = f;
                else
                    second = std::max(second, like);
            }
            if (most.first > 0 && most > second) given[best].push_back({FaceId(g), most.first});
        }
        bool followed = false;
        for (const auto& [f, candidates] : given) {
            const std::vector<FaceId> faces = most_like(f, candidates);
            if (faces.empty()) continue;
            follow(f, faces, FollowedBy::neighbours);
            for (const Candidate& other : candidates) taken_[other.face.index()] = 1;
            followed = true;
        }
        return followed;
    }

    /// Old faces that are not followed, each with a neighbour that became one of the new face.
    std::set<FaceId> open_beside(FaceId g, const std::vector<std::vector<FaceId>>& became) const {
        std::set<FaceId> found;
        for (const FaceId n : neighbours(new_.brep, g))
            for (const FaceId h : became[n.index()])
                for (const FaceId f : neighbours(old_.brep, h))
                    if (is_open(f)) found.insert(f);
        return found;
    }

    struct Candidate {
        FaceId face;
        double likeness = 0;
    };
    struct Pieces {
        std::vector<FaceId> faces;
        double likeness = 0;
        Box box;
    };

    /// Pieces of one face lie on one surface. Of candidates on several those that are, together, where and as large as
    /// the old face was, then those most like it by their neighbours; none where that leaves a choice.
    std::vector<FaceId> most_like(FaceId f, const std::vector<Candidate>& candidates) const {
        std::vector<Pieces> all;
        for (const Candidate& candidate : candidates) {
            auto at = std::find_if(all.begin(), all.end(),
                                   [&](const Pieces& p) { return on_one_surface(p.faces.front(), candidate.face); });
            if (at == all.end()) at = all.insert(at, Pieces{});
            at->faces.push_back(candidate.face);
            at->likeness = std::max(at->likeness, candidate.likeness);
            at->box.add(box_now(candidate.face));
        }
        const auto rank = [&](const Pieces& p) { return std::pair(stayed_nearby(f, p.box), p.likeness); };
        const auto best = std::max_element(all.begin(), all.end(),
                                           [&](const Pieces& a, const Pieces& b) { return rank(a) < rank(b); });
        const bool is_choice = std::any_of(all.begin(), all.end(),
                                           [&](const Pieces& p) { return &p != &*best && rank(p) == rank(*best); });
        return is_choice ? std::vector<FaceId>{} : best->faces;
    }

    bool on_one_surface(FaceId a, FaceId b) const {
        Box box = box_now(a);
        box.add(box_now(b));
        return same_underlying(underlying_of(new_.brep.face(a)), underlying_of(new_.brep.face(b)),
                               {boolean_tolerance, box.center(), 0.5 * box.diagonal()});
    }

    /// With the motion of the part.
    const Box& box_before(FaceId f) const {
        std::optional<Box>& box = old_boxes_[f.index()];
        if (!box) box = box_after(old_.brep.face(f), motion_.value_or(RigidMotion{}));
        return *box;
    }
    const Box& box_now(FaceId g) const {
        std::optional<Box>& box = new_boxes_[g.index()];
        if (!box) box = box_of(new_.brep.face(g));
        return *box;
    }

    /// Is the box where and as large as that of the old face, nearly?
    bool stayed_nearby(FaceId f, const Box& is) const {
        const Box& was = box_before(f);
        const double size = was.diagonal();
        return length(was.center() - is.center()) <= nearby * size && std::abs(is.diagonal() - size) <= nearby * size;
    }

    /// Can both come from one feature, as far as their own volumes tell, with a surface of the same kind? Of what no
    /// feature made, places and sizes must do.
    bool may_be(FaceId f, FaceId g) const {
        const UnderlyingSurface was = underlying_of(old_.brep.face(f)), is = underlying_of(new_.brep.face(g));
        if (was.kind != is.kind || is_known_elsewhere(f, g)) return false;
        const std::set<Origin> olds = features_of(was_, f), news = features_of(is_, g);
        if (olds.empty() && is_made(new_.tree, news)) return false;  // by what is no volume, as the tool of a slice
        if (!olds.empty() && !news.empty() &&
            std::none_of(olds.begin(), olds.end(), [&](const Origin& origin) { return news.contains(origin); }))
            return false;
        return is_made(old_.tree, olds) || is_made(new_.tree, news) || is_as_wide(was, is) ||
               box_before(f).overlaps(box_now(g));
    }

    /// By a feature's own volume; that of an import is all of the part.
    static bool is_made(const FeatureTree& tree, const std::set<Origin>& origins) {
        return std::any_of(origins.begin(), origins.end(),
                           [&](const Origin& origin) { return !tree.is_import(*tree.find(origin.front().feature)); });
    }

    /// By the names that the elements of arrays have now.
    std::set<Origin> features_of(const MadeFaces& made, FaceId f) const {
        std::set<Origin> origins;
        for (const int m : made.made(f))
            origins.insert(origin_of(made, made.pieces()[std::size_t(made.faces()[std::size_t(m)].piece)]));
        return origins;
    }

    Origin origin_of(const MadeFaces& made, const MadePiece& piece) const {
        const Feature& feature = made.state().tree[piece.feature];
        Origin origin = piece.copied_from;
        if (&made == &was_)
            for (VolumeName& name : origin) name = elements_.now(name);
        origin.insert(origin.begin(), {feature.name, feature.volume_source == "instances" ? piece.instance : -1});
        return origin;
    }

    const PartState& old_;
    const PartState& new_;
    const MadeFaces& was_;
    const MadeFaces& is_;
    const std::vector<std::vector<int>> partners_;
    MadePieces pieces_;
    const ArrayElements elements_;
    std::optional<RigidMotion> motion_;
    std::vector<FollowedFace> followed_;
    std::vector<FaceChange> in_place_;
    std::vector<char> taken_;                                        // by new FaceId: is it one of an old face?
    std::vector<char> claimed_;                                      // and is that more than its place?
    mutable std::vector<std::optional<Box>> old_boxes_, new_boxes_;  // by FaceId, when first asked for
    std::vector<SolidId> solids_now_;              // by old SolidId: what it became; empty where there is only one
    std::vector<char> is_of_other_solid_;          // by old FaceId: what its made faces became is
    std::vector<std::vector<FaceId>> candidates_;  // by old FaceId: by what made the face
};
}  // namespace

std::string to_string(FollowedBy by) {
    switch (by) {
        case FollowedBy::nothing:
            return "";
        case FollowedBy::origin:
            return "origin";
        case FollowedBy::place:
            return "place";
        case FollowedBy::neighbours:
            return "neighbours";
    }
    return "";
}

std::vector<FollowedFace> follow_faces(const PartState& old_state, const SketchElements& old_elements,
                                       const PartState& new_state, const SketchElements& new_elements) {
    const MadeFaces was(old_state, old_elements), is(new_state, new_elements);
    return FaceFollower(was, is).run();
}

}  // namespace featuremesh

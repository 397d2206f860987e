// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/boundary_match.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "core/sort_once.h"

namespace featuremesh {

double period_of(const UnderlyingCurve& curve) {
    const bool closed = curve.kind == CurveKind::circle || curve.kind == CurveKind::ellipse;
    return closed ? 2 * std::numbers::pi : 0.0;
}

double parameter_tolerance(const UnderlyingCurve& curve, double length) {
    if (curve.kind == CurveKind::line) return length;
    if (curve.kind == CurveKind::free_form) return 1e-9 * (1 + std::abs(curve.last) + std::abs(curve.first));
    return length / (curve.kind == CurveKind::ellipse ? curve.second : curve.radius);
}

std::vector<Stretch> within_period(const Stretch& stretch, const UnderlyingCurve& curve, double length) {
    const double period = period_of(curve);
    if (period == 0 || stretch.last <= period + parameter_tolerance(curve, length)) return {stretch};
    Stretch rest = stretch, begin = stretch;
    rest.first = 0, rest.last = stretch.last - period, begin.last = period;
    return {rest, begin};
}

Box moved(const Box& box, const RigidMotion& motion) {
    Box result;
    for (int corner = 0; corner < 8; ++corner)
        result.add(motion.apply({corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                                 corner & 4 ? box.high.z : box.low.z}));
    return result;
}

namespace {
/// Something of the old (moved) or the new state with the key by which its equals are found.
struct Keyed {
    double key;
    bool is_new;
    std::size_t index;
    bool operator<(const Keyed& b) const { return std::tie(key, is_new, index) < std::tie(b.key, b.is_new, b.index); }
};

/// Groups of equal items: each item is compared with the first of every group whose key is near.
template <class Same>
std::vector<int> group_equals(std::vector<Keyed>& items, double window, int& count, const Same& same) {
    std::sort(items.begin(), items.end());
    std::vector<int> group(items.size(), -1);
    std::vector<std::size_t> first_of;
    for (std::size_t i = 0; i < items.size(); ++i) {
        int last_tried = -1;
        for (std::size_t j = i; j-- > 0 && items[i].key - items[j].key <= window && group[i] < 0;) {
            if (group[j] == last_tried) continue;
            last_tried = group[j];
            if (same(items[first_of[std::size_t(group[j])]], items[i])) group[i] = group[j];
        }
        if (group[i] >= 0) continue;
        group[i] = count++;
        first_of.push_back(i);
    }
    return group;
}

class Matcher {
  public:
    explicit Matcher(const BoundaryPair& pair)
        : pair_(pair), motion_(to_trsf(pair.motion)), window_(20 * pair.sameness.length) {
        // Not at a point of symmetry: different underlying surfaces shall have different keys.
        const double reach = pair.sameness.reach;
        reference_ = pair.sameness.centre + Vec3{0.3137 * reach, 0.2281 * reach, 0.1739 * reach};
    }

    BoundaryMatch run() {
        match_vertices();
        group_curves();
        group_faces();
        for (SurfaceGroup& group : match_.groups) {
            if (!group.in_domain) continue;
            find_changed_pieces(group);
            find_changed_points(group);
        }
        return std::move(match_);
    }

  private:
    double tolerance() const { return pair_.sameness.length; }

    bool in_domain(const Box& box, bool is_new) const {
        if (!pair_.domain) return true;
        return pair_.domain->overlaps(is_new ? box.grown(tolerance()) : moved(box, pair_.motion).grown(tolerance()));
    }

    void match_vertices() {
        const Brep& old_brep = pair_.old_model.brep();
        const Brep& new_brep = pair_.new_model.brep();
        match_.new_vertex_of.assign(old_brep.vertex_count(), VertexId());
        std::vector<Keyed> candidates;
        for (std::size_t v = 0; v < new_brep.vertex_count(); ++v)
            candidates.push_back({distance(new_brep.point_of(VertexId(v)), reference_), true, v});
        std::sort(candidates.begin(), candidates.end());
        for (std::size_t v = 0; v < old_brep.vertex_count(); ++v) {
            const Vec3 p = pair_.motion.apply(old_brep.point_of(VertexId(v)));
            const double key = distance(p, reference_);
            auto c = std::lower_bound(candidates.begin(), candidates.end(), Keyed{key - window_, false, 0});
            double best = tolerance();
            for (; c != candidates.end() && c->key <= key + window_; ++c) {
                const double d = distance(new_brep.point_of(VertexId(c->index)), p);
                if (d <= best) best = d, match_.new_vertex_of[v] = VertexId(c->index);
            }
        }
    }

    void group_curves() {
        const auto& old_edges = pair_.old_model.edges();
        const auto& new_edges = pair_.new_model.edges();
        old_curves_.resize(old_edges.size());
        std::vector<Keyed> items;
        for (std::size_t e = 0; e < old_edges.size(); ++e) {
            if (old_edges[e].is_degenerated) continue;
            old_curves_[e] = moved(old_edges[e].curve, motion_);
            items.push_back({sort_key(old_curves_[e], reference_), false, e});
        }
        for (std::size_t e = 0; e < new_edges.size(); ++e)
            if (!new_edges[e].is_degenerated) items.push_back({sort_key(new_edges[e].curve, reference_), true, e});
        int count = 0;
        const std::vector<int> group = group_equals(items, window_, count, [&](const Keyed& a, const Keyed& b) {
            return same_underlying(curve_of(a), curve_of(b), pair_.sameness);
        });
        match_.curves.resize(std::size_t(count));
        match_.old_edges.resize(old_edges.size());
        match_.new_edges.resize(new_edges.size());
        std::vector<char> has_curve(std::size_t(count), 0);
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (!std::exchange(has_curve[std::size_t(group[i])], 1))
                match_.curves[std::size_t(group[i])] = curve_of(items[i]);
            stretch_of(items[i]) = stretch(items[i], group[i]);
        }
        join_equal_paths(items, group);
    }

    const UnderlyingCurve& curve_of(const Keyed& item) const {
        return item.is_new ? pair_.new_model.edges()[item.index].curve : old_curves_[item.index];
    }
    Stretch& stretch_of(const Keyed& item) {
        return item.is_new ? match_.new_edges[item.index] : match_.old_edges[item.index];
    }

    Stretch stretch(const Keyed& item, int curve) const {
        const UnderlyingCurve& own = curve_of(item);
        const UnderlyingCurve& shared = match_.curves[std::size_t(curve)];
        if (own.kind == CurveKind::free_form) return {curve, own.first, own.last, true};
        Stretch s{curve, 0, 0, same_direction(shared, own)};
        const Vec3 start = point_at(own, s.along ? own.first : own.last);
        s.first = parameter_of(shared, start);
        s.last = s.first + (own.last - own.first);
        if (const double period = period_of(shared); period > 0) {
            double first = std::fmod(s.first, period);
            if (first < 0) first += period;
            if (period - first <= tolerance() / shared.radius) first = 0;
            s.last += first - s.first;
            s.first = first;
        }
        return s;
    }

    // The kernel may approximate the same intersection curve anew, with other poles. Several edges may lie on it.
    void join_equal_paths(const std::vector<Keyed>& items, const std::vector<int>& group) {
        std::vector<std::array<char, 2>> is_in(match_.curves.size());  // old, new
        for (std::size_t i = 0; i < items.size(); ++i) is_in[std::size_t(group[i])][items[i].is_new] = 1;
        std::vector<Keyed> lonely;
        for (std::size_t i = 0; i < items.size(); ++i) {
            const UnderlyingCurve& curve = curve_of(items[i]);
            const auto [is_old, is_new] = is_in[std::size_t(group[i])];
            if (curve.kind != CurveKind::free_form || (is_old && is_new)) continue;
            const double key =
                distance(point_at(curve, curve.first), reference_) + distance(point_at(curve, curve.last), reference_);
            lonely.push_back({key, items[i].is_new, items[i].index});
        }
        int count = 0;
        const std::vector<int> path = group_equals(lonely, 100 * window_, count, [&](const Keyed& a, const Keyed& b) {
            return same_path(curve_of(a), curve_of(b), pair_.sameness);
        });
        std::vector<int> first(std::size_t(count), -1);
        for (std::size_t i = 0; i < lonely.size(); ++i) {
            int& leader = first[std::size_t(path[i])];
            if (leader < 0) {
                leader = int(i);
                continue;
            }
            const UnderlyingCurve& shared = curve_of(lonely[std::size_t(leader)]);
            const UnderlyingCurve& own = curve_of(lonely[i]);
            const Vec3 start = point_at(own, own.first);
            Stretch joined = stretch_of(lonely[std::size_t(leader)]);
            joined.along =
                distance(start, point_at(shared, shared.first)) <= distance(start, point_at(shared, shared.last));
            stretch_of(lonely[i]) = joined;
        }
    }

    void group_faces() {
        const auto& old_faces = pair_.old_model.faces();
        const auto& new_faces = pair_.new_model.faces();
        old_surfaces_.resize(old_faces.size());
        std::vector<Keyed> items;
        for (std::size_t f = 0; f < old_faces.size(); ++f) {
            old_surfaces_[f] = moved(old_faces[f].underlying, motion_);
            items.push_back({sort_key(old_surfaces_[f], reference_), false, f});
        }
        for (std::size_t f = 0; f < new_faces.size(); ++f)
            items.push_back({sort_key(new_faces[f].underlying, reference_), true, f});
        int count = 0;
        const std::vector<int> group = group_equals(items, window_, count, [&](const Keyed& a, const Keyed& b) {
            return same_underlying(surface_of(a), surface_of(b), pair_.sameness) &&
                   material_of(a, a) == material_of(b, a);
        });
        match_.groups.resize(std::size_t(count));
        std::vector<const Keyed*> leader(std::size_t(count), nullptr);
        match_.group_of_old_face.assign(old_faces.size(), -1);
        match_.group_of_new_face.assign(new_faces.size(), -1);
        match_.old_normal_as_group.assign(old_faces.size(), 0);
        match_.new_normal_as_group.assign(new_faces.size(), 0);
        for (std::size_t i = 0; i < items.size(); ++i) {
            SurfaceGroup& g = match_.groups[std::size_t(group[i])];
            if (!leader[std::size_t(group[i])]) leader[std::size_t(group[i])] = &items[i];
            (items[i].is_new ? match_.new_normal_as_group : match_.old_normal_as_group)[items[i].index] =
                normal_as_leader(items[i], *leader[std::size_t(group[i])]);
            (items[i].is_new ? match_.group_of_new_face : match_.group_of_old_face)[items[i].index] = group[i];
            (items[i].is_new ? g.new_faces : g.old_faces).push_back(FaceId(items[i].index));
            g.in_domain = g.in_domain || in_domain(face_of(items[i]).box, items[i].is_new);
        }
        for (SurfaceGroup& g : match_.groups) {
            std::sort(g.old_faces.begin(), g.old_faces.end());
            std::sort(g.new_faces.begin(), g.new_faces.end());
        }
    }

    const BoundaryFace& face_of(const Keyed& item) const {
        return (item.is_new ? pair_.new_model : pair_.old_model).faces()[item.index];
    }
    const UnderlyingSurface& surface_of(const Keyed& item) const {
        return item.is_new ? pair_.new_model.faces()[item.index].underlying : old_surfaces_[item.index];
    }

    bool normal_as_leader(const Keyed& item, const Keyed& leader) const {
        return same_sense(surface_of(item), surface_of(leader)) == face_of(item).normal_is_outward;
    }

    // Material before and behind the face, as the leader counts outward.
    std::array<bool, 2> material_of(const Keyed& item, const Keyed& leader) const {
        const BoundaryFace& face = face_of(item);
        return normal_as_leader(item, leader) ? std::array{face.material_before, face.material_behind}
                                              : std::array{face.material_behind, face.material_before};
    }

    /// Where the face lies that a stretch borders on: 1 left, 2 right, 4 around it, where it is drawn into the face.
    struct Cover {
        int curve;
        double first, last;
        int old_mask, new_mask;
    };

    void add_covers(FaceId id, bool is_new, std::vector<Cover>& covers) const {
        const BoundaryFace& face = (is_new ? pair_.new_model : pair_.old_model).faces()[id.index()];
        const bool as_group = (is_new ? match_.new_normal_as_group : match_.old_normal_as_group)[id.index()] != 0;
        for (const EdgeUse& use : face.uses) {
            const Stretch& s = (is_new ? match_.new_edges : match_.old_edges)[use.edge.index()];
            if (s.curve < 0) continue;
            const bool left = (use.forward == s.along) == as_group;
            const int mask = use.is_internal ? 4 : left ? 1 : 2;
            for (const Stretch& part : within_period(s, match_.curves[std::size_t(s.curve)], tolerance()))
                covers.push_back({s.curve, part.first, part.last, is_new ? 0 : mask, is_new ? mask : 0});
        }
    }

    double parameter_tolerance(int curve) const {
        return featuremesh::parameter_tolerance(match_.curves[std::size_t(curve)], tolerance());
    }

    void find_changed_pieces(SurfaceGroup& group) {
        std::vector<Cover> covers;
        for (const FaceId f : group.old_faces) add_covers(f, false, covers);
        for (const FaceId f : group.new_faces) add_covers(f, true, covers);
        std::stable_sort(covers.begin(), covers.end(),
                         [](const Cover& a, const Cover& b) { return a.curve < b.curve; });
        for (std::size_t begin = 0, end; begin < covers.size(); begin = end) {
            for (end = begin; end < covers.size() && covers[end].curve == covers[begin].curve;) ++end;
            sweep({covers.data() + begin, end - begin}, group.pieces);
        }
    }

    static bool is_left_or_right(int mask) { return ((mask & 1) != 0) != ((mask & 2) != 0); }

    void sweep(std::span<const Cover> covers, std::vector<ChangedPiece>& pieces) const {
        const int curve = covers[0].curve;
        const double snap = parameter_tolerance(curve);
        std::vector<double> cuts;
        for (const Cover& c : covers) cuts.push_back(c.first), cuts.push_back(c.last);
        std::sort(cuts.begin(), cuts.end());
        bool joins_last = false;
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if (cuts[i + 1] - cuts[i] <= snap) continue;
            const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
            int old_mask = 0, new_mask = 0;
            for (const Cover& c : covers)
                if (c.first <= middle && middle <= c.last) old_mask |= c.old_mask, new_mask |= c.new_mask;
            const bool changed = old_mask != new_mask;
            const bool is_border = is_left_or_right(old_mask) != is_left_or_right(new_mask);
            if (changed && joins_last && pieces.back().is_border == is_border)
                pieces.back().last = cuts[i + 1];
            else if (changed)
                pieces.push_back({curve, cuts[i], cuts[i + 1], is_border});
            joins_last = changed;
        }
    }

    void find_changed_points(SurfaceGroup& group) const {
        const std::vector<VertexId> old_ends = vertices_of(group.old_faces, pair_.old_model);
        std::vector<VertexId> new_ends = vertices_of(group.new_faces, pair_.new_model);
        std::vector<VertexId> matched;
        for (const VertexId v : old_ends) {
            const VertexId partner = match_.new_vertex_of[v.index()];
            const bool found = partner.is_valid() && std::binary_search(new_ends.begin(), new_ends.end(), partner);
            if (found)
                matched.push_back(partner);
            else
                group.points.push_back(pair_.motion.apply(pair_.old_model.brep().point_of(v)));
        }
        std::sort(matched.begin(), matched.end());
        for (const VertexId v : new_ends)
            if (!std::binary_search(matched.begin(), matched.end(), v))
                group.points.push_back(pair_.new_model.brep().point_of(v));
    }

    static std::vector<VertexId> vertices_of(const std::vector<FaceId>& faces, const BoundaryModel& model) {
        std::vector<VertexId> result;
        for (const FaceId f : faces) {
            const auto inside = model.brep().vertices_inside(f);
            result.insert(result.end(), inside.begin(), inside.end());
            for (const EdgeId e : model.brep().edges_of(f))
                for (const VertexId v : model.brep().ends_of(e))
                    if (v.is_valid()) result.push_back(v);
        }
        sort_once(result);
        return result;
    }

    const BoundaryPair& pair_;
    gp_Trsf motion_;
    double window_;
    Vec3 reference_;
    BoundaryMatch match_;
    std::vector<UnderlyingCurve> old_curves_;
    std::vector<UnderlyingSurface> old_surfaces_;
};
}  // namespace

BoundaryMatch match_boundaries(const BoundaryPair& pair) { return Matcher(pair).run(); }

}  // namespace featuremesh

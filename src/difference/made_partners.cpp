// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/made_partners.h"

#include <algorithm>
#include <map>
#include <optional>

#include "brep/occt_geometry.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "difference/array_elements.h"
#include "difference/feature_motion.h"
#include "difference/underlying_geometry.h"
#include "features/feature_tree.h"

namespace featuremesh {

namespace {
constexpr double same_direction_cosine = 0.8;

bool have_one_in_common(const std::vector<ElementName>& a, const std::vector<ElementName>& b) {
    return std::any_of(a.begin(), a.end(),
                       [&](const ElementName& x) { return std::binary_search(b.begin(), b.end(), x); });
}

class PieceMatcher {
  public:
    PieceMatcher(const MadeFaces& was, const MadeFaces& is)
        : was_(was), is_(is), elements_(was.state().tree, is.state().tree), partners_(was.faces().size()) {}

    std::vector<std::vector<int>> run() {
        const FeatureTree &old_tree = was_.state().tree, &new_tree = is_.state().tree;
        for (std::size_t f = 0; f < old_tree.features.size(); ++f) {
            const auto n = new_tree.find(old_tree.features[f].name);
            if (n && makes_faces_in_order(old_tree.features[f]) && !new_tree[*n].suppressed)
                match_feature(FeatureId(f), *n);
        }
        return std::move(partners_);
    }

  private:
    /// Fillets and chamfers need not: what they make depends on which edges are there.
    static bool makes_faces_in_order(const Feature& feature) {
        return feature.role != Role::dress_up || feature.type.ends_with("Thickness") || feature.type.ends_with("Draft");
    }

    const MadePiece& old_piece(int p) const { return was_.pieces()[std::size_t(p)]; }
    const MadePiece& new_piece(int p) const { return is_.pieces()[std::size_t(p)]; }
    const MadeFace& old_face(int f) const { return was_.faces()[std::size_t(f)]; }
    const MadeFace& new_face(int f) const { return is_.faces()[std::size_t(f)]; }

    /// Which volume of its feature. Those that are copied have other numbers as soon as there is another one among
    /// them, and those of a pattern where its instances are not told apart.
    static std::vector<VolumeName> volume_of(const MadeFaces& made, const MadePiece& piece) {
        if (!piece.copied_from.empty()) return piece.copied_from;
        const bool is_instance = made.state().tree[piece.feature].volume_source == "instances";
        return {VolumeName{is_instance ? "instances" : "", piece.instance}};
    }

    std::vector<VolumeName> volume_now(const MadePiece& old) const {
        const FeatureTree& tree = was_.state().tree;
        std::vector<VolumeName> names = volume_of(was_, old);
        if (names.front().feature.empty())
            names.front().instance = elements_.now({tree[old.feature].name, old.instance}).instance;
        for (VolumeName& name : names) name = elements_.now(name);
        return names;
    }

    void match_feature(FeatureId old_id, FeatureId new_id) {
        const RigidMotion motion = motion_of_feature(old_id, new_id);
        std::map<std::vector<VolumeName>, std::vector<int>> olds, news;
        for (const int p : was_.pieces_of(old_id)) olds[volume_now(old_piece(p))].push_back(p);
        for (const int p : is_.pieces_of(new_id)) news[volume_of(is_, new_piece(p))].push_back(p);
        for (const auto& [instance, pieces] : olds)
            if (const auto found = news.find(instance); found != news.end())
                match_instance(pieces, found->second, motion);
    }

    void match_instance(const std::vector<int>& olds, const std::vector<int>& news, const RigidMotion& motion) {
        const auto swept = [](const auto& piece) { return !piece.elements.empty(); };
        const bool by_elements = std::all_of(olds.begin(), olds.end(), [&](int p) { return swept(old_piece(p)); }) &&
                                 std::all_of(news.begin(), news.end(), [&](int p) { return swept(new_piece(p)); });
        if (by_elements) {
            for (const int o : olds)
                for (const int n : news)
                    if (have_one_in_common(old_piece(o).elements, new_piece(n).elements)) match_swept(o, n, motion);
            return;
        }
        const RigidMotion along = motion_of_volume(olds[0], news[0], motion);
        if (olds.size() == 1 && news.size() == 1) return match_in_order(olds[0], news[0], along);
        match_by_place(olds, news, along);
    }

    /// Of what moved as `motion` says: one instance of a pattern, whose others go elsewhere, or a copy, which goes with
    /// what it copies.
    RigidMotion motion_of_volume(int o, int n, const RigidMotion& motion) const {
        const MadePiece &was = old_piece(o), &is = new_piece(n);
        if (was.copied_from.empty() && was.motion == is.motion) return motion;
        RigidMotion of_source = motion;
        if (!was.copied_from.empty()) {
            const std::string& source = was.copied_from.back().feature;
            const auto old_id = was_.state().tree.find(source), new_id = is_.state().tree.find(source);
            if (!old_id || !new_id) return motion;
            of_source = motion_of_feature(*old_id, *new_id);
        }
        return compose(is.motion, compose(of_source, was.motion.inverse()));
    }

    RigidMotion motion_of_feature(FeatureId was, FeatureId is) const {
        return compose(is_.state().tree[is].frame, was_.state().tree[was].frame.inverse());
    }

    /// Without sketch elements: what is where it was, or moved with the feature.
    void match_by_place(const std::vector<int>& olds, const std::vector<int>& news, const RigidMotion& motion) {
        const std::vector<VolumeOutline> old_outlines = outlines(was_, olds), new_outlines = outlines(is_, news);
        std::vector<char> is_old_left(olds.size(), 1), is_new_left(news.size(), 1);
        std::vector<RigidMotion> motions{motion};
        if (!motion.is_identity()) motions.emplace_back();
        for (const RigidMotion& m : motions)
            for (std::size_t o = 0; o < olds.size(); ++o)
                for (std::size_t n = 0; n < news.size() && is_old_left[o]; ++n)
                    if (is_new_left[n] && is_image(old_outlines[o], new_outlines[n], m, sameness())) {
                        match_in_order(olds[o], news[n], m);
                        is_old_left[o] = is_new_left[n] = 0;
                    }
        const auto only_one = [](const std::vector<char>& left) {
            return std::count(left.begin(), left.end(), 1) == 1;
        };
        const auto place = [](const std::vector<char>& left) {
            return std::find(left.begin(), left.end(), 1) - left.begin();
        };
        if (only_one(is_old_left) && only_one(is_new_left))
            match_in_order(olds[std::size_t(place(is_old_left))], news[std::size_t(place(is_new_left))], motion);
    }

    static std::vector<VolumeOutline> outlines(const MadeFaces& made, const std::vector<int>& pieces) {
        std::vector<VolumeOutline> list;
        for (const int p : pieces) list.push_back(outline_of(made.pieces()[std::size_t(p)].solid));
        return list;
    }

    Sameness sameness() const { return sameness_of(was_.state().brep.box(), is_.state().brep.box()); }

    /// Lateral faces by their sketch elements, caps from the lowest to the highest, unless that is another order: what
    /// a pipe has behind its first bend counts as caps.
    void match_swept(int o, int n, const RigidMotion& motion) {
        std::vector<int> old_caps, new_caps;
        for (const int f : old_piece(o).faces) {
            if (old_face(f).elements.empty()) old_caps.push_back(f);
            for (const int g : new_piece(n).faces)
                if (have_one_in_common(old_face(f).elements, new_face(g).elements)) add(f, g);
        }
        for (const int g : new_piece(n).faces)
            if (new_face(g).elements.empty()) new_caps.push_back(g);
        const std::vector<char> old_alone = sort_by_height(was_, old_caps), new_alone = sort_by_height(is_, new_caps);
        if (old_caps.size() != new_caps.size() || has_another_order(old_caps, new_caps, motion, false)) return;
        for (std::size_t i = 0; i < old_caps.size(); ++i)
            if (old_alone[i] && new_alone[i]) add(old_caps[i], new_caps[i]);
    }

    /// Which of them are alone at their height? Which is which of several there the kernel's order does not tell.
    static std::vector<char> sort_by_height(const MadeFaces& made, std::vector<int>& caps) {
        const auto height = [&](int f) { return made.faces()[std::size_t(f)].height; };
        std::stable_sort(caps.begin(), caps.end(), [&](int f, int g) { return height(f) < height(g); });
        std::vector<char> alone(caps.size(), 1);
        for (std::size_t i = 1; i < caps.size(); ++i)
            if (height(caps[i]) - height(caps[i - 1]) < boolean_tolerance) alone[i] = alone[i - 1] = 0;
        return alone;
    }

    void match_in_order(int o, int n, const RigidMotion& motion) {
        const std::vector<int>&from = old_piece(o).faces, &to = new_piece(n).faces;
        if (from.size() != to.size()) return;
        for (std::size_t i = 0; i < from.size(); ++i)
            if (!points_likewise(old_face(from[i]).underlying, new_face(to[i]).underlying, motion)) return;
        const bool is_import = was_.state().tree.is_import(old_piece(o).feature);
        if (has_another_order(from, to, motion, is_import)) return;
        for (std::size_t i = 0; i < from.size(); ++i)
            if (!is_import || is_as_wide(old_face(from[i]).underlying, new_face(to[i]).underlying) ||
                box_of_old(from[i], motion).overlaps(new_face(to[i]).probe.box()))
                add(from[i], to[i]);
    }

    Box box_of_old(int f, const RigidMotion& motion) const {
        return motion.is_identity() ? old_face(f).probe.box() : box_after(old_face(f).face, motion);
    }

    /// Another file may list the same faces in another order, and so may the kernel where it split one: does one lie
    /// where another one lay?
    bool has_another_order(const std::vector<int>& from, const std::vector<int>& to, const RigidMotion& motion,
                           bool is_import) const {
        const Sameness same = sameness();
        for (std::size_t i = 0; i < from.size(); ++i) {
            const UnderlyingSurface was = moved(old_face(from[i]).underlying, to_trsf(motion));
            const Box box = box_of_old(from[i], motion);
            const auto lies_there = [&](int g) {
                return lies_where(was, box, new_face(g), same, is_import) && looks_likewise(from[i], g, motion);
            };
            if (!lies_there(to[i]) && std::any_of(to.begin(), to.end(), lies_there)) return true;
        }
        return false;
    }

    /// A hole of an import that has moved a little lies there, too.
    static bool lies_where(const UnderlyingSurface& was, const Box& box, const MadeFace& is, const Sameness& same,
                           bool is_import) {
        if (was.kind != is.underlying.kind) return false;
        if (is_import && was.kind != SurfaceKind::plane && was.kind != SurfaceKind::free_form)
            return is.probe.box().overlaps(box) && is_as_wide(was, is.underlying);
        return is.probe.box().is_close_to(box, boolean_tolerance) && same_underlying(was, is.underlying, same);
    }

    /// Out of the material: what moves by its own length has its other end there then.
    bool looks_likewise(int f, int g, const RigidMotion& motion) const {
        const std::optional<Vec3>& p = old_face(f).probe.inner_point();
        return !p ||
               dot(motion.rotate(old_face(f).probe.normal_at(*p)), new_face(g).probe.normal_at(motion.apply(*p))) >= 0;
    }

    static bool points_likewise(const UnderlyingSurface& was, const UnderlyingSurface& is, const RigidMotion& motion) {
        if (was.kind != is.kind) return false;
        if (was.kind == SurfaceKind::free_form || was.kind == SurfaceKind::sphere) return true;
        const Vec3 before = motion.rotate(to_vec3(gp_Vec(was.position.Direction())));
        return dot(before, to_vec3(gp_Vec(is.position.Direction()))) > same_direction_cosine;
    }

    void add(int from, int to) {
        std::vector<int>& list = partners_[std::size_t(from)];
        if (std::find(list.begin(), list.end(), to) == list.end()) list.push_back(to);
    }

    const MadeFaces& was_;
    const MadeFaces& is_;
    const ArrayElements elements_;
    std::vector<std::vector<int>> partners_;
};
}  // namespace

std::vector<std::vector<int>> partners_of_made_faces(const MadeFaces& was, const MadeFaces& is) {
    return PieceMatcher(was, is).run();
}

}  // namespace featuremesh

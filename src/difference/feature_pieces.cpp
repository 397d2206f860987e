// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/feature_pieces.h"

#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <optional>

#include "core/messages.h"

namespace featuremesh {

std::vector<TopoDS_Shape> pieces_of(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Shape> pieces;
    const auto take = [&](TopAbs_ShapeEnum kind, TopAbs_ShapeEnum within) {
        for (TopExp_Explorer it(shape, kind, within); it.More(); it.Next()) pieces.push_back(it.Current());
    };
    take(TopAbs_SOLID, TopAbs_SHAPE);
    if (!pieces.empty()) return pieces;
    take(TopAbs_SHELL, TopAbs_SHAPE), take(TopAbs_FACE, TopAbs_SHELL);
    if (pieces.empty()) take(TopAbs_WIRE, TopAbs_SHAPE), take(TopAbs_EDGE, TopAbs_WIRE);
    return pieces;
}

std::vector<FeaturePiece> pieces_of(const Feature& feature) {
    std::vector<FeaturePiece> pieces;
    const auto take = [&](const TopoDS_Shape& whole, Effect effect) {
        for (const TopoDS_Shape& shape : pieces_of(whole)) {
            FeaturePiece piece{shape, effect, outline_of(shape), {}};
            piece.box = piece.outline.box();
            pieces.push_back(std::move(piece));
        }
    };
    if (feature.volume_source == "copies" && !feature.after.IsNull())
        take(feature.after, feature.volumes.front().effect);  // the elements of an array
    else
        for (const FeatureVolume& volume : feature.volumes) take(volume.shape, volume.effect);
    return pieces;
}

PieceMatch match_pieces(const std::vector<FeaturePiece>& was, const std::vector<FeaturePiece>& is,
                        const RigidMotion& hint, const Sameness& sameness) {
    PieceMatch match;
    match.new_of.assign(was.size(), -1);
    match.motions.resize(was.size());
    std::vector<char> taken(is.size(), 0);
    const auto try_pair = [&](std::size_t i, std::size_t j, std::size_t& count, const auto& motion_of) {
        if (match.new_of[i] >= 0 || taken[j] || was[i].effect != is[j].effect) return;
        const std::optional<RigidMotion> motion = motion_of(was[i], is[j]);
        if (!motion) return;
        match.new_of[i] = int(j), match.motions[i] = *motion, taken[j] = 1;
        ++count;
    };
    const auto pair_up = [&](std::size_t& count, const auto& motion_of) {
        for (std::size_t i = 0; i < was.size(); ++i)
            for (std::size_t j = 0; j < is.size() && match.new_of[i] < 0; ++j) try_pair(i, j, count, motion_of);
    };
    const auto by = [&](const RigidMotion& motion) {
        return [&](const FeaturePiece& from, const FeaturePiece& to) {
            // Corners of boxes turn with them, so only a shift lets the boxes decide.
            const bool shifted = motion.rotation == RigidMotion{}.rotation;
            const bool apart = shifted && distance(motion.apply(from.box.center()), to.box.center()) > sameness.length;
            const bool fits = !apart && is_image(from.outline, to.outline, motion, sameness);
            return fits ? std::optional(motion) : std::nullopt;
        };
    };
    pair_up(match.same, by(RigidMotion{}));
    if (!hint.is_identity()) pair_up(match.moved, by(hint));
    const auto by_any = [&](const FeaturePiece& from, const FeaturePiece& to) {
        return motion_between(from.outline, to.outline, hint, sameness);
    };
    // Of equal pieces each has kept its number, as a rule.
    for (std::size_t i = 0; i < std::min(was.size(), is.size()); ++i) try_pair(i, i, match.moved, by_any);
    pair_up(match.moved, by_any);
    match.removed = was.size() - match.same - match.moved;
    match.added = is.size() - match.same - match.moved;
    return match;
}

namespace {
constexpr std::size_t most_places = 3;

/// "(105, 70, 7.5) mm"; a direction in which the piece goes through all of the part says nothing: "x 105 mm, y 70 mm".
Message place_of(const FeaturePiece& piece, const Box& part) {
    std::array<double, 3> middle;
    std::vector<Message> across;
    for (int i = 0; i < 3; ++i) {
        const double extent = part.high[i] - part.low[i];
        double low = std::max(piece.box.low[i], part.low[i]), high = std::min(piece.box.high[i], part.high[i]);
        if (low > high) low = piece.box.low[i], high = piece.box.high[i];
        const Length at{middle[std::size_t(i)] = (low + high) / 2};
        if (low <= part.low[i] + 1e-3 * extent && high >= part.high[i] - 1e-3 * extent) continue;
        across.push_back(i == 0   ? say<Code::place_along_x>(at)
                         : i == 1 ? say<Code::place_along_y>(at)
                                  : say<Code::place_along_z>(at));
    }
    return across.empty() || across.size() == 3 ? say<Code::place>(Vec3{middle[0], middle[1], middle[2]})
                                                : listed(across);
}

/// The one radius that all cylinders of a piece share; 0 when there is none.
double radius_of(const FeaturePiece& piece) {
    double radius = 0;
    for (const UnderlyingSurface& face : piece.outline.faces) {
        if (face.kind != SurfaceKind::cylinder) continue;
        if (radius != 0 && std::abs(face.radius - radius) > 1e-9 * radius) return 0;
        radius = face.radius;
    }
    return radius;
}

/// Whether all cylinders of a piece go round it, as those of a hole do; that of a fillet is hollow.
bool is_round(const FeaturePiece& piece) {
    for (TopExp_Explorer it(piece.shape, TopAbs_FACE); it.More(); it.Next()) {
        const UnderlyingSurface face = underlying_of(TopoDS::Face(it.Current()));
        const bool outward = (it.Current().Orientation() == TopAbs_FORWARD) == face.position.Direct();
        if (face.kind == SurfaceKind::cylinder && !outward) return false;
    }
    return true;
}

class PieceMessages {
  public:
    PieceMessages(const PieceMatch& match, const std::vector<FeaturePiece>& was, const std::vector<FeaturePiece>& is,
                  const Box& old_part, const Box& new_part)
        : match_(match), was_(was), is_(is), old_part_(old_part), new_part_(new_part), partner_(was.size(), -1) {
        std::vector<char> taken(is.size(), 0);
        for (const int j : match.new_of)
            if (j >= 0) taken[std::size_t(j)] = 1;
        for (std::size_t i = 0; i < was.size(); ++i)
            if (match.new_of[i] < 0)
                find_reshaped(i, taken);
            else if (!match.motions[i].is_identity())
                moved_.push_back(i);
        for (std::size_t j = 0; j < is.size(); ++j)
            if (!taken[j]) added_.push_back(j);
    }

    Message all() const {
        std::vector<Message> found;
        add<Code::pieces_moved>(found, moved_.size(), [&](std::size_t k) { return motion(moved_[k]); });
        add<Code::pieces_reshaped>(found, reshaped_.size(), [&](std::size_t k) { return reshaped(reshaped_[k]); });
        add<Code::pieces_added>(found, added_.size(), [&](std::size_t k) { return at(is_[added_[k]], new_part_); });
        add<Code::pieces_removed>(found, removed_.size(),
                                  [&](std::size_t k) { return at(was_[removed_[k]], old_part_); });
        return several(std::move(found));
    }

  private:
    /// What has no image may have been reshaped where it was: then the boxes overlap.
    void find_reshaped(std::size_t i, std::vector<char>& taken) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < is_.size(); ++j) {
            const double d = distance(was_[i].box.center(), is_[j].box.center());
            if (taken[j] || was_[i].effect != is_[j].effect || !was_[i].box.overlaps(is_[j].box) || d >= nearest)
                continue;
            partner_[i] = int(j);
            nearest = d;
        }
        if (partner_[i] < 0) return removed_.push_back(i);
        taken[std::size_t(partner_[i])] = 1;
        reshaped_.push_back(i);
    }

    /// "1 of 6 holes"; of what was one piece, and of what is new, only how many.
    Message how_many(std::size_t count, bool is_of_all) const {
        const auto& pieces = was_.empty() ? is_ : was_;
        const bool holes = std::all_of(pieces.begin(), pieces.end(), [](const FeaturePiece& piece) {
            return piece.effect == Effect::removes && radius_of(piece) > 0 && is_round(piece);
        });
        if (is_of_all && was_.size() > 1)
            return holes ? say<Code::holes_of>(count, was_.size()) : say<Code::pieces_of>(count, was_.size());
        return holes ? say<Code::holes>(count) : say<Code::pieces>(count);
    }

    static Message at(const FeaturePiece& piece, const Box& part) { return say<Code::at_place>(place_of(piece, part)); }

    /// "1 of 6 holes moved by (5, 0, 0) mm from x 10 mm, y 40 mm to x 15 mm, y 40 mm"
    template <Code code, class Place>
    void add(std::vector<Message>& found, std::size_t count, const Place& place) const {
        if (count == 0) return;
        std::vector<Message> places;
        for (std::size_t k = 0; k < std::min(count, most_places); ++k) places.push_back(place(k));
        const Message first = listed(places);
        found.push_back(say<code>(how_many(count, code != Code::pieces_added),
                                  count > most_places ? say<Code::first_of_more>(first, count - most_places) : first));
    }

    Message motion(std::size_t i) const {
        return say<Code::piece_motion>(describe(match_.motions[i]), place_of(was_[i], old_part_),
                                       place_of(is_[std::size_t(match_.new_of[i])], new_part_));
    }

    Message reshaped(std::size_t i) const {
        const FeaturePiece &from = was_[i], &to = is_[std::size_t(partner_[i])];
        const double old_radius = radius_of(from), new_radius = radius_of(to);
        if (old_radius == 0 || new_radius == 0 || std::abs(old_radius - new_radius) < 1e-9 * old_radius)
            return at(to, new_part_);
        return say<Code::at_place_with_radius>(place_of(to, new_part_), Length{old_radius}, Length{new_radius});
    }

    const PieceMatch& match_;
    const std::vector<FeaturePiece>& was_;
    const std::vector<FeaturePiece>& is_;
    const Box& old_part_;
    const Box& new_part_;
    std::vector<int> partner_;
    std::vector<std::size_t> moved_, reshaped_, removed_, added_;
};
}  // namespace

Message describe(const PieceMatch& match, const std::vector<FeaturePiece>& was, const std::vector<FeaturePiece>& is,
                 const Box& old_part, const Box& new_part) {
    return PieceMessages(match, was, is, old_part, new_part).all();
}

}  // namespace featuremesh

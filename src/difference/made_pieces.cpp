// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/made_pieces.h"

#include <BRepTools.hxx>
#include <algorithm>
#include <numbers>

#include "brep/occt_geometry.h"
#include "difference/underlying_geometry.h"

namespace featuremesh {

namespace {

/// The way of places on one made face to another.
class Carrying {
  public:
    Carrying(const MadeFace& from, const MadeFace& to, const std::array<PieceAnchor, 2>& anchors)
        : from_(from),
          to_(to),
          anchors_(anchors),
          stays_(from.underlying.kind == SurfaceKind::free_form || to.underlying.kind != from.underlying.kind) {
        if (stays_) return;
        BRepTools::UVBounds(from.face, a_[0][0], a_[0][1], a_[1][0], a_[1][1]);
        BRepTools::UVBounds(to.face, b_[0][0], b_[0][1], b_[1][0], b_[1][1]);
    }

    Vec3 operator()(const Vec3& p) const {
        if (stays_) return p;
        const std::array<double, 2> was = parameters_of(from_.underlying, p), there = parameters_of(to_.underlying, p);
        std::array<double, 2> is{};
        for (std::size_t i = 0; i < 2; ++i) is[i] = at(i, was[i], there[i]);
        return point_at(to_.underlying, is[0], is[1]);
    }

  private:
    double at(std::size_t i, double was, double there) const {
        const auto [low, high] = a_[i];
        if (goes_round(i) && was < low - 1e-9) was += 2 * std::numbers::pi;
        switch (anchors_[i]) {
            case PieceAnchor::place:
                break;
            case PieceAnchor::low_end:
                return b_[i][0] + was - low;
            case PieceAnchor::high_end:
                return b_[i][1] + was - high;
            case PieceAnchor::share:
                return b_[i][0] + (high > low ? (was - low) / (high - low) : 0.5) * (b_[i][1] - b_[i][0]);
        }
        return there;
    }

    bool goes_round(std::size_t i) const {
        const SurfaceKind kind = from_.underlying.kind;
        return kind == SurfaceKind::torus || (i == 0 && kind != SurfaceKind::plane);
    }

    const MadeFace &from_, &to_;
    std::array<PieceAnchor, 2> anchors_;
    bool stays_;
    std::array<std::array<double, 2>, 2> a_{}, b_{};  ///< bounds by parameter
};

bool is_on(const FaceProbe& probe, const Vec3& p) {
    return probe.box().grown(boolean_tolerance).contains(p) && probe.contains(p, boolean_tolerance);
}

}  // namespace

MadePieces::MadePieces(const MadeFaces& was, const MadeFaces& is) : old_(state_of(was)), new_(state_of(is)) {}

MadePieces::State MadePieces::state_of(const MadeFaces& made) {
    State state{made, std::vector<std::vector<FaceId>>(made.faces().size()), {}, {}};
    state.pieces.resize(made.state().brep.face_count());
    for (std::size_t f = 0; f < state.pieces.size(); ++f)
        for (const int m : made.made(FaceId(f))) state.on[std::size_t(m)].emplace_back(f);
    return state;
}

const MadePieces::Piece& MadePieces::piece(State& state, FaceId f) {
    std::unique_ptr<Piece>& known = state.pieces[f.index()];
    const TopoDS_Face& face = state.made.state().brep.face(f);
    if (!known) known = std::make_unique<Piece>(Piece{FaceProbe(face), points_over(face)});
    return *known;
}

const std::vector<Vec3>& MadePieces::points_on(State& state, FaceId f, int made) {
    const auto [known, is_new] = state.points_on.try_emplace({f, made});
    if (!is_new) return known->second;
    const FaceProbe& probe = state.made.faces()[std::size_t(made)].probe;
    for (const Vec3& p : piece(state, f).points)
        if (probe.contains(p, boolean_tolerance)) known->second.push_back(p);
    return known->second;
}

double MadePieces::in_common(FaceId old_piece, int old_made, FaceId new_piece, int new_made) {
    const auto [known, is_new] = anchors_.try_emplace({old_made, new_made});
    if (is_new) known->second = anchors_of(old_made, new_made);
    const Anchors& anchors = known->second;
    return std::max(share(old_, old_piece, old_made, new_, new_piece, new_made, anchors),
                    share(new_, new_piece, new_made, old_, old_piece, old_made, anchors));
}

/// Those with which most of all pieces lie on pieces, the first ones where that is equal.
MadePieces::Anchors MadePieces::anchors_of(int old_made, int new_made) {
    constexpr PieceAnchor all[] = {PieceAnchor::place, PieceAnchor::low_end, PieceAnchor::high_end, PieceAnchor::share};
    constexpr double gain = 1e-9;
    const double wanted = double(old_on(old_made).size() + new_on(new_made).size()) - gain;
    Anchors best{PieceAnchor::place, PieceAnchor::place};
    double most = -1;
    std::vector<std::vector<Vec3>> tried;
    for (const PieceAnchor first : all)
        for (const PieceAnchor second : all) {
            const Anchors anchors{first, second};
            std::vector<Vec3> to_new = carried(old_, old_made, new_, new_made, anchors);
            const auto is_as_before = [&](const std::vector<Vec3>& other) {
                return std::equal(other.begin(), other.end(), to_new.begin(), to_new.end(),
                                  [](const Vec3& a, const Vec3& b) { return distance(a, b) <= boolean_tolerance; });
            };
            if (std::any_of(tried.begin(), tried.end(), is_as_before)) continue;
            const double here =
                covered(old_, old_made, new_, new_made, to_new) +
                covered(new_, new_made, old_, old_made, carried(new_, new_made, old_, old_made, anchors));
            if (here > most + gain) most = here, best = anchors;
            if (most > wanted) return best;
            tried.push_back(std::move(to_new));
        }
    return best;
}

/// The points of all pieces, one after the other.
std::vector<Vec3> MadePieces::carried(State& from, int made, State& to, int made_there, const Anchors& anchors) {
    const Carrying carry(from.made.faces()[std::size_t(made)], to.made.faces()[std::size_t(made_there)], anchors);
    std::vector<Vec3> places;
    for (const FaceId f : from.on[std::size_t(made)])
        for (const Vec3& p : points_on(from, f, made)) places.push_back(carry(p));
    return places;
}

/// The sum, over pieces of one made face, of the share of their points that lie on pieces of the other.
double MadePieces::covered(State& from, int made, State& to, int made_there, const std::vector<Vec3>& carried) {
    const std::vector<FaceId>& there = to.on[std::size_t(made_there)];
    // The next point mostly lies on the same piece. On splines each piece that is asked takes long.
    std::size_t last = 0;
    const auto lies_on_one = [&](const Vec3& q) {
        const auto lies_on = [&](std::size_t i) { return is_on(piece(to, there[i]).probe, q); };
        if (last < there.size() && lies_on(last)) return true;
        for (std::size_t i = 0; i < there.size(); ++i)
            if (i != last && lies_on(i)) return last = i, true;
        return false;
    };
    double sum = 0;
    auto next = carried.begin();
    for (const FaceId f : from.on[std::size_t(made)]) {
        const auto count = std::ptrdiff_t(points_on(from, f, made).size());
        if (count > 0) sum += double(std::count_if(next, next + count, lies_on_one)) / double(count);
        next += count;
    }
    return sum;
}

double MadePieces::share(State& from, FaceId f, int made, State& to, FaceId g, int made_there, const Anchors& anchors) {
    const Carrying carry(from.made.faces()[std::size_t(made)], to.made.faces()[std::size_t(made_there)], anchors);
    const std::vector<Vec3>& points = points_on(from, f, made);
    const FaceProbe& target = piece(to, g).probe;
    const auto lies_on_it = [&](const Vec3& p) { return is_on(target, carry(p)); };
    return points.empty() ? 0 : double(std::count_if(points.begin(), points.end(), lies_on_it)) / double(points.size());
}

}  // namespace featuremesh

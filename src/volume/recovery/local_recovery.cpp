// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/local_recovery.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/second_order.h"

namespace featuremesh {

namespace {

using Corners = std::array<int, 3>;

Corners facet_of(const std::array<int, 4>& tet, int k) {
    return {tet[tet_faces[k][0]], tet[tet_faces[k][1]], tet[tet_faces[k][2]]};
}

bool is_odd(const Corners& c) { return ((c[0] > c[1]) + (c[0] > c[2]) + (c[1] > c[2])) % 2 == 1; }

Corners sorted(Corners c) {
    std::sort(c.begin(), c.end());
    return c;
}

/// The tets near what is missing, as a cavity of their own.
class Neighbourhood {
  public:
    Neighbourhood(const Cavity& cavity, const CavityFill& fill, double reach) : cavity_(cavity), fill_(fill) {
        choose_tets(reach);
        number_points();
        collect_facets();
    }

    bool is_small() const { return 2 * inner_count_ < static_cast<std::size_t>(fill_.triangulation.tets.size()); }

    std::optional<ConstrainedTriangulation> recover(const RunContext& context) const {
        if (!crossing_facets(sub_).empty()) return {};  // what is missing reaches through the border
        ConstrainedTriangulation local = constrained_delaunay(sub_, {}, fill_.places.missing.size(), context);
        if (local.is_given_up || !local.failed.empty()) return {};
        for (const auto& piece : local.split.pieces)
            if (facet_of_sub_[piece.facet] < 0 || is_border_[piece.facet]) return {};
        return merge(local);
    }

  private:
    const std::vector<std::array<int, 4>>& tets() const { return fill_.triangulation.tets; }

    /// Tets with a point within reach of the box of a missing facet, in lengths of that facet.
    void choose_tets(double reach) {
        std::vector<Box> boxes;
        for (const int f : fill_.places.missing) {
            Box box;
            for (const int c : cavity_.facets[f].corners) box.add(cavity_.points[c]);
            boxes.push_back(box.grown(reach * box.diagonal()));
        }
        std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.low.x < b.low.x; });
        double widest = 0;
        for (const Box& b : boxes) widest = std::max(widest, b.size().x);
        std::vector<std::uint8_t> is_near(fill_.points.size(), 0);
        for (std::size_t i = 0; i < fill_.points.size(); ++i) {
            const Vec3& p = fill_.points[i];
            auto box = std::lower_bound(boxes.begin(), boxes.end(), p.x - widest,
                                        [](const Box& b, double x) { return b.low.x < x; });
            for (; box != boxes.end() && box->low.x <= p.x && !is_near[i]; ++box) is_near[i] = box->contains(p);
        }
        is_inner_.resize(tets().size());
        for (std::size_t t = 0; t < tets().size(); ++t) {
            is_inner_[t] = std::any_of(tets()[t].begin(), tets()[t].end(), [&](int c) { return is_near[c]; });
            inner_count_ += is_inner_[t];
        }
    }

    void number_points() {
        sub_index_.assign(fill_.points.size(), -1);
        for (std::size_t t = 0; t < tets().size(); ++t)
            if (is_inner_[t])
                for (const int c : tets()[t]) sub_index_[c] = 0;
        for (std::size_t i = 0; i < fill_.points.size(); ++i) {
            if (sub_index_[i] < 0) continue;
            sub_index_[i] = static_cast<int>(sub_.points.size());
            sub_.points.push_back(fill_.points[i]);
            point_of_sub_.push_back(static_cast<int>(i));
        }
    }

    void add_facet(const Corners& corners, int facet, bool is_border) {
        sub_.facets.push_back(
            {{sub_index_[corners[0]], sub_index_[corners[1]], sub_index_[corners[2]]}, {0, is_border ? -1 : 0}});
        facet_of_sub_.push_back(facet);
        is_border_.push_back(is_border);
    }

    /// The border, normals outward, then the cavity's facets within; a facet on the border is a border.
    void collect_facets() {
        std::vector<std::uint8_t> is_taken(cavity_.facets.size(), 0);
        for (std::size_t t = 0; t < tets().size(); ++t)
            for (int k = 0; k < 4 && is_inner_[t]; ++k) {
                const int other = fill_.triangulation.neighbours[t][k];
                if (other < 0 || is_inner_[other]) continue;  // at the hull of all points nothing is beyond
                const int facet = fill_.places.facet_at[4 * t + k];
                if (facet >= 0) is_taken[facet] = 1;
                border_facets_.emplace(sorted(facet_of(tets()[t], k)), other);
                add_facet(facet_of(tets()[t], k), facet, true);
            }
        border_count_ = sub_.facets.size();
        for (std::size_t t = 0; t < tets().size(); ++t)
            for (int k = 0; k < 4 && is_inner_[t]; ++k) {
                const int facet = fill_.places.facet_at[4 * t + k];
                if (facet < 0 || is_taken[facet]) continue;
                is_taken[facet] = 1;
                add_facet(cavity_.facets[facet].corners, facet, false);
            }
        for (const int facet : fill_.places.missing) add_facet(cavity_.facets[facet].corners, facet, false);
    }

    /// Tets outside as they were, then the new ones within; points as the whole cavity's recovery has them.
    ConstrainedTriangulation merge(ConstrainedTriangulation& local) const {
        const std::span<const Facet> border(sub_.facets.data(), border_count_);
        const FacetPlaces places =
            find_facets(local.triangulation, sub_.points.size() + local.split.added.size(), border);
        const std::vector<int> inside = label_inside(local.triangulation, places);
        ConstrainedTriangulation whole;
        if (!places.missing.empty() || inside.empty()) {
            whole.failed = fill_.places.missing;
            return whole;
        }
        const int own = static_cast<int>(cavity_.points.size()), added = static_cast<int>(local.split.added.size());
        const int subs = static_cast<int>(sub_.points.size());
        const auto shifted = [&](int point) { return point < own ? point : point + added; };
        const auto from_sub = [&](int c) { return c < subs ? shifted(point_of_sub_[c]) : own + c - subs; };

        std::vector<int> outer_index(tets().size(), -1), inner_index(local.triangulation.tets.size(), -1);
        int count = 0;
        for (std::size_t t = 0; t < tets().size(); ++t)
            if (!is_inner_[t]) outer_index[t] = count++;
        for (std::size_t t = 0; t < inside.size(); ++t)
            if (inside[t] == 0) inner_index[t] = count++;
        Triangulation& all = whole.triangulation;
        all.tets.reserve(count), all.neighbours.reserve(count);
        for (std::size_t t = 0; t < tets().size(); ++t) {
            if (is_inner_[t]) continue;
            const auto& n = fill_.triangulation.neighbours[t];
            const auto& c = tets()[t];
            all.tets.push_back({shifted(c[0]), shifted(c[1]), shifted(c[2]), shifted(c[3])});
            all.neighbours.push_back({n[0] < 0 ? -1 : outer_index[n[0]], n[1] < 0 ? -1 : outer_index[n[1]],
                                      n[2] < 0 ? -1 : outer_index[n[2]], n[3] < 0 ? -1 : outer_index[n[3]]});
        }
        for (std::size_t t = 0; t < inside.size(); ++t) {
            if (inside[t] != 0) continue;
            const int index = inner_index[t];
            const auto& c = local.triangulation.tets[t];
            all.tets.push_back({from_sub(c[0]), from_sub(c[1]), from_sub(c[2]), from_sub(c[3])});
            auto& neighbours = all.neighbours.emplace_back();
            for (int k = 0; k < 4; ++k) {
                const bool is_border = places.facet_at[4 * t + k] >= 0;
                const int other = local.triangulation.neighbours[t][k];
                neighbours[k] = is_border   ? outside_at(facet_of(c, k), index, outer_index, all)
                                : other < 0 ? -1
                                            : inner_index[other];
            }
        }
        take_split(local.split, whole.split);
        return whole;
    }

    /// By local tet: 0 within the border, 1 beyond it; empty when the two meet.
    std::vector<int> label_inside(const Triangulation& local, const FacetPlaces& places) const {
        std::vector<int> state(local.tets.size(), -1), stack;
        const auto agrees = [&](int tet, int value) {
            if (state[tet] < 0) state[tet] = value, stack.push_back(tet);
            return state[tet] == value;
        };
        for (std::size_t t = 0; t < local.tets.size(); ++t)
            for (int k = 0; k < 4; ++k) {
                const int facet = places.facet_at[4 * t + k];
                if (facet < 0) continue;
                const bool is_beyond = is_odd(facet_of(local.tets[t], k)) != is_odd(sub_.facets[facet].corners);
                if (!agrees(static_cast<int>(t), is_beyond)) return {};
            }
        while (!stack.empty()) {
            const int tet = stack.back();
            stack.pop_back();
            for (int k = 0; k < 4; ++k)
                if (const int other = local.neighbours[tet][k]; places.facet_at[4 * tet + k] < 0 && other >= 0)
                    if (!agrees(other, state[tet])) return {};
        }
        return std::count(state.begin(), state.end(), -1) == 0 ? state : std::vector<int>();
    }

    /// The tet beyond a facet of the border, which learns of its new neighbour.
    int outside_at(const Corners& corners, int index, const std::vector<int>& outer_index, Triangulation& all) const {
        const Corners key = sorted({point_of_sub_[corners[0]], point_of_sub_[corners[1]], point_of_sub_[corners[2]]});
        const int tet = border_facets_.at(key);
        for (int k = 0; k < 4; ++k)
            if (sorted(facet_of(tets()[tet], k)) == key) all.neighbours[outer_index[tet]][k] = index;
        return outer_index[tet];
    }

    void take_split(const FacetSplit& local, FacetSplit& whole) const {
        const int own = static_cast<int>(cavity_.points.size()), subs = static_cast<int>(sub_.points.size());
        for (FacetSplit::Added added : local.added) {
            for (int& c : added.edge)
                if (c >= 0) c = point_of_sub_[c];
            if (added.facet >= 0) added.facet = facet_of_sub_[added.facet];
            whole.added.push_back(added);
        }
        for (FacetSplit::Piece piece : local.pieces) {
            for (int& c : piece.corners) c = c < subs ? point_of_sub_[c] : own + c - subs;
            piece.facet = facet_of_sub_[piece.facet];
            whole.pieces.push_back(piece);
        }
        std::sort(whole.pieces.begin(), whole.pieces.end(),
                  [](const auto& a, const auto& b) { return a.facet < b.facet; });
    }

    const Cavity& cavity_;
    const CavityFill& fill_;
    std::vector<std::uint8_t> is_inner_;
    std::size_t inner_count_ = 0, border_count_ = 0;
    std::vector<int> sub_index_, point_of_sub_, facet_of_sub_;
    std::vector<std::uint8_t> is_border_;
    std::map<Corners, int> border_facets_;  ///< the tet beyond
    Cavity sub_;
};

}  // namespace

std::optional<ConstrainedTriangulation> recover_locally(const Cavity& cavity, const CavityFill& fill,
                                                        const RunContext& context) {
    for (const double reach : {0.7, 1.5, 4.0}) {
        const Neighbourhood near(cavity, fill, reach);
        if (!near.is_small()) return {};
        auto recovered = near.recover(context);
        if (recovered && recovered->failed.empty()) return recovered;
    }
    return {};
}

}  // namespace featuremesh

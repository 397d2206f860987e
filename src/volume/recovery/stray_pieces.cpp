// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/stray_pieces.h"

#include <algorithm>
#include <map>
#include <span>

#include "core/geometry.h"
#include "core/sorted_pair.h"

namespace featuremesh {

namespace {

using Side = std::array<int, 2>;
using Piece = FacetSplit::Piece;

/// The sides of facets, cut at the added points.
class CutSides {
  public:
    CutSides(const Cavity& cavity, const FacetSplit& split) : cavity_(cavity), split_(split) {
        for (std::size_t i = 0; i < split.added.size(); ++i)
            if (const Side& edge = split.added[i].edge; edge[0] >= 0)
                points_on_[sorted_pair(edge[0], edge[1])].push_back(static_cast<int>(i));
        for (auto& [edge, points] : points_on_) {
            const Vec3 along = cavity.points[edge[1]] - cavity.points[edge[0]];
            std::sort(points.begin(), points.end(), [&](int p, int q) {
                return dot(along, split.added[p].point) < dot(along, split.added[q].point);
            });
        }
    }

    std::vector<Side> of(const Facet& facet) const {
        std::vector<Side> sides;
        for (int k = 0; k < 3; ++k) {
            const Side edge = sorted_pair(facet.corners[k], facet.corners[(k + 1) % 3]);
            int last = edge[0];
            if (const auto found = points_on_.find(edge); found != points_on_.end())
                for (const int p : found->second) {
                    const int corner = static_cast<int>(cavity_.points.size()) + p;
                    sides.push_back(sorted_pair(last, corner));
                    last = corner;
                }
            sides.push_back(sorted_pair(last, edge[1]));
        }
        std::sort(sides.begin(), sides.end());
        return sides;
    }

    /// Whether it is known of all added corners where they are.
    bool know(std::span<const Piece> pieces) const {
        const auto is_known = [&](int corner) {
            const int p = corner - static_cast<int>(cavity_.points.size());
            return p < 0 || split_.added[p].facet >= 0 || split_.added[p].edge[0] >= 0;
        };
        return std::all_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
            return std::all_of(piece.corners.begin(), piece.corners.end(), is_known);
        });
    }

  private:
    const Cavity& cavity_;
    const FacetSplit& split_;
    std::map<Side, std::vector<int>> points_on_;  ///< in their order along the edge
};

std::map<Side, int> count_sides(std::span<const Piece> pieces) {
    std::map<Side, int> count;
    for (const Piece& piece : pieces)
        for (int k = 0; k < 3; ++k) ++count[sorted_pair(piece.corners[k], piece.corners[(k + 1) % 3])];
    return count;
}

/// Whether the pieces left tile a facet with these sides.
bool drop_strays(std::span<const Side> own, std::vector<Piece>& pieces) {
    const auto is_own = [&](const Side& side) { return std::binary_search(own.begin(), own.end(), side); };
    while (true) {
        std::map<Side, int> count = count_sides(pieces);
        const auto is_loose = [&](const Piece& piece) {
            for (int k = 0; k < 3; ++k) {
                const Side side = sorted_pair(piece.corners[k], piece.corners[(k + 1) % 3]);
                if (count[side] == 1 && !is_own(side)) return true;
            }
            return false;
        };
        if (std::erase_if(pieces, is_loose) > 0) continue;
        return std::all_of(own.begin(), own.end(), [&](const Side& side) { return count.contains(side); }) &&
               std::all_of(count.begin(), count.end(),
                           [&](const auto& c) { return c.second == (is_own(c.first) ? 1 : 2); });
    }
}

}  // namespace

std::vector<int> drop_stray_pieces(const Cavity& cavity, FacetSplit& split) {
    const CutSides sides(cavity, split);
    std::vector<Piece> kept;
    std::vector<int> untiled;
    for (auto first = split.pieces.begin(); first != split.pieces.end();) {
        const int facet = first->facet;
        const auto last = std::find_if(first, split.pieces.end(), [&](const Piece& p) { return p.facet != facet; });
        std::vector<Piece> pieces(first, last);
        if (sides.know(pieces) && !drop_strays(sides.of(cavity.facets[facet]), pieces)) untiled.push_back(facet);
        kept.insert(kept.end(), pieces.begin(), pieces.end());
        first = last;
    }
    split.pieces = std::move(kept);
    return untiled;
}

}  // namespace featuremesh

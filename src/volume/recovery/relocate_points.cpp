// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/relocate_points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/sort_once.h"
#include "core/sorted_pair.h"
#include "volume/improvement/objective.h"
#include "volume/improvement/star_shape.h"
#include "volume/recovery/facet_split.h"
#include "volume/recovery/polygon_cut.h"
#include "volume/tets/kernel_centre.h"
#include "volume/tets/tet_complex.h"
#include "volume/tets/tet_measures.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

using Corners = std::array<int, 3>;
using Pair = std::array<int, 2>;

/// The cavity with its cut facets replaced by their pieces, added points after its own.
Cavity cut_cavity(const Cavity& cavity, const FacetSplit& split) {
    Cavity cut;
    cut.points = cavity.points;
    for (const auto& added : split.added) cut.points.push_back(added.point);
    std::vector<std::uint8_t> is_cut(cavity.facets.size(), 0);
    for (const auto& piece : split.pieces) {
        is_cut[piece.facet] = 1;
        cut.facets.push_back({piece.corners, cavity.facets[piece.facet].regions});
    }
    for (std::size_t i = 0; i < cavity.facets.size(); ++i)
        if (!is_cut[i]) cut.facets.push_back(cavity.facets[i]);
    return cut;
}

/// The hole that a point leaves in one facet: the pieces round it, and what takes their place.
struct Patch {
    int facet = -1;
    std::vector<Pair> fan;  ///< (u, v) of the pieces (point, u, v), turned as the facet is
    std::vector<Corners> filled;
};

/// The tets round a point that hang together without crossing a facet, and where the point may go among them.
struct Sector {
    std::vector<int> tets;
    std::vector<Corners> cones;  ///< over the new triangles, positive with the point in front
    Vec3 place{};
};

class Relocation {
  public:
    Relocation(const Cavity& cavity, const FacetSplit& split, CavityFill fill)
        : cavity_(cavity),
          first_(static_cast<int>(cavity.points.size())),
          last_(first_ + static_cast<int>(split.added.size())),
          first_copy_(static_cast<int>(fill.points.size())),
          points_(std::move(fill.points)),
          tets_of_(points_.size() - cavity.points.size()),
          pieces_of_(split.added.size()) {
        for (std::size_t t = 0; t < fill.regions.size(); ++t)
            if (fill.regions[t] >= 0) add_tet(fill.triangulation.tets[t], fill.regions[t]);
        for (const auto& piece : split.pieces) add_piece(piece);
    }

    /// A point that moves into a narrow space takes that space from the points around it. So the first round moves only
    /// points whose tets get fair angles, and every later one asks for less: meanwhile others have left or made room.
    bool run(const RunContext& context) {
        constexpr int most_rounds = 12;
        std::vector<int> open;
        for (int p = first_; p < last_; ++p) open.push_back(p);
        double degrees = 0.5;
        for (int round = 0; !open.empty() && round < most_rounds; ++round, degrees *= 0.1) {
            largest_flatness_ = flatness_of_angle(degrees);
            std::vector<int> left;
            for (const int p : open) {
                context.check_cancelled();
                if (!relocate(p)) left.push_back(p);
            }
            for (const int p : left) make_room(p);
            open = std::move(left);
        }
        return open.empty();
    }

    CavityFill result() {
        TetComplex complex;
        std::vector<int> regions;
        for (std::size_t t = 0; t < tets_.size(); ++t)
            if (regions_[t] >= 0) complex.tets.push_back(tets_[t]), regions.push_back(regions_[t]);
        complex.points = points_;
        connect(complex);
        CavityFill fill;
        fill.points = std::move(points_);
        fill.triangulation = {std::move(complex.tets), std::move(complex.neighbours)};
        fill.places = find_facets(fill.triangulation, fill.points.size(), cavity_.facets);
        fill.regions = std::move(regions);
        fill.relocated.emplace();
        for (int p = first_; p < static_cast<int>(fill.points.size()); ++p)
            if (p < last_ || p >= first_copy_) fill.relocated->push_back(p);
        return fill;
    }

  private:
    bool is_added(int p) const { return p >= first_ && p < last_; }

    void add_tet(const Tet& tet, int region) {
        for (const int c : tet)
            if (c >= first_) tets_of_[c - first_].push_back(static_cast<int>(tets_.size()));
        tets_.push_back(tet);
        regions_.push_back(region);
    }
    void add_piece(const FacetSplit::Piece& piece) {
        for (const int c : piece.corners)
            if (is_added(c)) pieces_of_[c - first_].push_back(piece);
    }
    void remove_piece(const Corners& corners) {
        for (const int c : corners)
            if (is_added(c))
                std::erase_if(pieces_of_[c - first_], [&](const auto& p) {
                    return std::all_of(corners.begin(), corners.end(), [&](int x) {
                        return std::find(p.corners.begin(), p.corners.end(), x) != p.corners.end();
                    });
                });
    }

    bool relocate(int point) {
        std::vector<Patch> patches = patches_of(point);
        for (Patch& patch : patches)
            if (!fill_patch(patch)) return false;
        std::vector<Sector> sectors = sectors_of(point, patches);
        for (Sector& sector : sectors)
            if (sector.tets.empty() || !place(point, sector)) return false;
        for (const Patch& patch : patches) replace_pieces(point, patch);
        for (std::size_t i = 0; i < sectors.size(); ++i) commit(point, i == 0 ? point : copy_of(point), sectors[i]);
        return true;
    }

    std::vector<Patch> patches_of(int point) const {
        std::map<int, Patch> by_facet;
        for (const auto& piece : pieces_of_[point - first_]) {
            Corners c = piece.corners;
            while (c[0] != point) std::rotate(c.begin(), c.begin() + 1, c.end());
            Patch& patch = by_facet[piece.facet];
            patch.facet = piece.facet;
            patch.fan.push_back({c[1], c[2]});
        }
        std::vector<Patch> patches;
        for (auto& [facet, patch] : by_facet) patches.push_back(std::move(patch));
        return patches;
    }

    bool fill_patch(Patch& patch) const {
        const std::vector<int> outline = outline_of(patch.fan);
        if (outline.size() < 3) return false;
        const auto& c = cavity_.facets[patch.facet].corners;
        const Vec3 normal = cross(points_[c[1]] - points_[c[0]], points_[c[2]] - points_[c[0]]);
        return cut_polygon(points_, outline, normal, patch.filled);
    }

    /// The free ends of the fan, in its order; empty when it falls apart.
    static std::vector<int> outline_of(const std::vector<Pair>& fan) {
        std::map<int, int> next;
        for (const auto& [u, v] : fan) next[u] = v;
        int start = fan.front()[0];
        for (const auto& [u, v] : fan)
            if (std::none_of(fan.begin(), fan.end(), [&](const Pair& other) { return other[1] == u; })) start = u;
        std::vector<int> outline{start};
        for (auto it = next.find(start); it != next.end() && it->second != start && outline.size() <= fan.size();
             it = next.find(it->second))
            outline.push_back(it->second);
        const bool is_closed = next.contains(outline.back());
        return outline.size() == fan.size() + (is_closed ? 0 : 1) ? outline : std::vector<int>{};
    }

    /// What meets at a point: by the ends of the triangles (point, u, v) the tets and the patch that have them.
    struct Surroundings {
        int point;
        const std::vector<Patch>& patches;
        std::map<Pair, std::vector<int>> tets;
        struct Piece {
            const Patch* patch;
            Pair turned;  ///< as the patch has the ends
        };
        std::map<Pair, Piece> pieces;
    };
    Surroundings surroundings_of(int point, const std::vector<Patch>& patches) const {
        Surroundings around{point, patches, {}, {}};
        for (const int t : tets_of_[point - first_])
            for (int i = 0; i < 4; ++i)
                for (int j = i + 1; j < 4; ++j)
                    if (tets_[t][i] != point && tets_[t][j] != point)
                        around.tets[sorted_pair(tets_[t][i], tets_[t][j])].push_back(t);
        for (const Patch& patch : patches)
            for (const Pair& uv : patch.fan) around.pieces[sorted_pair(uv[0], uv[1])] = {&patch, uv};
        return around;
    }

    std::vector<Sector> sectors_of(int point, const std::vector<Patch>& patches) const {
        const Surroundings around = surroundings_of(point, patches);
        std::set<int> taken;
        std::vector<Sector> sectors;
        for (const int tet : tets_of_[point - first_])
            if (taken.insert(tet).second) sectors.push_back(sector_from(tet, around, taken));
        return sectors;
    }

    /// Without tets where it lies on both sides of a patch, so that it cannot be told which is its own.
    Sector sector_from(int first, const Surroundings& around, std::set<int>& taken) const {
        Sector sector;
        std::map<const Patch*, bool> is_behind;
        sector.tets.push_back(first);
        bool is_plain = true;
        for (std::size_t i = 0; i < sector.tets.size(); ++i) {
            const Tet& tet = tets_[sector.tets[i]];
            for (int k = 0; k < 4; ++k) {
                if (tet[k] == around.point) continue;
                const Pair ends = ends_in(tet, k, around.point), key = sorted_pair(ends[0], ends[1]);
                if (const auto piece = around.pieces.find(key); piece != around.pieces.end()) {
                    const bool behind = piece->second.turned == ends;
                    is_plain &= is_behind.emplace(piece->second.patch, behind).first->second == behind;
                    continue;
                }
                for (const int other : around.tets.at(key))
                    if (taken.insert(other).second) sector.tets.push_back(other);
            }
        }
        if (!is_plain) sector.tets.clear();
        for (const Patch& patch : around.patches)
            if (const auto found = is_behind.find(&patch); found != is_behind.end())
                for (const Corners& c : patch.filled)
                    sector.cones.push_back(found->second ? c : Corners{c[0], c[2], c[1]});
        return sector;
    }

    /// The other two corners of a tet's triangle, in the order in which the triangle turns with the point in front.
    static Pair ends_in(const Tet& tet, int triangle, int point) {
        const auto& face = opposite_face[triangle];
        Corners corners{tet[face[0]], tet[face[1]], tet[face[2]]};
        while (corners[0] != point) std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        return {corners[1], corners[2]};
    }

    /// Looks for room along the way to the middle of the sector and along the mean of the facets' normals; in the end,
    /// when no angle can be too small, wherever there is most.
    bool place(int point, Sector& sector) const {
        StarShape shape(angles_);
        std::vector<std::array<Vec3, 3>> walls;
        Vec3 middle{}, inward{};
        double reach = 0;
        const auto add = [&](int a, int b, int c) {
            walls.push_back({points_[a], points_[b], points_[c]});
            shape.add(points_[a], points_[b], points_[c]);
        };
        for (const int t : sector.tets) {
            const Tet& v = tets_[t];
            const auto& face = opposite_face[corner_of(v, point)];
            add(v[face[0]], v[face[1]], v[face[2]]);
            for (const int k : face) middle = middle + points_[v[k]], reach += distance(points_[v[k]], points_[point]);
        }
        for (const Corners& c : sector.cones) {
            add(c[0], c[1], c[2]);
            inward = inward - normalized(cross(points_[c[1]] - points_[c[0]], points_[c[2]] - points_[c[0]]));
        }
        const double count = 3.0 * static_cast<double>(sector.tets.size());
        const Vec3 to_middle = (1 / count) * middle - points_[point];
        if (squared_length(inward) > 0) inward = (reach / count) * normalized(inward);
        double best = 1;
        for (const Vec3& way : {to_middle, inward}) {
            double step = 0.8;
            for (int i = 0; i < 40; ++i, step *= 0.6) {
                const Vec3 trial = points_[point] + step * way;
                const double value = shape.worst(trial, best);
                if (value < best) best = value, sector.place = trial;
            }
        }
        if (best >= 1) {
            if (largest_flatness_ < 1) return false;
            const std::optional<Vec3> centre = kernel_centre(walls, points_[point], reach / count);
            if (centre) sector.place = *centre;
            return centre.has_value();
        }
        static const double bearable = flatness_of_angle(5);
        if (best > bearable) best = shape.climb(sector.place, bearable);
        return best <= largest_flatness_;
    }

    void replace_pieces(int point, const Patch& patch) {
        for (const Pair& uv : patch.fan) remove_piece({point, uv[0], uv[1]});
        for (const Corners& c : patch.filled) add_piece({c, patch.facet});
    }

    /// Brings the free points round this one to better places.
    void make_room(int point) {
        std::vector<int> around;
        for (const int t : tets_of_[point - first_]) around.insert(around.end(), tets_[t].begin(), tets_[t].end());
        sort_once(around);
        static const double good_enough = flatness_of_angle(20);
        for (const int p : around) {
            if (p < first_ || (is_added(p) && !pieces_of_[p - first_].empty())) continue;
            StarShape shape(angles_);
            for (const int t : tets_of_[p - first_]) {
                const auto& face = opposite_face[corner_of(tets_[t], p)];
                shape.add(points_[tets_[t][face[0]]], points_[tets_[t][face[1]]], points_[tets_[t][face[2]]]);
            }
            shape.climb(points_[p], good_enough);
        }
    }

    int copy_of(int point) {
        tets_of_.emplace_back();
        points_.push_back(points_[point]);
        return static_cast<int>(points_.size()) - 1;
    }

    void commit(int point, int moved, const Sector& sector) {
        points_[moved] = sector.place;
        for (const int t : sector.tets) tets_[t][corner_of(tets_[t], point)] = moved;
        tets_of_[moved - first_] = sector.tets;
        for (const Corners& c : sector.cones) add_tet({moved, c[0], c[1], c[2]}, regions_[sector.tets.front()]);
    }

    const Cavity& cavity_;
    const Objective angles_;
    double largest_flatness_ = 1;  ///< of the tets round a point that is relocated
    int first_, last_;             ///< the added points
    int first_copy_;               ///< with the points after it, of added ones between several regions
    std::vector<Vec3> points_;
    std::vector<Tet> tets_;
    std::vector<int> regions_;
    std::vector<std::vector<int>> tets_of_;                  ///< by free point
    std::vector<std::vector<FacetSplit::Piece>> pieces_of_;  ///< by added point; none once it is relocated
};

}  // namespace

std::optional<CavityFill> relocate_points(const Cavity& cavity, const ConstrainedTriangulation& recovered,
                                          std::span<const Vec3> seeds, RunContext& context) {
    const Cavity cut = cut_cavity(cavity, recovered.split);
    std::vector<Vec3> points = cut.points;
    points.insert(points.end(), seeds.begin(), seeds.end());
    CavityFill fill = label_cavity(cut, std::move(points), recovered.triangulation, context);
    if (!fill.is_complete()) return {};
    Relocation relocation(cavity, recovered.split, std::move(fill));
    if (!relocation.run(context)) return {};
    CavityFill result = relocation.result();
    if (!result.is_complete()) return {};
    return result;
}

}  // namespace featuremesh

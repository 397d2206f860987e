// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "mesh/second_order.h"
#include "volume/delaunay/triangulation.h"

namespace featuremesh {

namespace {

bool is_odd(const std::array<int, 3>& c) { return ((c[0] > c[1]) + (c[0] > c[2]) + (c[1] > c[2])) % 2 == 1; }

/// The corners of the tet's side opposite corner k, normal outward.
std::array<int, 3> side_of(const std::array<int, 4>& tet, int k) {
    return {tet[tet_faces[k][0]], tet[tet_faces[k][1]], tet[tet_faces[k][2]]};
}

/// The side of the tet that its neighbour is at.
int side_towards(const Triangulation& triangulation, int tet, std::size_t neighbour) {
    const auto& sides = triangulation.neighbours[tet];
    return static_cast<int>(std::find(sides.begin(), sides.end(), static_cast<int>(neighbour)) - sides.begin());
}

/// Facets in rows by their lowest corner, for look-up without hashing.
class FacetTable {
  public:
    FacetTable(std::size_t point_count, std::span<const Facet> facets, std::span<const int> among)
        : is_corner_(point_count, 0), begin_(point_count + 1, 0) {
        for (const int i : among) {
            const Facet& f = facets[i];
            for (const int c : f.corners) is_corner_[c] = 1;
            ++begin_[*std::min_element(f.corners.begin(), f.corners.end()) + 1];
        }
        for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
        rows_.resize(among.size());
        std::vector<int> next(begin_.begin(), begin_.end() - 1);
        for (const int i : among) {
            Row row{facets[i].corners, i};
            std::sort(row.sorted.begin(), row.sorted.end());
            rows_[next[row.sorted[0]]++] = row;
        }
    }

    bool is_corner(int point) const { return is_corner_[point]; }
    int find(std::array<int, 3> corners) const {
        std::sort(corners.begin(), corners.end());
        for (int i = begin_[corners[0]]; i < begin_[corners[0] + 1]; ++i)
            if (rows_[i].sorted[1] == corners[1] && rows_[i].sorted[2] == corners[2]) return rows_[i].facet;
        return -1;
    }

  private:
    struct Row {
        std::array<int, 3> sorted;
        int facet;
    };
    std::vector<std::uint8_t> is_corner_;
    std::vector<int> begin_;
    std::vector<Row> rows_;
};

}  // namespace

void place_missing(const Triangulation& triangulation, std::size_t point_count, std::span<const Facet> facets,
                   FacetPlaces& places, const RunContext& context) {
    RoundWatch watch(context);
    const FacetTable table(point_count, facets, places.missing);
    std::vector<std::uint8_t> is_found(facets.size(), 0);
    const auto neighbour = [&](std::size_t t, int k) {
        return triangulation.neighbours.empty() ? -1 : triangulation.neighbours[t][k];
    };
    for (std::size_t t = 0; t < triangulation.tets.size(); ++t) {
        watch();
        const auto& tet = triangulation.tets[t];
        int count = 0;
        for (const int corner : tet) count += table.is_corner(corner);
        if (count < 3) continue;
        for (int k = 0; k < 4; ++k) {
            const int other = neighbour(t, k);
            if (count - table.is_corner(tet[k]) < 3 || (other >= 0 && other < static_cast<int>(t))) continue;
            const int facet = table.find(side_of(tet, k));
            if (facet < 0) continue;
            is_found[facet] = 1;
            places.facet_at[4 * t + k] = facet;
            if (other >= 0) places.facet_at[4 * other + side_towards(triangulation, other, t)] = facet;
        }
    }
    std::erase_if(places.missing, [&](int i) { return is_found[i] != 0; });
}

FacetPlaces find_facets(const Triangulation& triangulation, std::size_t point_count, std::span<const Facet> facets,
                        const RunContext& context) {
    FacetPlaces places;
    places.facet_at.assign(4 * triangulation.tets.size(), -1);
    places.missing.resize(facets.size());
    std::iota(places.missing.begin(), places.missing.end(), 0);
    place_missing(triangulation, point_count, facets, places, context);
    return places;
}

std::vector<int> label_regions(const Triangulation& triangulation, std::span<const Facet> facets,
                               const FacetPlaces& places, const RunContext& context) {
    RoundWatch watch(context);
    constexpr int unknown = -2;
    std::vector<int> regions(triangulation.tets.size(), unknown), stack;
    const auto agrees = [&](int tet, int region) {
        if (regions[tet] == unknown) regions[tet] = region, stack.push_back(tet);
        return regions[tet] == region;
    };
    for (std::size_t t = 0; t < triangulation.tets.size(); ++t) {
        watch();
        for (int k = 0; k < 4; ++k) {
            const int facet = places.facet_at[4 * t + k];
            if (facet < 0) continue;
            // A tet whose outward side turns as the facet does lies behind it.
            const bool is_before = is_odd(side_of(triangulation.tets[t], k)) != is_odd(facets[facet].corners);
            if (!agrees(static_cast<int>(t), facets[facet].regions[is_before])) return {};
        }
    }
    while (!stack.empty()) {
        watch();
        const int tet = stack.back();
        stack.pop_back();
        for (int k = 0; k < 4; ++k) {
            if (places.facet_at[4 * tet + k] >= 0) continue;
            const int other = triangulation.neighbours[tet][k];
            if (other < 0 ? regions[tet] != -1 : !agrees(other, regions[tet])) return {};
        }
    }
    std::replace(regions.begin(), regions.end(), unknown, -1);
    return regions;
}

}  // namespace featuremesh

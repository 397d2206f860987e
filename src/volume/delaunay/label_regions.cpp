// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "mesh/second_order.h"
#include "volume/delaunay/triangulation.h"

namespace featuremesh {

namespace {

constexpr std::size_t tets_per_chunk = 1 << 14;

/// The facet of the tet that its neighbour is at.
int facet_towards(const Triangulation& triangulation, int tet, std::size_t neighbour) {
    const auto& neighbours = triangulation.neighbours[tet];
    return static_cast<int>(std::find(neighbours.begin(), neighbours.end(), static_cast<int>(neighbour)) -
                            neighbours.begin());
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

/// Every chunk of tets is labelled by itself, from what its facets say and what comes in from others, round by round.
class Labelling {
  public:
    Labelling(const Triangulation& triangulation, std::span<const Facet> facets, const FacetPlaces& places,
              RunContext& context)
        : triangulation_(triangulation),
          facets_(facets),
          places_(places),
          context_(context),
          regions_(triangulation.tets.size(), unknown),
          chunks_((triangulation.tets.size() + tets_per_chunk - 1) / tets_per_chunk) {}

    /// Empty when a tet would get two regions, or a region reaches the hull.
    std::vector<int> run() {
        each_chunk([&](std::size_t chunk) { start(chunk); });
        for (bool is_at_rest = false; !is_at_rest && !is_leaky();) is_at_rest = !exchange();
        if (is_leaky()) return {};
        std::replace(regions_.begin(), regions_.end(), unknown, -1);
        return std::move(regions_);
    }

  private:
    static constexpr int unknown = -2;
    struct Reached {
        int tet, region;
    };
    struct Chunk {
        std::vector<int> stack;
        std::vector<Reached> coming, going;  ///< from other chunks, to them
        bool is_leaky = false;
    };

    template <class Work>
    void each_chunk(Work work) {
        parallel_for(context_, regions_.size(), tets_per_chunk,
                     [&](std::size_t begin, std::size_t) { work(begin / tets_per_chunk); });
    }
    static std::size_t chunk_of(int tet) { return static_cast<std::size_t>(tet) / tets_per_chunk; }

    bool is_leaky() const {
        return std::any_of(chunks_.begin(), chunks_.end(), [](const Chunk& chunk) { return chunk.is_leaky; });
    }

    void reach(Chunk& chunk, int tet, int region) {
        if (regions_[tet] == unknown) regions_[tet] = region, chunk.stack.push_back(tet);
        chunk.is_leaky |= regions_[tet] != region;
    }

    void start(std::size_t at) {
        const std::size_t begin = at * tets_per_chunk, end = std::min(begin + tets_per_chunk, regions_.size());
        for (std::size_t t = begin; t < end; ++t)
            for (int k = 0; k < 4; ++k) {
                const int facet = places_.facet_at[4 * t + k];
                if (facet < 0) continue;
                // A tet whose facet turns outward as the surface facet does lies behind it.
                const bool is_before =
                    is_odd(facet_opposite(triangulation_.tets[t], k)) != is_odd(facets_[facet].corners);
                reach(chunks_[at], static_cast<int>(t), facets_[facet].regions[is_before]);
            }
        spread(at);
    }

    void spread(std::size_t at) {
        Chunk& chunk = chunks_[at];
        while (!chunk.stack.empty() && !chunk.is_leaky) {
            const int tet = chunk.stack.back();
            chunk.stack.pop_back();
            for (int k = 0; k < 4; ++k) {
                if (places_.facet_at[4 * tet + k] >= 0) continue;
                const int other = triangulation_.neighbours[tet][k];
                if (other < 0)
                    chunk.is_leaky |= regions_[tet] != -1;
                else if (chunk_of(other) == at)
                    reach(chunk, other, regions_[tet]);
                else
                    chunk.going.push_back({other, regions_[tet]});
            }
        }
    }

    /// Whether anything came to a chunk that it did not know.
    bool exchange() {
        for (Chunk& chunk : chunks_) {
            for (const Reached& reached : chunk.going) chunks_[chunk_of(reached.tet)].coming.push_back(reached);
            chunk.going.clear();
        }
        each_chunk([&](std::size_t at) {
            for (const Reached& reached : chunks_[at].coming) reach(chunks_[at], reached.tet, reached.region);
            chunks_[at].coming.clear();
            spread(at);
        });
        return std::any_of(chunks_.begin(), chunks_.end(), [](const Chunk& chunk) { return !chunk.going.empty(); });
    }

    const Triangulation& triangulation_;
    std::span<const Facet> facets_;
    const FacetPlaces& places_;
    RunContext& context_;
    std::vector<int> regions_;
    std::vector<Chunk> chunks_;
};

}  // namespace

void place_missing(const Triangulation& triangulation, std::size_t point_count, std::span<const Facet> facets,
                   FacetPlaces& places, RunContext& context) {
    const FacetTable table(point_count, facets, places.missing);
    std::vector<std::uint8_t> is_found(facets.size(), 0);
    const auto neighbour = [&](std::size_t t, int k) {
        return triangulation.neighbours.empty() ? -1 : triangulation.neighbours[t][k];
    };
    // with neighbours each facet is looked at from one tet, so no two threads write to the same place
    const std::size_t count = triangulation.tets.size(),
                      grain = triangulation.neighbours.empty() ? count + 1 : tets_per_chunk;
    const auto place_facets_of = [&](std::size_t t) {
        const auto& tet = triangulation.tets[t];
        int corners = 0;
        for (const int corner : tet) corners += table.is_corner(corner);
        if (corners < 3) return;
        for (int k = 0; k < 4; ++k) {
            const int other = neighbour(t, k);
            if (corners - table.is_corner(tet[k]) < 3 || (other >= 0 && other < static_cast<int>(t))) continue;
            const int facet = table.find(facet_opposite(tet, k));
            if (facet < 0) continue;
            is_found[facet] = 1;
            places.facet_at[4 * t + k] = facet;
            if (other >= 0) places.facet_at[4 * other + facet_towards(triangulation, other, t)] = facet;
        }
    };
    parallel_for(context, count, grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) place_facets_of(t);
    });
    std::erase_if(places.missing, [&](int i) { return is_found[i] != 0; });
}

FacetPlaces find_facets(const Triangulation& triangulation, std::size_t point_count, std::span<const Facet> facets,
                        RunContext& context) {
    FacetPlaces places;
    places.facet_at.assign(4 * triangulation.tets.size(), -1);
    places.missing.resize(facets.size());
    std::iota(places.missing.begin(), places.missing.end(), 0);
    place_missing(triangulation, point_count, facets, places, context);
    return places;
}

FacetPlaces find_facets(const Triangulation& triangulation, std::size_t point_count, std::span<const Facet> facets) {
    RunContext alone;
    return find_facets(triangulation, point_count, facets, alone);
}

std::vector<int> label_regions(const Triangulation& triangulation, std::span<const Facet> facets,
                               const FacetPlaces& places, RunContext& context) {
    return Labelling(triangulation, facets, places, context).run();
}

}  // namespace featuremesh

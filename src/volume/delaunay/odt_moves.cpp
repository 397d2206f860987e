// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/delaunay/odt_moves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "volume/tets/cavity_editor.h"
#include "volume/tets/tet_measures.h"

namespace featuremesh {

namespace {

/// A vertex whose optimum is nearer than this share of its star's size stays.
constexpr double still_enough = 0.01;
/// Moves may not press a tet below this share of the mean volume in the star.
constexpr double smallest_volume_share = 0.05;
/// Width of a block in longest edges. A move is at most half of one, so edges never get longer than two, and what one
/// vertex looks at or queues ends less than two edges away.
constexpr double block_width = 6;
constexpr std::size_t tets_between_reports = 1 << 15;
constexpr std::size_t tets_per_chunk = 1 << 13;

/// Sums over a star: weight * 6 V * (circumcentre - vertex), weight * 6 V, and 6 V.
struct StarSum {
    Vec3 moment{};
    double weight = 0, six_volumes = 0;
    /// The way to the optimum.
    Vec3 shift() const { return weight > 0 ? moment / weight : Vec3{}; }
    bool is_still() const {
        const double reach = still_enough * std::cbrt(six_volumes);
        return squared_length(shift()) <= reach * reach;
    }
};

std::uint64_t block_of(const Vec3& p, const Vec3& low, double width) {
    std::uint64_t block = 0, colour = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto cell = static_cast<std::uint64_t>(std::min((p[axis] - low[axis]) / width, 1048575.0));
        block = block << 20 | cell;
        colour = colour << 1 | (cell & 1);
    }
    return colour << 60 | block;
}

}  // namespace

struct OdtMover::Scratch {
    std::vector<int> star;
    std::vector<std::array<Vec3, 3>> faces;
};

OdtMover::OdtMover(TetComplex& complex, const SizingField& sizing, bool is_weighted, RunContext& context)
    : complex_(complex), sizing_(sizing), context_(context), is_weighted_(is_weighted) {
    if (!is_weighted_) return;
    sizes_.resize(complex_.points.size());
    parallel_for(context_, sizes_.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) sizes_[v] = sizing_.at(complex_.points[v]);
    });
}

double OdtMover::weight(const Tet& v) const {
    if (!is_weighted_) return 1;
    const double size = (sizes_[v[0]] + sizes_[v[1]] + sizes_[v[2]] + sizes_[v[3]]) / 4;
    return 1 / (size * size * size);
}

// one pass over the tets in memory order is cheaper than a star for every vertex
void OdtMover::queue_gainers(OdtMarks& marks) const {
    const auto& p = complex_.points;
    std::vector<StarSum> sums(p.size());
    for (std::size_t t = 0; t < complex_.tets.size(); ++t) {
        if (t % tets_between_reports == 0) context_.progress(0);
        const Tet& v = complex_.tets[t];
        if (v[0] < 0) continue;
        const Circumsphere sphere(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
        const double share = weight(v), weighted = share * sphere.six_volumes;
        for (int corner : v) {
            sums[corner].moment += (share / 2) * sphere.scaled + weighted * (p[v[0]] - p[corner]);
            sums[corner].weight += weighted;
            sums[corner].six_volumes += sphere.six_volumes;
        }
    }
    for (std::size_t v = 0; v < sums.size(); ++v)
        marks.queued[v] = complex_.is_free(static_cast<int>(v)) && !sums[v].is_still();
}

std::size_t OdtMover::sweep(OdtMarks& marks, double share, double part) {
    const double longest = longest_edge(marks);
    if (!(longest > 0)) return 0;
    const std::vector<Place> places = places_of_queued(marks, block_width * longest);
    std::vector<std::size_t> first;  // of each block
    for (std::size_t i = 0; i < places.size(); ++i)
        if (i == 0 || places[i].block != places[i - 1].block) first.push_back(i);
    first.push_back(places.size());
    std::vector<std::size_t> moved(first.size(), 0);
    for (std::size_t begin = 0, end = 0; begin + 1 < first.size(); begin = end) {
        const auto colour = places[first[begin]].block >> 60;
        while (end + 1 < first.size() && places[first[end]].block >> 60 == colour) ++end;
        context_.progress(share + part * static_cast<double>(first[begin]) / static_cast<double>(places.size()));
        parallel_for(context_, end - begin, 1, [&](std::size_t from, std::size_t to) {
            Scratch scratch;
            for (std::size_t block = begin + from; block < begin + to; ++block)
                for (std::size_t i = first[block]; i < first[block + 1]; ++i)
                    moved[block] += move(places[i].vertex, longest / 2, marks, scratch);
        });
    }
    std::size_t sum = 0;
    for (std::size_t count : moved) sum += count;
    return sum;
}

/// Of the tets with a queued vertex.
double OdtMover::longest_edge(const OdtMarks& marks) const {
    const auto& p = complex_.points;
    std::vector<double> longest(complex_.tets.size() / tets_per_chunk + 1, 0);
    parallel_for(context_, complex_.tets.size(), tets_per_chunk, [&](std::size_t begin, std::size_t end) {
        double& squared = longest[begin / tets_per_chunk];
        for (std::size_t t = begin; t < end; ++t) {
            const Tet& v = complex_.tets[t];
            if (v[0] < 0 || !(marks.queued[v[0]] | marks.queued[v[1]] | marks.queued[v[2]] | marks.queued[v[3]]))
                continue;
            for (const auto& [i, j] : edge_corners) squared = std::max(squared, squared_length(p[v[i]] - p[v[j]]));
        }
    });
    return std::sqrt(*std::max_element(longest.begin(), longest.end()));
}

std::vector<OdtMover::Place> OdtMover::places_of_queued(const OdtMarks& marks, double width) const {
    Box box;
    for (const Vec3& p : complex_.points) box.add(p);
    std::vector<Place> places;
    for (std::size_t v = 0; v < marks.queued.size(); ++v)
        if (marks.queued[v]) places.push_back({block_of(complex_.points[v], box.low, width), static_cast<int>(v)});
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
        return a.block != b.block ? a.block < b.block : a.vertex < b.vertex;
    });
    return places;
}

bool OdtMover::move(int vertex, double longest_shift, OdtMarks& marks, Scratch& scratch) {
    marks.queued[vertex] = 0;
    if (!gather_star(complex_, vertex, scratch.star)) return false;
    StarSum sum;
    scratch.faces.clear();
    for (int tet : scratch.star) {
        const Tet& v = complex_.tets[tet];
        const auto& face = opposite_face[corner_of(v, vertex)];
        const auto& f = scratch.faces.emplace_back(
            std::array{complex_.points[v[face[0]]], complex_.points[v[face[1]]], complex_.points[v[face[2]]]});
        const Circumsphere sphere(complex_.points[vertex], f[0], f[1], f[2]);
        const double share = weight(v);
        sum.moment += (share / 2) * sphere.scaled;
        sum.weight += share * sphere.six_volumes;
        sum.six_volumes += sphere.six_volumes;
    }
    if (sum.is_still()) return false;
    const Vec3 shift = sum.shift();
    const double smallest = smallest_volume_share * sum.six_volumes / static_cast<double>(scratch.star.size());
    return try_shift(vertex, shift * std::min(1.0, longest_shift / length(shift)), smallest, marks, scratch);
}

bool OdtMover::try_shift(int vertex, const Vec3& shift, double smallest, OdtMarks& marks, const Scratch& scratch) {
    const Vec3 start = complex_.points[vertex];
    for (double step : {1.0, 0.5, 0.25}) {
        const Vec3 trial = start + step * shift;
        const bool is_valid = std::all_of(scratch.faces.begin(), scratch.faces.end(), [&](const auto& f) {
            return dot(cross(f[0] - trial, f[1] - trial), f[2] - trial) > smallest;
        });
        if (!is_valid) continue;
        complex_.points[vertex] = trial;
        if (is_weighted_) sizes_[vertex] = sizing_.at(trial);
        marks.touched[vertex] = 1;
        for (int tet : scratch.star)
            for (int v : complex_.tets[tet]) marks.queued[v] = complex_.is_free(v);
        marks.queued[vertex] = step < 1;
        return true;
    }
    return false;
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/recovery/neighbourhood.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/second_order.h"

namespace featuremesh {

namespace {

using Corners = std::array<int, 3>;

Corners sorted(Corners c) {
    std::sort(c.begin(), c.end());
    return c;
}

}  // namespace

Neighbourhood::Neighbourhood(const Cavity& cavity, const CavityFill& fill, std::vector<std::uint8_t> is_inner,
                             std::span<const int> dropped)
    : cavity_(cavity),
      fill_(fill),
      is_inner_(std::move(is_inner)),
      inner_count_(static_cast<std::size_t>(std::count(is_inner_.begin(), is_inner_.end(), 1))) {
    number_points(dropped);
    collect_facets();
}

void Neighbourhood::number_points(std::span<const int> dropped) {
    sub_index_.assign(fill_.points.size(), -1);
    for (std::size_t t = 0; t < tets().size(); ++t)
        if (is_inner_[t])
            for (const int c : tets()[t]) sub_index_[c] = 0;
    for (const int point : dropped) sub_index_[point] = -1;
    auto gone = dropped.begin();
    for (int i = 0; i < static_cast<int>(fill_.points.size()); ++i) {
        place_.push_back(i - static_cast<int>(gone - dropped.begin()));
        if (gone != dropped.end() && *gone == i) ++gone;
        if (sub_index_[i] < 0) continue;
        sub_index_[i] = static_cast<int>(sub_.points.size());
        sub_.points.push_back(fill_.points[i]);
        point_of_sub_.push_back(i);
    }
}

void Neighbourhood::add_facet(const Corners& corners, int facet, bool is_border) {
    sub_.facets.push_back(
        {{sub_index_[corners[0]], sub_index_[corners[1]], sub_index_[corners[2]]}, {0, is_border ? -1 : 0}});
    facet_of_sub_.push_back(facet);
}

/// A facet on the border is a border.
void Neighbourhood::collect_facets() {
    std::vector<std::uint8_t> is_taken(cavity_.facets.size(), 0);
    for (std::size_t t = 0; t < tets().size(); ++t)
        for (int k = 0; k < 4 && is_inner_[t]; ++k) {
            const int other = fill_.triangulation.neighbours[t][k];
            if (other < 0 || is_inner_[other]) continue;  // at the hull of all points nothing is beyond
            const int facet = fill_.places.facet_at[4 * t + k];
            if (facet >= 0) is_taken[facet] = 1;
            border_facets_.emplace(sorted(facet_opposite(tets()[t], k)), other);
            add_facet(facet_opposite(tets()[t], k), facet, true);
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

std::optional<Triangulation> Neighbourhood::merge(const Triangulation& local, std::size_t added) const {
    const std::span<const Facet> border(sub_.facets.data(), border_count_);
    const FacetPlaces places = find_facets(local, sub_.points.size() + added, border);
    const std::vector<int> inside = label_inside(local, places);
    if (!places.missing.empty() || inside.empty()) return {};
    const int own = static_cast<int>(cavity_.points.size()), more = static_cast<int>(added);
    const int subs = static_cast<int>(sub_.points.size());
    const auto shifted = [&](int point) { return point < own ? point : place_[point] + more; };
    const auto from_sub = [&](int c) { return c < subs ? shifted(point_of_sub_[c]) : own + c - subs; };

    std::vector<int> outer_index(tets().size(), -1), inner_index(local.tets.size(), -1);
    int count = 0;
    for (std::size_t t = 0; t < tets().size(); ++t)
        if (!is_inner_[t]) outer_index[t] = count++;
    for (std::size_t t = 0; t < inside.size(); ++t)
        if (inside[t] == 0) inner_index[t] = count++;
    Triangulation all;
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
        const auto& c = local.tets[t];
        all.tets.push_back({from_sub(c[0]), from_sub(c[1]), from_sub(c[2]), from_sub(c[3])});
        auto& neighbours = all.neighbours.emplace_back();
        for (int k = 0; k < 4; ++k) {
            const bool is_border = places.facet_at[4 * t + k] >= 0;
            const int other = local.neighbours[t][k];
            neighbours[k] = is_border   ? outside_at(facet_opposite(c, k), index, outer_index, all)
                            : other < 0 ? -1
                                        : inner_index[other];
        }
    }
    return all;
}

/// By local tet: 0 within the border, 1 beyond it; empty when the two meet.
std::vector<int> Neighbourhood::label_inside(const Triangulation& local, const FacetPlaces& places) const {
    std::vector<int> state(local.tets.size(), -1), stack;
    const auto agrees = [&](int tet, int value) {
        if (state[tet] < 0) state[tet] = value, stack.push_back(tet);
        return state[tet] == value;
    };
    for (std::size_t t = 0; t < local.tets.size(); ++t)
        for (int k = 0; k < 4; ++k) {
            const int facet = places.facet_at[4 * t + k];
            if (facet < 0) continue;
            const bool is_beyond = is_odd(facet_opposite(local.tets[t], k)) != is_odd(sub_.facets[facet].corners);
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
int Neighbourhood::outside_at(const Corners& corners, int index, const std::vector<int>& outer_index,
                              Triangulation& all) const {
    const Corners key = sorted({point_of_sub_[corners[0]], point_of_sub_[corners[1]], point_of_sub_[corners[2]]});
    const int tet = border_facets_.at(key);
    for (int k = 0; k < 4; ++k)
        if (sorted(facet_opposite(tets()[tet], k)) == key) all.neighbours[outer_index[tet]][k] = index;
    return outer_index[tet];
}

}  // namespace featuremesh

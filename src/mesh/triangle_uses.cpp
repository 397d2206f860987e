// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_uses.h"

#include <algorithm>
#include <array>
#include <utility>

namespace featuremesh {
namespace {

/// Sorts the nodes of one element; true when that took an odd number of swaps.
bool sort_nodes(std::array<std::uint32_t, 4>& n) {
    bool odd = false;
    const auto order = [&](int i, int j) {
        const bool swap = n[j] < n[i];
        const std::uint32_t low = swap ? n[j] : n[i], high = swap ? n[i] : n[j];
        n[i] = low;
        n[j] = high;
        odd ^= swap;
    };
    order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
    return odd;
}

bool sort_nodes(std::array<std::uint32_t, 3>& n) {
    bool odd = false;
    for (const auto& [i, j] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{0, 1}})
        if (n[j] < n[i]) std::swap(n[i], n[j]), odd = !odd;
    return odd;
}

template <std::size_t count>
std::array<std::uint32_t, count> values_of(const std::array<NodeId, count>& nodes) {
    std::array<std::uint32_t, count> values;
    for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<std::uint32_t>(nodes[i].value);
    return values;
}

}  // namespace

TriangleUses::TriangleUses(const Mesh& mesh, std::span<const char> only, std::span<const TetId> near,
                           const RunContext& context)
    : begin_(mesh.points.size() + 1, 0) {
    RoundWatch watch(context);
    const auto is_wanted = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return only.empty() || (only[a] && only[b] && only[c]);
    };
    const auto count_marked = [&](const auto& nodes) {
        int count = 0;
        for (const NodeId n : nodes) count += only[n.index()] != 0;
        return count;
    };
    std::vector<std::size_t> wanted_tets;
    for (const TetId t : near)
        if (count_marked(mesh.tets[t.index()]) >= 3) wanted_tets.push_back(t.index());
    // Visits (smallest, middle, largest, code) of every wanted triangle, tets first.
    const auto for_each_use = [&](auto visit) {
        const std::size_t tet_count = only.empty() ? mesh.tets.size() : wanted_tets.size();
        for (std::size_t i = 0; i < tet_count; ++i) {
            watch();
            const std::size_t t = only.empty() ? i : wanted_tets[i];
            auto n = values_of(mesh.tets[t]);
            // the face opposite the j-th smallest node is outward in growing order when j and the parity of the sorting
            // agree
            const bool odd = sort_nodes(n);
            const std::int32_t even_face = static_cast<std::int32_t>(2 * t) + odd,
                               odd_face = static_cast<std::int32_t>(2 * t) + !odd;
            if (is_wanted(n[0], n[1], n[2])) visit(n[0], TriangleUse{n[1], n[2], odd_face});
            if (is_wanted(n[0], n[1], n[3])) visit(n[0], TriangleUse{n[1], n[3], even_face});
            if (is_wanted(n[0], n[2], n[3])) visit(n[0], TriangleUse{n[2], n[3], odd_face});
            if (is_wanted(n[1], n[2], n[3])) visit(n[1], TriangleUse{n[2], n[3], even_face});
        }
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            auto n = values_of(mesh.triangles[t]);
            if (!is_wanted(n[0], n[1], n[2])) continue;
            const bool odd = sort_nodes(n);
            visit(n[0], TriangleUse{n[1], n[2], -1 - (static_cast<std::int32_t>(2 * t) + odd)});
        }
    };
    for_each_use([&](std::uint32_t smallest, const TriangleUse&) { ++begin_[smallest]; });
    std::size_t sum = 0;
    for (std::size_t& entry : begin_) sum += std::exchange(entry, sum);
    uses_.resize(sum);
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for_each_use([&](std::uint32_t smallest, const TriangleUse& use) { uses_[next[smallest]++] = use; });
}

void TriangleUses::sort(std::span<TriangleUse> uses) {
    // The elements come in growing order, tets first: a stable sort by the two other nodes keeps that
    for (std::size_t i = 1; i < uses.size(); ++i) {
        const TriangleUse use = uses[i];
        const std::uint64_t key = std::uint64_t{use.middle} << 32 | use.largest;
        std::size_t j = i;
        for (; j > 0 && (std::uint64_t{uses[j - 1].middle} << 32 | uses[j - 1].largest) > key; --j)
            uses[j] = uses[j - 1];
        uses[j] = use;
    }
}

}  // namespace featuremesh

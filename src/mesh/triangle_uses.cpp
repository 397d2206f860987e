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

/// The wanted triangles of the wanted tets, then those of the surface: each element has a place.
class Elements {
  public:
    Elements(const Mesh& mesh, std::span<const char> only, std::span<const TetId> near) : mesh_(mesh), only_(only) {
        const auto count_marked = [&](const auto& nodes) {
            return std::count_if(nodes.begin(), nodes.end(), [&](NodeId n) { return only[n.index()] != 0; });
        };
        for (const TetId t : near)
            if (count_marked(mesh.tets[t.index()]) >= 3) tets_.push_back(t.index());
        tet_count_ = only.empty() ? mesh.tets.size() : tets_.size();
    }

    std::size_t count() const { return tet_count_ + mesh_.triangles.size(); }

    /// Visits (smallest, use) of every wanted triangle of one element.
    template <class Visit>
    void visit_uses_of(std::size_t place, const Visit& visit) const {
        if (place < tet_count_)
            visit_tet(only_.empty() ? place : tets_[place], visit);
        else
            visit_triangle(place - tet_count_, visit);
    }

  private:
    bool is_wanted(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return only_.empty() || (only_[a] && only_[b] && only_[c]);
    }

    template <class Visit>
    void visit_tet(std::size_t t, const Visit& visit) const {
        auto n = values_of(mesh_.tets[t]);
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

    template <class Visit>
    void visit_triangle(std::size_t t, const Visit& visit) const {
        auto n = values_of(mesh_.triangles[t]);
        if (!is_wanted(n[0], n[1], n[2])) return;
        const bool odd = sort_nodes(n);
        visit(n[0], TriangleUse{n[1], n[2], -1 - (static_cast<std::int32_t>(2 * t) + odd)});
    }

    const Mesh& mesh_;
    std::span<const char> only_;
    std::vector<std::size_t> tets_;  // those that are wanted, where not all are
    std::size_t tet_count_ = 0;
};

}  // namespace

TriangleUses::TriangleUses(const Mesh& mesh, std::span<const char> only, std::span<const TetId> near,
                           RunContext& context)
    : begin_(mesh.points.size() + 1, 0) {
    gather(mesh, only, near, context);
}

TriangleUses::TriangleUses(const Mesh& mesh) : begin_(mesh.points.size() + 1, 0) {
    RunContext context;
    gather(mesh, {}, {}, context);
}

/// Counting sort: each slice of the elements knows where its uses begin in every bucket. The result does not depend on
/// how many slices there are.
void TriangleUses::gather(const Mesh& mesh, std::span<const char> only, std::span<const TetId> near,
                          RunContext& context) {
    constexpr std::size_t least_of_slice = 1 << 14, most_slices = 8;
    const Elements elements(mesh, only, near);
    const auto wanted = std::min(static_cast<std::size_t>(std::max(context.threads, 1)), most_slices);
    const std::size_t of_slice = std::max(least_of_slice, (elements.count() + wanted - 1) / wanted);
    std::vector<std::vector<std::uint32_t>> next((elements.count() + of_slice - 1) / of_slice);
    parallel_for(context, elements.count(), of_slice, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t>& count = next[begin / of_slice];
        count.assign(mesh.points.size(), 0);
        RoundWatch watch(context);
        for (std::size_t i = begin; i < end; ++i) {
            watch();
            elements.visit_uses_of(i, [&](std::uint32_t smallest, const TriangleUse&) { ++count[smallest]; });
        }
    });
    std::uint32_t sum = 0;
    for (std::size_t node = 0; node < mesh.points.size(); ++node) {
        begin_[node] = sum;
        for (auto& of : next) sum += std::exchange(of[node], sum);
    }
    begin_.back() = sum;
    uses_ = std::make_unique_for_overwrite<TriangleUse[]>(sum);
    parallel_for(context, elements.count(), of_slice, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t>& to = next[begin / of_slice];
        RoundWatch watch(context);
        for (std::size_t i = begin; i < end; ++i) {
            watch();
            elements.visit_uses_of(
                i, [&](std::uint32_t smallest, const TriangleUse& use) { uses_[to[smallest]++] = use; });
        }
    });
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

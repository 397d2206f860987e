// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/bodies.h"

#include <algorithm>
#include <array>
#include <compare>
#include <numeric>

#include "mesh/second_order.h"

namespace featuremesh {

namespace {

struct Facet {
    std::int32_t middle, last, tet;  // nodes in ascending order; the first is where it is filed
    auto operator<=>(const Facet&) const = default;
};

std::array<std::int32_t, 3> sorted_facet(const Mesh& mesh, std::size_t tet, const std::array<int, 3>& corners) {
    std::array<std::int32_t, 3> nodes;
    for (std::size_t i = 0; i < 3; ++i) nodes[i] = mesh.tets[tet][std::size_t(corners[i])].value;
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

/// All facets of all tets by their first node: those of node n are facets[starts[n]] to facets[starts[n + 1]], sorted.
struct FacetsAtNodes {
    explicit FacetsAtNodes(const Mesh& mesh) : starts(mesh.node_count() + 2), facets(4 * mesh.tets.size()) {
        for_each_facet(mesh, [&](const auto& nodes, std::size_t) { ++starts[std::size_t(nodes[0]) + 2]; });
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        for_each_facet(mesh, [&](const auto& nodes, std::size_t tet) {
            facets[starts[std::size_t(nodes[0]) + 1]++] = {nodes[1], nodes[2], std::int32_t(tet)};
        });
        for (std::size_t node = 0; node < mesh.node_count(); ++node)
            std::sort(facets.begin() + std::ptrdiff_t(starts[node]), facets.begin() + std::ptrdiff_t(starts[node + 1]));
    }

    template <typename Visit>
    static void for_each_facet(const Mesh& mesh, const Visit& visit) {
        for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet)
            for (const auto& corners : tet_faces) visit(sorted_facet(mesh, tet, corners), tet);
    }

    std::vector<std::size_t> starts;
    std::vector<Facet> facets;
};

}  // namespace

std::vector<std::int32_t> bodies_of_tets(const Mesh& mesh) {
    std::vector<std::int32_t> first(mesh.tets.size());  // each tet points towards the first of its body
    std::iota(first.begin(), first.end(), 0);
    const auto root = [&](std::int32_t tet) {
        while (first[std::size_t(tet)] != tet)
            tet = first[std::size_t(tet)] = first[std::size_t(first[std::size_t(tet)])];
        return tet;
    };
    const FacetsAtNodes at_nodes(mesh);
    const std::vector<Facet>& facets = at_nodes.facets;
    for (std::size_t node = 0; node < mesh.node_count(); ++node)
        for (std::size_t i = at_nodes.starts[node] + 1; i < at_nodes.starts[node + 1]; ++i)
            if (facets[i].middle == facets[i - 1].middle && facets[i].last == facets[i - 1].last) {
                const std::int32_t a = root(facets[i - 1].tet), b = root(facets[i].tet);
                first[std::size_t(std::max(a, b))] = std::min(a, b);
            }
    std::vector<std::int32_t> bodies(mesh.tets.size());
    std::int32_t count = 0;
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) {
        const std::int32_t begin = root(std::int32_t(tet));
        bodies[tet] = begin == std::int32_t(tet) ? count++ : bodies[std::size_t(begin)];
    }
    return bodies;
}

}  // namespace featuremesh

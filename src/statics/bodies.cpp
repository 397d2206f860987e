// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/bodies.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "mesh/second_order.h"

namespace featuremesh {

std::vector<std::int32_t> bodies_of_tets(const Mesh& mesh) {
    struct Facet {
        std::array<std::int32_t, 3> nodes;
        std::int32_t tet;
    };
    std::vector<Facet> facets;
    facets.reserve(4 * mesh.tets.size());
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet)
        for (const auto& face : tet_faces) {
            std::array<std::int32_t, 3> nodes;
            for (std::size_t i = 0; i < 3; ++i) nodes[i] = mesh.tets[tet][std::size_t(face[i])].value;
            std::sort(nodes.begin(), nodes.end());
            facets.push_back({nodes, std::int32_t(tet)});
        }
    std::sort(facets.begin(), facets.end(),
              [](const Facet& a, const Facet& b) { return a.nodes != b.nodes ? a.nodes < b.nodes : a.tet < b.tet; });

    std::vector<std::int32_t> first(mesh.tets.size());  // each tet points towards the first of its body
    std::iota(first.begin(), first.end(), 0);
    const auto root = [&](std::int32_t tet) {
        while (first[std::size_t(tet)] != tet)
            tet = first[std::size_t(tet)] = first[std::size_t(first[std::size_t(tet)])];
        return tet;
    };
    for (std::size_t i = 1; i < facets.size(); ++i)
        if (facets[i].nodes == facets[i - 1].nodes) {
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

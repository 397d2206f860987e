// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/short_edges.h"

#include <algorithm>

#include "catch.h"
#include "core/messages.h"
#include "volume/filled_parts.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// A node at every vertex of the shape, in their order.
Mesh vertices_of(const Brep& brep, std::vector<NodeId>& nodes) {
    Mesh mesh;
    for (std::size_t v = 0; v < brep.vertex_count(); ++v)
        nodes.push_back(mesh.add_node(brep.point_of(VertexId(v)), entity_of(VertexId(v))));
    return mesh;
}

/// By length.
std::vector<std::pair<double, EdgeId>> edges_by_length(const Brep& brep) {
    std::vector<std::pair<double, EdgeId>> edges;
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        const auto [a, b] = brep.ends_of(EdgeId(e));
        edges.emplace_back(distance(brep.point_of(a), brep.point_of(b)), EdgeId(e));
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

}  // namespace

TEST_CASE("edges too short for tets are told where a tet has both of their ends") {
    const Brep brep(cut_corner(1e-3));
    std::vector<NodeId> nodes;
    const Mesh mesh = vertices_of(brep, nodes);
    const auto edges = edges_by_length(brep);
    REQUIRE(edges[1].first < brep.tolerances().least_length());
    REQUIRE(edges[2].first > brep.tolerances().least_length());
    const auto [a, b] = brep.ends_of(edges[0].second);
    const auto [c, d] = brep.ends_of(edges[1].second);
    const int first = a.value, last = b.value, other = c.value, far = d.value, inside = static_cast<int>(nodes.size());
    const auto told = [&](std::vector<std::array<int, 4>> tets) { return short_edges_among(brep, mesh, nodes, tets); };

    const std::vector<Message> one = told({{first, last, other, inside}});
    REQUIRE(one.size() == 1);
    CHECK(one.front() == say<Code::edge_of_length>(edges[0].second, Length{0.0014}));  // across the corner
    CHECK(told({{first, last, other, inside}, {last, inside, far, first}}).size() == 1);
    CHECK(told({{first, last, other, far}}).size() == 2);
    CHECK(told({{first, other, inside, inside + 1}}).empty());
    CHECK(told({{first, other, inside, inside + 1}, {last, far, inside, inside + 1}}).empty());
    CHECK(told({}).empty());
}

TEST_CASE("of many edges too short for tets the three shortest are told, the shortest first") {
    const Brep brep(engraved_block(6, 2e-3, 1));
    std::vector<NodeId> nodes;
    const Mesh mesh = vertices_of(brep, nodes);
    const auto edges = edges_by_length(brep);
    REQUIRE(edges[3].first < brep.tolerances().least_length());
    std::vector<std::array<int, 4>> tets;
    for (const auto& [length, edge] : edges) {
        const auto [a, b] = brep.ends_of(edge);
        tets.push_back({a.value, b.value, static_cast<int>(nodes.size()), static_cast<int>(nodes.size()) + 1});
    }
    std::reverse(tets.begin(), tets.end());
    const std::vector<Message> told = short_edges_among(brep, mesh, nodes, tets);
    REQUIRE(told.size() == 3);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(std::get<std::vector<Entity>>(told[i].parameters().front()) ==
              std::vector<Entity>{entity_of(edges[i].second)});
}

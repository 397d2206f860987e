// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <random>
#include <set>

#include "../mesh/box_mesh.h"
#include "catch.h"
#include "mesh/tets_at_nodes.h"
#include "volume/cavity.h"
#include "volume/fill_cavity.h"

using namespace featuremesh;

namespace {

using Corners = std::array<NodeId, 3>;

Corners sorted(Corners c) {
    std::sort(c.begin(), c.end());
    return c;
}

const std::vector<std::array<SolidId, 2>> outer_faces(6, {SolidId(std::size_t{0}), SolidId()});

/// Faces that exactly one kept tet has, less those on a CAD face; and CAD triangles without a kept tet.
std::set<Corners> brute_force(const Mesh& mesh, const std::vector<std::uint8_t>& is_released) {
    std::map<Corners, int> count;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
        for (int k = 0; k < 4 && !is_released[t]; ++k) {
            const auto& tet = mesh.tets[t];
            ++count[sorted({tet[(k + 1) % 4], tet[(k + 2) % 4], tet[(k + 3) % 4]})];
        }
    for (const auto& triangle : mesh.triangles) ++count[sorted(triangle)];
    std::set<Corners> open;
    for (const auto& [face, uses] : count)
        if (uses == 1) open.insert(face);
    return open;
}

std::set<Corners> facets_of(const Cavity& cavity) {
    std::set<Corners> found;
    for (const Facet& f : cavity.facets)
        found.insert(sorted({cavity.nodes[f.corners[0]], cavity.nodes[f.corners[1]], cavity.nodes[f.corners[2]]}));
    return found;
}

/// Volume of what is to be filled, from the facets.
double volume_between(const Cavity& cavity) {
    double volume = 0;
    for (const Facet& f : cavity.facets) {
        const double part =
            dot(cavity.points[f.corners[0]], cross(cavity.points[f.corners[1]], cavity.points[f.corners[2]])) / 6;
        volume += (f.regions[0] >= 0 ? part : 0) - (f.regions[1] >= 0 ? part : 0);
    }
    return volume;
}

NodeId node_nearest(const Mesh& mesh, const Vec3& place) {
    NodeId nearest(std::size_t{0});
    for (std::size_t n = 0; n < mesh.node_count(); ++n)
        if (squared_length(mesh.point(NodeId(n)) - place) < squared_length(mesh.point(nearest) - place))
            nearest = NodeId(n);
    return nearest;
}

std::vector<char> marked(const Mesh& mesh, std::initializer_list<NodeId> nodes) {
    std::vector<char> marks(mesh.node_count(), 0);
    for (const NodeId n : nodes) marks[n.index()] = 1;
    return marks;
}

double volume_of(const Mesh& mesh, const std::vector<std::uint8_t>& marked) {
    double volume = 0;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
        if (marked[t])
            volume += signed_volume(mesh.point(mesh.tets[t][0]), mesh.point(mesh.tets[t][1]),
                                    mesh.point(mesh.tets[t][2]), mesh.point(mesh.tets[t][3]));
    return volume;
}

}  // namespace

TEST_CASE("the cavity is what brute force finds, and encloses what was released") {
    const Mesh mesh = box_mesh(5);
    const unsigned seed = GENERATE(1u, 2u, 3u, 4u, 5u);
    const double share = GENERATE(0.01, 0.3, 0.9, 1.0);
    INFO("seed " << seed << ", share " << share);
    std::mt19937 random(seed);
    std::vector<std::uint8_t> is_released(mesh.tets.size());
    for (auto& flag : is_released) flag = std::uniform_real_distribution<double>(0, 1)(random) < share;
    const Cavity cavity = find_cavity(mesh, outer_faces, is_released);
    CHECK(facets_of(cavity) == brute_force(mesh, is_released));
    CHECK(facets_of(cavity).size() == cavity.facets.size());
    std::vector<char> rim(mesh.node_count(), 0);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
        if (is_released[t])
            for (const NodeId n : mesh.tets[t]) rim[n.index()] = 1;
    const Cavity told = find_cavity(mesh, outer_faces, is_released, rim);
    CHECK(told.nodes == cavity.nodes);
    CHECK(told.tet_of_facet == cavity.tet_of_facet);
    CHECK(told.triangle_of_facet == cavity.triangle_of_facet);
    const std::vector<TetId> near = tets_at_nodes(mesh, rim);
    const Cavity led = find_cavity(mesh, outer_faces, is_released, rim, near);
    CHECK(led.nodes == cavity.nodes);
    CHECK(led.tet_of_facet == cavity.tet_of_facet);
    CHECK(led.triangle_of_facet == cavity.triangle_of_facet);
    CHECK(volume_between(cavity) == Approx(volume_of(mesh, is_released)));
    CHECK(open_facets(cavity).empty());
    for (std::size_t i = 0; i < cavity.facets.size(); ++i) {
        CHECK(cavity.triangle_of_facet[i].is_valid() != cavity.tet_of_facet[i].is_valid());
        if (cavity.tet_of_facet[i].is_valid()) CHECK_FALSE(is_released[cavity.tet_of_facet[i].index()]);
    }
}

TEST_CASE("a node that a grown cavity encloses is a seed of its fill, with the triangulation from before") {
    const Mesh mesh = box_mesh(6);
    const NodeId enclosed = node_nearest(mesh, {1.0 / 3, 1.0 / 3, 1.0 / 3});
    std::vector<std::uint8_t> is_released(mesh.tets.size(), 0);
    is_released[tets_at_nodes(mesh, marked(mesh, {enclosed})).front().index()] = 1;
    const Cavity before = find_cavity(mesh, outer_faces, is_released);
    for (const TetId t : tets_at_nodes(mesh, marked(mesh, {enclosed}))) is_released[t.index()] = 1;
    const Cavity cavity = find_cavity(mesh, outer_faces, is_released);
    REQUIRE(std::binary_search(before.nodes.begin(), before.nodes.end(), enclosed));
    REQUIRE_FALSE(std::binary_search(cavity.nodes.begin(), cavity.nodes.end(), enclosed));

    RunContext context;
    CavityFill old;
    old.points = before.points;
    old.delaunay = std::make_shared<GrowingDelaunay>();
    old.delaunay->insert(old.points, context);
    old.point_of.resize(old.points.size());
    std::iota(old.point_of.begin(), old.point_of.end(), 0);
    const CavityFill grown = grow_fill(cavity, before.nodes, old, context);
    REQUIRE(grown.points.size() == cavity.points.size() + 1);
    CHECK(std::equal(cavity.points.begin(), cavity.points.end(), grown.points.begin()));
    CHECK(grown.points.back() == mesh.point(enclosed));
    for (const auto& [a, b, c, d] : grown.triangulation.tets)
        CHECK(signed_volume(grown.points[a], grown.points[b], grown.points[c], grown.points[d]) >= 0);
}

TEST_CASE("a full mesh has no cavity") { CHECK(find_cavity(box_mesh(4), outer_faces).facets.empty()); }

TEST_CASE("cavities apart from one another are separated, a shell stays with its void") {
    const Mesh mesh = box_mesh(6);
    std::vector<std::uint8_t> is_released(mesh.tets.size(), 0);
    const auto release = [&](double low, double high) {
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            bool is_inside = true;
            for (const NodeId n : mesh.tets[t])
                for (int k = 0; k < 3; ++k)
                    is_inside = is_inside && mesh.point(n)[k] > low - 1e-9 && mesh.point(n)[k] < high + 1e-9;
            if (is_inside) is_released[t] ^= 1;
        }
    };
    release(0, 2.0 / 6), release(4.0 / 6, 1);
    CHECK(separate_cavities(find_cavity(mesh, outer_faces, is_released)).size() == 2);
    std::fill(is_released.begin(), is_released.end(), 0);
    release(1.0 / 6, 5.0 / 6), release(2.0 / 6, 4.0 / 6);  // a shell around kept tets
    const std::vector<Cavity> shell = separate_cavities(find_cavity(mesh, outer_faces, is_released));
    REQUIRE(shell.size() == 1);
    CHECK(volume_between(shell[0]) == Approx(volume_of(mesh, is_released)));
}

TEST_CASE("an open boundary is seen") {
    Mesh mesh = box_mesh(3);
    mesh.tets.clear(), mesh.tet_solids.clear(), mesh.tet_numbers.clear();
    CHECK(open_facets(find_cavity(mesh, outer_faces)).empty());
    mesh.triangles.pop_back(), mesh.triangle_faces.pop_back(), mesh.triangle_numbers.pop_back();
    CHECK(open_facets(find_cavity(mesh, outer_faces)).size() == 3);
}

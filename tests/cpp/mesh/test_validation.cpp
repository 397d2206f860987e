// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "box_mesh.h"
#include "catch.h"
#include "core/messages.h"
#include "mesh/second_order.h"
#include "mesh/validation.h"

using namespace featuremesh;

namespace {

/// All messages of a mesh that was broken on purpose.
std::string messages_after(const std::function<void(Mesh&, Expectation&)>& harm, int order = 1) {
    Mesh mesh = box_mesh(2);
    if (order == 2) add_mid_side_nodes(mesh);
    Expectation expected = box_expectation();
    harm(mesh, expected);
    std::string all;
    for (const Message& message : broken_invariants(mesh, expected)) all += message.in_english() + "\n";
    return all;
}

bool has(const std::string& text, const std::string& part) {
    INFO(text);
    return text.find(part) != std::string::npos;
}

bool has(const Message& message, const std::string& part) { return has(message.in_english(), part); }

void remove_tet(Mesh& mesh, std::size_t t) {
    const auto at = static_cast<std::ptrdiff_t>(t);
    mesh.tets.erase(mesh.tets.begin() + at);
    mesh.tet_solids.erase(mesh.tet_solids.begin() + at);
    mesh.tet_numbers.erase(mesh.tet_numbers.begin() + at);
}

void remove_triangle(Mesh& mesh, std::size_t t) {
    const auto at = static_cast<std::ptrdiff_t>(t);
    mesh.triangles.erase(mesh.triangles.begin() + at);
    mesh.triangle_faces.erase(mesh.triangle_faces.begin() + at);
    mesh.triangle_numbers.erase(mesh.triangle_numbers.begin() + at);
}

/// The middle of the box becomes a wall between two solids, as face 6.
Mesh two_solids(Expectation& expected) {
    Mesh mesh = box_mesh(2);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        double x = 0;
        for (NodeId n : mesh.tets[t]) x += mesh.point(n).x / 4;
        if (x < 0.5) continue;
        mesh.tet_solids[t] = SolidId(1);
        for (const auto& face : tet_faces) {
            const std::array<NodeId, 3> nodes{mesh.tets[t][face[0]], mesh.tets[t][face[1]], mesh.tets[t][face[2]]};
            bool on_wall = true;
            for (NodeId n : nodes) on_wall = on_wall && mesh.point(n).x == 0.5;
            if (on_wall) mesh.add_triangle(nodes, FaceId(6));
        }
    }
    expected.solid_volumes = {0.5, 0.5};
    expected.solids_beside_face = {{SolidId(0), {}}, {SolidId(1), {}}, {}, {}, {}, {}, {SolidId(1), SolidId(0)}};
    return mesh;
}

}  // namespace

TEST_CASE("a good mesh breaks no invariant, for any number of threads") {
    for (int n : {1, 2, 5}) CHECK(broken_invariants(box_mesh(n), box_expectation()).empty());
    Mesh mesh = box_mesh(15);
    RunContext context;
    context.threads = 3;
    CHECK(broken_invariants(mesh, box_expectation(), context).empty());
    CHECK(broken_invariants(Mesh{}).empty());
}

TEST_CASE("tets: volume, overlap, gaps") {
    CHECK(has(messages_after([](Mesh& m, Expectation&) { std::swap(m.tets[3][0], m.tets[3][1]); }),
              "element without positive volume: element "));
    CHECK(has(messages_after([](Mesh& m, Expectation&) { std::swap(m.tets[3][0], m.tets[3][1]); }),
              "two elements overlap at a triangle"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) { m.add_tet(m.tets[5], SolidId(0)); }),
              "triangle shared by more than two elements"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) { remove_tet(m, 7); }),
              "boundary of the elements without a triangle"));
    CHECK(has(messages_after([](Mesh&, Expectation& e) { e.solid_volumes = {1.1}; }), "volume is wrong: Solid1"));
    // moving the inner node onto the boundary makes tets flat
    CHECK(has(messages_after([](Mesh& m, Expectation&) {
                  m.points[13] = {0.5, 0.5, 0};
              }),
              "element without positive volume"));
}

TEST_CASE("triangles: missing, twice, loose, before what they should be behind") {
    CHECK(has(messages_after([](Mesh& m, Expectation&) { remove_triangle(m, 2); }),
              "boundary of the elements without a triangle"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) { m.add_triangle(m.triangles[2], FaceId(0)); }),
              "the same triangle twice"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) {
                  m.add_triangle({NodeId(0), NodeId(1), NodeId(26)}, FaceId(0));
              }),
              "triangle without an element"));
    const auto flipped = messages_after([](Mesh& m, Expectation&) { std::swap(m.triangles[4][0], m.triangles[4][1]); });
    CHECK(has(flipped, "wrong solid at a triangle"));
    CHECK(has(flipped, "Face"));
    CHECK(has(flipped, "the outside behind it, not Solid1"));
}

TEST_CASE("what is found is a message for each kind, whose parameter says where, five times at most") {
    Mesh mesh = box_mesh(2);
    for (int t = 0; t < 8; ++t) std::swap(mesh.tets[t][0], mesh.tets[t][1]);
    const Message found = broken_invariants(mesh, box_expectation()).front();
    CHECK(found.code() == Code::tet_without_volume);
    const auto& places = std::get<std::vector<Message>>(found.parameters().at(0));
    REQUIRE(places.size() == 6);
    CHECK(places[0] ==
          say<Code::at_tet>(mesh.tet_numbers[0], say<Code::at_node>(mesh.node_numbers[mesh.tets[0][0].index()],
                                                                    mesh.point(mesh.tets[0][0]))));
    CHECK(places[5] == say<Code::and_more>(3));
}

TEST_CASE("several solids: the wall between them has triangles with the right solids beside them") {
    Expectation expected;
    Mesh mesh = two_solids(expected);
    // the outer faces y and z belong to both solids here, so only the wall is checked
    expected.solids_beside_face.clear();
    CHECK(broken_invariants(mesh, expected).empty());
    Mesh without = mesh;
    remove_triangle(without, without.triangles.size() - 1);
    CHECK_FALSE(broken_invariants(without, expected).empty());
    CHECK(has(broken_invariants(without, expected)[0], "border of two solids without a triangle"));
}

TEST_CASE("numbers, arrays and ids") {
    CHECK(has(messages_after([](Mesh& m, Expectation&) { m.node_numbers[4] = m.node_numbers[9]; }),
              "node number given twice"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) { m.tet_numbers[4] = m.triangle_numbers[1]; }),
              "element number given twice"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) { m.tet_numbers[4] = m.next_element_number; }),
              "element number out of range"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) { m.node_numbers[0] = 0; }), "node number out of range"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) { m.entities.pop_back(); }), "array of wrong length: entities"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) { m.tets[2][1] = NodeId(27); }),
              "node out of range: tets has 27 at place 2"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) { m.triangle_faces[2] = FaceId(6); }),
              "face, edge or solid out of range"));
    for (const Entity wrong : {Entity{4, 0}, Entity{-1, 0}, Entity{3, 1}, Entity{3, -1}, Entity{2, 6}, Entity{1, -1}})
        CHECK(has(messages_after([&](Mesh& m, Expectation&) { m.entities[13] = wrong; }),
                  "face, edge or solid out of range: entities has"));
    CHECK(
        has(messages_after([](Mesh& m, Expectation&) { m.points[5].y = std::nan(""); }), "coordinate is not a number"));
}

TEST_CASE("segments lie on sides of triangles, once") {
    CHECK(has(messages_after([](Mesh& m, Expectation&) {
                  m.add_segment({NodeId(0), NodeId(2)}, EdgeId(7));
              }),
              "segment that is no triangle's side"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) {
                  m.add_segment({m.segments[0][1], m.segments[0][0]}, EdgeId(7));
              }),
              "the same segment twice"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) {
                  m.add_segment({m.segments[0][1], m.segments[0][0]}, EdgeId(7));
              }),
              "Edge8"));
}

TEST_CASE("10-node tets: shared mid-side nodes and positive Jacobians") {
    CHECK(messages_after([](Mesh&, Expectation&) {}, 2).empty());
    CHECK(has(messages_after([](Mesh& m, Expectation&) { m.tet_mids[0][0] = m.tet_mids[40][3]; }, 2), "mid-side node"));
    CHECK(has(messages_after([](Mesh& m, Expectation&) { m.triangle_mids[3][1] = m.triangle_mids[20][2]; }, 2),
              "two mid-side nodes on one side"));
    CHECK(has(messages_after(
                  [](Mesh& m, Expectation&) {
                      m.points[m.tet_mids[0][0].index()] += {0.4, 0.3, -0.3};
                  },
                  2),
              "non-positive Jacobian: element "));
    CHECK(messages_after(
              [](Mesh& m, Expectation&) {
                  m.points[m.tet_mids[0][0].index()] += {0.02, 0.01, -0.01};
              },
              2)
              .empty());
}

TEST_CASE("the volume of 10-node tets is that of the curved elements") {
    // a bulge of a boundary side adds volume, one of an inner side only moves it
    const auto bulge = [](bool on_boundary) {
        return messages_after(
            [=](Mesh& m, Expectation&) {
                for (std::size_t n = m.corner_count; n < m.points.size(); ++n)
                    if ((m.entities[n].dim == 2 && m.entities[n].index == 0) == on_boundary &&
                        (on_boundary || m.entities[n].dim == 3)) {
                        m.points[n].x -= 0.01;
                        return;
                    }
            },
            2);
    };
    CHECK(has(bulge(true), "volume is wrong: Solid1"));
    CHECK(bulge(false).empty());
}

TEST_CASE("a surface without tets is closed around its solid") {
    Mesh surface = box_mesh(2);
    surface.tets.clear(), surface.tet_solids.clear(), surface.tet_numbers.clear();
    Expectation sides;
    sides.solids_beside_face = box_expectation().solids_beside_face;
    CHECK(broken_invariants(surface, sides).empty());
    CHECK(broken_invariants(surface).empty());
    Mesh open = surface;
    remove_triangle(open, 3);
    CHECK(has(broken_invariants(open, sides).at(0), "open surface around Solid1"));
    CHECK(has(broken_invariants(open).at(0), "open surface"));
    Mesh turned = surface;
    std::swap(turned.triangles[3][0], turned.triangles[3][1]);
    CHECK(has(broken_invariants(turned, sides).at(0), "open surface around Solid1"));
    CHECK(has(broken_invariants(surface, box_expectation()).at(0), "volume is wrong"));
}

TEST_CASE("around what was changed, a validation of the unproven finds what one of everything finds") {
    const Mesh good = box_mesh(3);
    Expectation expected = box_expectation();
    expected.is_unproven.assign(good.node_count(), 0);
    CHECK(broken_invariants(good, expected).empty());
    for (std::size_t t = 0; t < good.tets.size(); t += 7) {
        Expectation changed = expected;
        for (const NodeId n : good.tets[t]) changed.is_unproven[n.index()] = 1;
        Mesh gap = good;
        remove_tet(gap, t);
        CHECK_FALSE(broken_invariants(gap, changed).empty());
        Mesh inverted = good;
        std::swap(inverted.tets[t][0], inverted.tets[t][1]);
        CHECK_FALSE(broken_invariants(inverted, changed).empty());
        Mesh twice = good;
        twice.add_tet(good.tets[t], SolidId(0));
        CHECK_FALSE(broken_invariants(twice, changed).empty());
        Mesh flat = good;
        flat.points[good.tets[t][0].index()] = flat.points[good.tets[t][1].index()];
        CHECK_FALSE(broken_invariants(flat, changed).empty());
    }
    Mesh numbered = good;
    numbered.tet_numbers.back() = numbered.tet_numbers.front();
    CHECK_FALSE(broken_invariants(numbered, expected).empty());
    Mesh swollen = good;
    for (Vec3& p : swollen.points) p = p * 1.5;
    CHECK_FALSE(broken_invariants(swollen, expected).empty());
}

TEST_CASE("around what was changed, a validation of the unproven finds wrong mid-side nodes") {
    Mesh good = box_mesh(3);
    add_mid_side_nodes(good);
    Expectation expected = box_expectation();
    expected.is_unproven.assign(good.node_count(), 0);
    CHECK(broken_invariants(good, expected).empty());
    const auto says = [](const std::vector<Message>& broken, const char* words) {
        return std::any_of(broken.begin(), broken.end(), [&](const Message& line) { return has(line, words); });
    };
    for (std::size_t t = 0; t < good.tets.size(); t += 7) {
        Expectation changed = expected;
        for (const NodeId n : good.tets[t]) changed.is_unproven[n.index()] = 1;
        CHECK(broken_invariants(good, changed).empty());
        Mesh exchanged = good;
        std::swap(exchanged.tet_mids[t][1], exchanged.tet_mids[t][4]);
        CHECK(says(broken_invariants(exchanged, changed), "two mid-side nodes on one side"));
        Mesh folded = good;
        folded.points[good.tet_mids[t][3].index()] =
            folded.point(good.tets[t][0]) * 3 - folded.point(good.tets[t][3]) * 2;
        CHECK(says(broken_invariants(folded, changed), "non-positive Jacobian"));
    }
}

TEST_CASE("the volume within curved triangles is that of the curved tets") {
    Mesh mesh = box_mesh(2);
    const std::vector<NodeId> mids = add_mid_side_nodes(mesh);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> off(-0.02, 0.02);
    for (const NodeId n : mids) mesh.points[n.index()] += Vec3{off(random), off(random), off(random)};
    double volume = 0;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
        for (const double coefficient : jacobian_coefficients(tet_nodes(mesh, TetId(t)))) volume += coefficient / 120;
    REQUIRE(std::abs(volume - 1) > 1e-3);
    Expectation expected = box_expectation();
    expected.is_unproven.assign(mesh.node_count(), 0);
    expected.volume_tolerance = 1e-12;
    expected.solid_volumes = {volume};
    CHECK(broken_invariants(mesh, expected).empty());
    expected.solid_volumes = {volume * (1 + 1e-10)};
    CHECK(has(broken_invariants(mesh, expected).at(0), "volume is wrong"));
}

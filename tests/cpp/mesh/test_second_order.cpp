// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>
#include <set>

#include "box_mesh.h"
#include "catch.h"
#include "mesh/quality.h"
#include "mesh/second_order.h"

using namespace featuremesh;

namespace {

std::array<Vec3, 10> straight_element(const std::array<Vec3, 4>& corners) {
    std::array<Vec3, 10> nodes;
    for (int i = 0; i < 4; ++i) nodes[i] = corners[i];
    for (int s = 0; s < 6; ++s) nodes[4 + s] = (corners[tet_sides[s][0]] + corners[tet_sides[s][1]]) * 0.5;
    return nodes;
}

std::array<Vec3, 10> bent_element(std::mt19937& random, double by) {
    std::uniform_real_distribution<double> shift(-by, by);
    auto nodes = straight_element({Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0.2, 0.9, 0}, Vec3{0.3, 0.2, 0.8}});
    for (int s = 4; s < 10; ++s) nodes[s] += {shift(random), shift(random), shift(random)};
    return nodes;
}

/// The element's map, by its quadratic shape functions.
Vec3 position(const std::array<Vec3, 10>& nodes, const std::array<double, 4>& l) {
    Vec3 p;
    for (int i = 0; i < 4; ++i) p += l[i] * (2 * l[i] - 1) * nodes[i];
    for (int s = 0; s < 6; ++s) p += 4 * l[tet_sides[s][0]] * l[tet_sides[s][1]] * nodes[4 + s];
    return p;
}

/// det J by central differences, which are exact for a quadratic map.
double determinant(const std::array<Vec3, 10>& nodes, const std::array<double, 4>& l) {
    const double step = 0.25;
    std::array<Vec3, 3> column;
    for (int k = 0; k < 3; ++k) {
        auto before = l, after = l;
        before[0] += step, before[k + 1] -= step;
        after[0] -= step, after[k + 1] += step;
        column[k] = (position(nodes, after) - position(nodes, before)) / (2 * step);
    }
    return dot(cross(column[0], column[1]), column[2]);
}

std::vector<std::array<double, 4>> lattice(int n) {
    std::vector<std::array<double, 4>> points;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; i + j <= n; ++j)
            for (int k = 0; i + j + k <= n; ++k)
                points.push_back({double(n - i - j - k) / n, double(i) / n, double(j) / n, double(k) / n});
    return points;
}

/// So that a mid-side node that was made anew is told from one that was kept.
Mesh box_with_moved_mids() {
    Mesh mesh = box_mesh(2);
    add_mid_side_nodes(mesh);
    for (std::size_t i = mesh.corner_count; i < mesh.points.size(); ++i) mesh.points[i].x += 1e-3;
    return mesh;
}

}  // namespace

TEST_CASE("the gradient of the Bernstein coefficients is that of their differences") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto nodes = bent_element(random, 0.1);
    std::array<double, 20> weights;
    for (double& w : weights) w = number(random);
    const auto weighted = [&](const std::array<Vec3, 10>& of) {
        const auto c = jacobian_coefficients(of);
        double sum = 0;
        for (int k = 0; k < 20; ++k) sum += weights[k] * c[k];
        return sum;
    };
    const auto gradient = jacobian_gradient(nodes, weights);
    for (int n = 0; n < 10; ++n)
        for (const Vec3& direction : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
            auto before = nodes, after = nodes;
            before[n] -= 1e-4 * direction, after[n] += 1e-4 * direction;
            CHECK(dot(gradient[n], direction) == Approx((weighted(after) - weighted(before)) / 2e-4).margin(1e-6));
        }
}

TEST_CASE("a straight element has constant Jacobian, six times its volume") {
    const auto nodes = straight_element({Vec3{1, 2, 3}, Vec3{2, 2, 3}, Vec3{1, 4, 3}, Vec3{1, 2, 6}});
    for (double coefficient : jacobian_coefficients(nodes)) CHECK(coefficient == Approx(6.0));
    CHECK(min_scaled_jacobian(nodes) == Approx(1.0));
}

TEST_CASE("the Bernstein coefficients bound the Jacobian and the subdivision finds its minimum") {
    std::mt19937 random(11);
    const auto samples = lattice(24);
    int folded = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const auto nodes = bent_element(random, trial % 2 ? 0.06 : 0.14);
        const double straight = 6 * signed_volume(nodes[0], nodes[1], nodes[2], nodes[3]);
        const auto coefficients = jacobian_coefficients(nodes);
        const auto [low, high] = std::minmax_element(coefficients.begin(), coefficients.end());
        double at_corners = 1e300;
        for (int corner = 0; corner < 4; ++corner) {
            std::array<double, 4> l{};
            l[corner] = 1;
            at_corners = std::min(at_corners, determinant(nodes, l));
        }
        CHECK(smallest_coefficient(nodes, -1e300) == *low);
        CHECK(smallest_coefficient(nodes, at_corners - 1e-9) == *low);
        CHECK(smallest_coefficient(nodes, at_corners + 1e-9) < -1e300);
        double sampled = 1e300;
        for (const auto& l : samples) {
            const double value = determinant(nodes, l);
            REQUIRE(value >= *low - 1e-12);
            REQUIRE(value <= *high + 1e-12);
            sampled = std::min(sampled, value / straight);
        }
        const double bound = min_scaled_jacobian(nodes);
        if (sampled > 0) {
            CHECK(bound <= sampled + 1e-12);
            CHECK(bound >= sampled - 0.02);
        } else {
            CHECK(bound <= 0);
            ++folded;
        }
    }
    CHECK(folded > 0);
}

TEST_CASE("the Jacobian does not depend on how the corners are numbered") {
    std::mt19937 random(5);
    const auto nodes = bent_element(random, 0.08);
    // corners 1, 2, 3 turned: sides 01 12 02 03 13 23 become 02 23 03 01 12 13
    const std::array<Vec3, 10> turned{nodes[0], nodes[2], nodes[3], nodes[1], nodes[6],
                                      nodes[9], nodes[7], nodes[4], nodes[5], nodes[8]};
    CHECK(min_scaled_jacobian(turned) == Approx(min_scaled_jacobian(nodes)).margin(2e-3));
}

TEST_CASE("an element without positive volume is invalid") {
    CHECK(min_scaled_jacobian(straight_element({Vec3{0, 0, 0}, Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}})) < 0);
    CHECK(min_scaled_jacobian(straight_element({Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{1, 1, 0}})) < 0);
}

TEST_CASE("mid-side nodes: one per side, on the entity of the side") {
    Mesh mesh = box_mesh(3);
    std::set<std::pair<NodeId, NodeId>> sides;
    for (const auto& tet : mesh.tets)
        for (const auto& [i, j] : tet_sides) sides.insert(std::minmax(tet[i], tet[j]));
    const std::size_t corners = mesh.points.size();
    const auto added = add_mid_side_nodes(mesh);
    CHECK(added.size() == sides.size());
    CHECK(mesh.points.size() == corners + sides.size());
    CHECK(mesh.corner_count == corners);
    CHECK(broken_invariants(mesh, box_expectation()).empty());
    for (std::size_t i = 0; i < mesh.segments.size(); ++i)
        CHECK(mesh.entities[mesh.segment_mids[i].index()] == entity_of(mesh.segment_edges[i]));
    for (NodeId n : added) {
        const Vec3& p = mesh.point(n);
        int on = 0;
        for (double c : {p.x, p.y, p.z}) on += c == 0 || c == 1;
        CHECK(mesh.entities[n.index()].dim == 3 - on);
    }
    CHECK(measure_quality(mesh).min_scaled_jacobian == 1.0);
}

TEST_CASE("kept mid-side nodes keep bits, numbers and order") {
    const Mesh kept = box_with_moved_mids();
    Mesh again = box_mesh(2);
    again.next_node_number = kept.next_node_number;
    CHECK(add_mid_side_nodes(again, &kept).empty());
    CHECK(again.points == kept.points);
    CHECK(again.node_numbers == kept.node_numbers);
    CHECK(again.tet_mids == kept.tet_mids);

    Mesh less = kept;
    less.tets.resize(6), less.tet_mids.resize(6), less.tet_solids.resize(6), less.tet_numbers.resize(6);
    less.triangles.clear(), less.triangle_mids.clear(), less.triangle_faces.clear(), less.triangle_numbers.clear();
    less.segments.clear(), less.segment_mids.clear(), less.segment_edges.clear(), less.segment_numbers.clear();
    Mesh partly = box_mesh(2);
    partly.next_node_number = kept.next_node_number;
    const auto added = add_mid_side_nodes(partly, &less);
    CHECK(added.size() == kept.points.size() - kept.corner_count - 19);  // a cube of six tets has 19 sides
    for (std::size_t t = 0; t < 6; ++t)
        for (int s = 0; s < 6; ++s) {
            CHECK(partly.point(partly.tet_mids[t][s]) == kept.point(kept.tet_mids[t][s]));
            CHECK(partly.node_numbers[partly.tet_mids[t][s].index()] == kept.node_numbers[kept.tet_mids[t][s].index()]);
        }
    for (NodeId n : added) CHECK(partly.node_numbers[n.index()] >= kept.next_node_number);
    CHECK(partly.node_count() == kept.node_count());
}

TEST_CASE("kept mid-side nodes are found whatever numbers the elements have") {
    for (const Number apart : {Number{1}, Number{1000000000000}}) {
        const auto spread = [&](Mesh& mesh) {
            for (auto* numbers : {&mesh.segment_numbers, &mesh.triangle_numbers, &mesh.tet_numbers})
                for (Number& number : *numbers) number *= apart;
            mesh.next_element_number *= apart;
        };
        Mesh kept = box_with_moved_mids(), now = box_mesh(2);
        now.next_node_number = kept.next_node_number;
        spread(kept), spread(now);
        std::swap(now.tets[0], now.tets[1]), std::swap(now.tet_numbers[0], now.tet_numbers[1]);
        CHECK(add_mid_side_nodes(now, &kept).empty());
        CHECK(now.point(now.tet_mids[0][0]) == kept.point(kept.tet_mids[1][0]));
        CHECK(now.point(now.tet_mids[1][0]) == kept.point(kept.tet_mids[0][0]));
        CHECK(now.point(now.tet_mids[2][5]) == kept.point(kept.tet_mids[2][5]));
    }
}

TEST_CASE("kept mid-side nodes follow new corners and serve new elements") {
    const Mesh kept = box_with_moved_mids();
    Mesh more = box_mesh(2);
    more.next_node_number = kept.next_node_number;
    const auto [a, b, c] = more.triangles[0];
    const NodeId top = more.add_node({-1, -1, -1}, entity_of(SolidId(0)));
    more.add_tet({a, c, b, top}, SolidId(0));
    CHECK(add_mid_side_nodes(more, &kept).size() == 3);
    CHECK(more.node_count() == kept.node_count() + 4);
    for (std::size_t t = 0; t < kept.tets.size(); ++t)
        for (int s = 0; s < 6; ++s) {
            const std::size_t now = more.tet_mids[t][s].index(), was = kept.tet_mids[t][s].index();
            CHECK(more.points[now] == kept.points[was]);
            CHECK(more.node_numbers[now] == kept.node_numbers[was]);
        }
    for (int s = 0; s < 3; ++s) {  // sides of the triangle, from its other side: c a, b c, a b
        const std::array<int, 3> as_seen{2, 1, 0};
        CHECK(more.tet_mids.back()[s] == more.triangle_mids[0][as_seen[s]]);
    }
}

TEST_CASE("6-node triangles: straight, bent within reason, and folded") {
    const Vec3 a{0, 0, 0}, b{2, 0, 0}, c{0, 2, 0};
    const auto with_middle_of_ab = [&](const Vec3& ab) {
        return min_scaled_jacobian(std::array<Vec3, 6>{a, b, c, ab, (b + c) / 2, (c + a) / 2});
    };
    CHECK(with_middle_of_ab({1, 0, 0}) == Approx(1));
    CHECK(with_middle_of_ab({1, 0, 0.2}) > 0.9);  // out of the plane, as on a curved face
    CHECK(with_middle_of_ab({1, 0.2, 0}) > 0.2);  // towards the inside
    CHECK(with_middle_of_ab({1, 0.6, 0}) <= 0);   // across the element
    CHECK(with_middle_of_ab({1.6, 0, 0}) <= 0);   // beyond the quarter of the side
}

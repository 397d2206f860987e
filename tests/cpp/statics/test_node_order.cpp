// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>

#include "catch.h"
#include "held_box.h"
#include "statics/earlier_nodes.h"
#include "statics/node_order.h"

using namespace featuremesh;

namespace {

/// How far apart the numbers of a tet's corners are, in the mean.
double mean_distance(const Mesh& mesh) {
    double sum = 0;
    for (const auto& tet : mesh.tets) {
        const auto [least, most] = std::minmax_element(tet.begin(), tet.end());
        sum += double(most->index() - least->index());
    }
    return sum / double(mesh.tets.size());
}

/// The same nodes in an order in which neighbours are far from one another.
Mesh shuffled(const Mesh& mesh) {
    const std::size_t count = mesh.corner_count, step = 7919;  // a prime
    Mesh other = mesh;
    const auto number = [&](NodeId node) { return NodeId(node.index() * step % count); };
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = number(NodeId(i)).index();
        other.points[at] = mesh.points[i], other.node_numbers[at] = mesh.node_numbers[i];
    }
    for (auto& tet : other.tets)
        for (NodeId& node : tet) node = number(node);
    return other;
}

}  // namespace

TEST_CASE("nodes along a curve have their neighbours near them, corners before the nodes between") {
    const Mesh mesh = shuffled(solved_box(12, 1));
    const OrderedModel ordered(free_model(mesh));
    CHECK(mean_distance(ordered.model().mesh) < 0.35 * mean_distance(mesh));

    const Mesh quadratic = solved_box(3, 2);
    std::vector<std::int32_t> order = order_along_curve(quadratic);
    const auto mids = order.begin() + std::ptrdiff_t(quadratic.corner_count);
    CHECK(*std::max_element(order.begin(), mids) + 1 == std::int32_t(quadratic.corner_count));
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i) CHECK(order[i] == std::int32_t(i));
}

TEST_CASE("a model in another order is the same, and what is found for it goes back to the nodes that were given") {
    const Mesh mesh = solved_box(3, 2, {1, 2, 3});
    StaticsModel given = free_model(mesh);
    for (std::size_t i = 0; i < given.loads.size(); ++i) {
        given.loads[i] = double(i);
        given.is_held[i] = i % 7 == 0;
        given.given[i] = given.is_held[i] ? 0.5 * double(i) : 0;
    }
    const OrderedModel ordered(given);
    const StaticsModel& model = ordered.model();
    CHECK(model.loads != given.loads);
    CHECK(ordered.as_given(model.loads) == given.loads);
    CHECK(ordered.as_given(model.is_held) == given.is_held);
    CHECK(ordered.as_given(model.given) == given.given);
    CHECK(ordered.as_given(model.mesh.node_numbers) == mesh.node_numbers);
    REQUIRE(model.mesh.tets.size() == mesh.tets.size());
    const auto are_same = [&](NodeId a, NodeId b) {
        return squared_length(model.mesh.point(a) - mesh.point(b)) == 0 &&
               model.mesh.node_numbers[a.index()] == mesh.node_numbers[b.index()];
    };
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        for (std::size_t i = 0; i < 4; ++i) CHECK(are_same(model.mesh.tets[t][i], mesh.tets[t][i]));
        for (std::size_t i = 0; i < 6; ++i) CHECK(are_same(model.mesh.tet_mids[t][i], mesh.tet_mids[t][i]));
    }
}

TEST_CASE("nodes that an edit keeps keep their order among one another") {
    const Mesh before = solved_box(6, 1);
    Mesh after = before;
    for (std::size_t i = 0; i < after.points.size(); ++i)
        if (after.entities[i].dim == 3 && i % 5 == 0) {
            after.points[i] += Vec3{0.01, 0.02, 0.01};
            after.node_numbers[i] = after.next_node_number++;
        }
    const auto kept = [&](const Mesh& mesh) {
        std::vector<Number> numbers;
        for (const std::int32_t node : order_along_curve(mesh)) {
            const Number number = mesh.node_numbers[std::size_t(node)];
            if (number < before.next_node_number && after.node_numbers[std::size_t(node)] == number)
                numbers.push_back(number);
        }
        return numbers;
    };
    CHECK(kept(after).size() > 100);
    CHECK(kept(after).size() < before.points.size());
    CHECK(kept(after) == kept(before));
}

TEST_CASE(
    "nodes are found by their numbers, near one another or far apart, unless others of their components are held") {
    for (const Number step : {Number(1), Number(1000)}) {
        const std::vector<Number> before{7 * step, 3 * step, 9 * step, -2 * step},
            now{9 * step, 8 * step, 7 * step, 3 * step, 10 * step};
        std::vector<std::int32_t> earlier = earlier_nodes(now, before);
        CHECK(earlier == std::vector<std::int32_t>{2, -1, 0, 1, -1});
        const std::vector<char> was_held{0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0},
            is_held{0, 0, 0, 1, 1, 1, 0, 0, 1, 1, 0, 1, 0, 0, 0};
        leave_alike_held(earlier, is_held, was_held);
        CHECK(earlier == std::vector<std::int32_t>{2, -1, 0, -1, -1});
    }
    CHECK(earlier_nodes(std::vector<Number>{1, 2}, {}) == std::vector<std::int32_t>{-1, -1});
}

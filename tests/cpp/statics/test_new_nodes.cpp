// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "catch.h"
#include "held_box.h"
#include "statics/new_nodes.h"
#include "statics/rigid_motions.h"

using namespace featuremesh;

namespace {

/// A box of 10-node tets.
struct BoxModel {
    Mesh mesh = solved_box(8, 2, {8, 2, 1});
    StaticsModel model = free_model(mesh);
    RunContext context;
    BlockMatrix matrix = assemble_stiffness(model, tets_of_nodes(mesh), context);

    std::vector<std::int32_t> nodes_within(double radius, const Vec3& centre) const {
        std::vector<std::int32_t> nodes;
        for (std::size_t i = 0; i < mesh.points.size(); ++i)
            if (distance(mesh.points[i], centre) < radius) nodes.push_back(std::int32_t(i));
        return nodes;
    }
};

Vec3 turned(const Vec3& p) { return Vec3{0.1, -0.2, 0.3} + cross(Vec3{0.02, 0.05, -0.01}, p); }
Vec3 shifted(const Vec3&) { return {-1, 2, 0.5}; }

}  // namespace

TEST_CASE("new nodes move as the kept ones beside them do, each group by itself, and held ones stay") {
    BoxModel box;
    const std::array<Vec3, 2> centres{{{1.5, 1, 0.5}, {6.5, 1, 0.5}}};
    std::vector<std::int32_t> fresh;
    for (const Vec3& centre : centres)
        for (const std::int32_t node : box.nodes_within(0.7, centre)) fresh.push_back(node);
    const auto should = [&](std::size_t node) {
        const Vec3& p = box.mesh.points[node];
        return p.x < 4 ? turned(p) : shifted(p);
    };
    std::vector<double> moved(3 * box.mesh.node_count());
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = should(i / 3)[int(i % 3)];
    for (const std::int32_t node : fresh)
        for (std::size_t c = 0; c < 3; ++c) moved[3 * std::size_t(node) + c] = 0;
    const auto held = 3 * std::size_t(fresh.front()) + 1;
    box.model.is_held[held] = 1;

    move_with_kept(box.model, box.matrix, fresh, moved);

    for (std::size_t i = 0; i < moved.size(); ++i) {
        INFO(i);
        CHECK(moved[i] == Approx(i == held ? 0 : should(i / 3)[int(i % 3)]).margin(1e-12));
    }
}

TEST_CASE("new nodes beside no kept one stay where they are") {
    BoxModel box;
    std::vector<std::int32_t> all = box.nodes_within(100, {});
    std::vector<double> moved(3 * all.size(), 0.0);
    move_with_kept(box.model, box.matrix, all, moved);
    CHECK(largest(moved) == 0);
}

TEST_CASE("layers of neighbours end where there are enough, or none is left") {
    const BoxModel box;
    const std::vector<std::int32_t> seed = box.nodes_within(0.3, {4, 1, 0.5});
    const std::size_t all = box.mesh.node_count();
    REQUIRE(!seed.empty());
    std::vector<std::int32_t> layers = seed;
    for (int count = 1; count <= 3; ++count) {
        layers = with_neighbours(layers, box.matrix);
        CHECK(std::is_sorted(layers.begin(), layers.end()));
        CHECK(with_neighbours(seed, box.matrix, count, all) == layers);
        CHECK(with_neighbours(seed, box.matrix, 100, layers.size()) == layers);
    }
    CHECK(with_neighbours(seed, box.matrix, 100, all + 1).size() == all);
}

TEST_CASE("rigid motions: those that points on a line cannot tell take no part") {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
    const RigidMotions motions(points);
    SixFactor::Square square{};
    RigidMotions::Six right{};
    for (const Vec3& p : points) {
        motions.add_force(turned(p), p, right);
        for (int axis = 0; axis < 3; ++axis) {
            const RigidMotions::Six along = motions.along(axis, p);
            for (std::size_t a = 0; a < along.size(); ++a)
                for (std::size_t b = 0; b < along.size(); ++b) square[a][b] += along[a] * along[b];
        }
    }
    const RigidMotions::Six by = SixFactor(square).solve(right);
    CHECK(by[3] == 0);  // about the line
    for (const Vec3& p : points) CHECK(distance(motions.moved(by, p), turned(p)) < 1e-12);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstring>
#include <map>
#include <utility>

#include "catch.h"
#include "held_box.h"
#include "statics/bodies.h"
#include "statics/elements.h"
#include "statics/same_rows.h"
#include "statics/stiffness.h"
#include "statics/stresses.h"

using namespace featuremesh;

namespace {

std::vector<double> field(const Mesh& mesh, const std::function<Vec3(const Vec3&)>& displacement) {
    std::vector<double> values;
    for (const Vec3& p : mesh.points) {
        const Vec3 u = displacement(p);
        values.insert(values.end(), {u.x, u.y, u.z});
    }
    return values;
}

std::vector<double> times(const BlockMatrix& matrix, const std::vector<double>& x) {
    std::vector<double> y(x.size(), 0.0);
    for (std::size_t node = 0; node < matrix.node_count(); ++node) {
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t k = 0; k < matrix.width(node); ++k)
                y[3 * node + r] += matrix.values[9 * matrix.begin(node) + r * matrix.width(node) + k] *
                                   x[3 * std::size_t(matrix.neighbours[matrix.begin(node) + k / 3]) + k % 3];
    }
    return y;
}

}  // namespace

TEST_CASE("shape functions sum to one and their gradients to nothing") {
    for (const int order : {1, 2}) {
        const Mesh mesh = solved_box(2, order);
        double volume = 0;
        for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) {
            with_element(mesh, tet, [&](const auto& element) {
                for (std::size_t p = 0; p < element.points.size(); ++p) {
                    const auto values = shape_values(int(element.nodes.size()), int(p));
                    Vec3 gradients;
                    double sum = 0;
                    for (std::size_t i = 0; i < element.nodes.size(); ++i)
                        sum += values[i], gradients += element.points[p].gradients[i];
                    CHECK(sum == Approx(1));
                    CHECK(length(gradients) < 1e-12);
                    volume += element.points[p].volume;
                }
            });
        }
        CHECK(volume == Approx(1));
    }
}

TEST_CASE("rigid motions give neither stress nor forces") {
    const Vec3 turn{0.3, -0.2, 0.5};
    for (const int order : {1, 2}) {
        const Mesh mesh = solved_box(3, order);
        const StaticsModel model = free_model(mesh);
        const TetsOfNodes around = tets_of_nodes(mesh);
        RunContext context;
        const auto moved = field(mesh, [&](const Vec3& p) { return Vec3{0.1, 0.2, -0.4} + cross(turn, p); });
        for (const Stress& stress :
             nodal_stresses(model, resistance_to(moved, model, around, context).inside, around, context))
            CHECK(von_mises(stress) < 1e-9 * steel.young);
        CHECK(largest(resistance_to(moved, model, around, context).forces) < 1e-10 * steel.young);
        CHECK(largest(times(assemble_stiffness(model, around, context), moved)) < 1e-10 * steel.young);
    }
}

TEST_CASE("the matrix does what the elements do, and is symmetric") {
    for (const int order : {1, 2}) {
        const Mesh mesh = solved_box(3, order);
        const StaticsModel model = free_model(mesh);
        const TetsOfNodes around = tets_of_nodes(mesh);
        RunContext context;
        const auto u = field(mesh, [](const Vec3& p) { return Vec3{p.x * p.y, std::sin(3 * p.z), p.x - p.y * p.y}; });
        const auto v = field(mesh, [](const Vec3& p) { return Vec3{p.z, p.x * p.x, std::cos(2 * p.y)}; });
        const BlockMatrix matrix = assemble_stiffness(model, around, context);
        const auto by_matrix = times(matrix, u), by_elements = resistance_to(u, model, around, context).forces;
        for (std::size_t i = 0; i < u.size(); ++i)
            CHECK(std::abs(by_matrix[i] - by_elements[i]) < 1e-10 * largest(by_elements));
        const auto other = times(matrix, v);
        double vKu = 0, uKv = 0;
        for (std::size_t i = 0; i < u.size(); ++i) vKu += v[i] * by_matrix[i], uKv += u[i] * other[i];
        CHECK(vKu == Approx(uKv));
    }
}

TEST_CASE("the matrix has the same bytes for any number of threads") {
    for (const int order : {1, 2}) {
        const Mesh mesh = solved_box(14, order);
        StaticsModel model = free_model(mesh);
        hold(model, [](const Vec3& p) { return p.x == 0; });
        const TetsOfNodes around = tets_of_nodes(mesh);
        RunContext one;
        const BlockMatrix expected = assemble_stiffness(model, around, one);
        for (const int threads : {2, 4}) {
            RunContext context;
            context.threads = threads;
            const BlockMatrix matrix = assemble_stiffness(model, around, context);
            CHECK(matrix.neighbours == expected.neighbours);
            REQUIRE(matrix.values.size() == expected.values.size());
            CHECK(std::memcmp(matrix.values.data(), expected.values.data(), 8 * matrix.values.size()) == 0);
        }
    }
}

TEST_CASE("boxes that touch along an edge only are two bodies") {
    Mesh mesh = box_mesh(1);
    const std::size_t tets = mesh.tets.size(), nodes = mesh.points.size();
    CHECK(bodies_of_tets(mesh) == std::vector<std::int32_t>(tets, 0));
    // The second box is the first one beyond its edge x = y = 1.
    std::vector<NodeId> twin;
    for (std::size_t i = 0; i < nodes; ++i) {
        const Vec3 p = mesh.points[i];
        NodeId same;
        for (std::size_t k = 0; k < nodes; ++k)
            if (mesh.points[k] == p + Vec3{1, 1, 0}) same = NodeId(k);
        twin.push_back(same.is_valid() ? same : mesh.add_node(p + Vec3{1, 1, 0}, {3, 1}));
    }
    for (std::size_t t = 0; t < tets; ++t) {
        auto tet = mesh.tets[t];
        for (NodeId& node : tet) node = twin[node.index()];
        mesh.add_tet(tet, SolidId(1));
    }
    std::vector<std::int32_t> expected(tets, 0);
    expected.resize(2 * tets, 1);
    CHECK(bodies_of_tets(mesh) == expected);
}

namespace {

/// By row and neighbour the values of a matrix, wherever they lie.
using Entries = std::map<std::pair<std::size_t, std::int32_t>, std::array<double, 9>>;

Entries entries_of(const BlockMatrix& matrix) {
    Entries entries;
    for (std::size_t node = 0; node < matrix.node_count(); ++node)
        for (std::size_t k = matrix.begin(node); k < matrix.end(node); ++k)
            for (std::size_t i = 0; i < 9; ++i)
                entries[{node, matrix.neighbours[k]}][i] =
                    matrix.values[matrix.place(node, k) + i / 3 * matrix.width(node) + i % 3];
    return entries;
}

/// Checks that the model's matrix has the same bytes with what is the same of an earlier one, copied or changed in
/// place. Returns how many rows are.
std::size_t rows_that_are_same(const StaticsModel& earlier, const StaticsModel& model) {
    RunContext context;
    const TetsOfNodes around_earlier = tets_of_nodes(earlier.mesh), around = tets_of_nodes(model.mesh);
    const BlockMatrix matrix = assemble_stiffness(earlier, around_earlier, context);
    const SameRows same = same_rows(model, around, earlier, around_earlier, context);
    const BlockMatrix expected = assemble_stiffness(model, around, context);
    const EarlierRows rows{matrix, same};
    const BlockMatrix copied = assemble_stiffness(model, around, context, &rows);
    CHECK(copied.begins == expected.begins);
    CHECK(copied.ends == expected.ends);
    CHECK(copied.neighbours == expected.neighbours);
    CHECK(std::memcmp(copied.values.data(), expected.values.data(), 8 * expected.values.size()) == 0);
    const auto change = [&](int threads) {
        RunContext with_threads;
        with_threads.threads = threads;
        return changed_stiffness(assemble_stiffness(earlier, around_earlier, with_threads), same, model, around,
                                 with_threads);
    };
    const BlockMatrix changed = change(1), threaded = change(3);
    CHECK(entries_of(changed) == entries_of(expected));
    CHECK(threaded.begins == changed.begins);
    CHECK(threaded.neighbours == changed.neighbours);
    CHECK(entries_of(threaded) == entries_of(changed));
    return std::size_t(std::count_if(same.row.begin(), same.row.end(), [](std::int32_t row) { return row >= 0; }));
}

/// The same mesh with its first node last, and all numbers as they were.
Mesh with_first_node_last(const Mesh& mesh) {
    Mesh turned = mesh;
    const auto n = std::int32_t(mesh.node_count());
    std::rotate(turned.points.begin(), turned.points.begin() + 1, turned.points.end());
    std::rotate(turned.node_numbers.begin(), turned.node_numbers.begin() + 1, turned.node_numbers.end());
    for (auto& tet : turned.tets)
        for (NodeId& node : tet) node.value = (node.value + n - 1) % n;
    return turned;
}

}  // namespace

TEST_CASE("rows of an earlier matrix are taken where nothing of them changed, and with the same bytes") {
    for (const int order : {1, 2}) {
        const Mesh mesh = solved_box(5, order);
        StaticsModel model = free_model(mesh);
        hold(model, [](const Vec3& p) { return p.x == 0; });
        CHECK(rows_that_are_same(model, model) == mesh.node_count());

        Mesh moved = mesh;
        const auto inner = std::size_t(
            std::find_if(mesh.entities.begin(), mesh.entities.end(), [](const auto& on) { return on.dim == 3; }) -
            mesh.entities.begin());
        moved.points[inner] += Vec3{0.01, 0, 0};
        StaticsModel with_moved = free_model(moved);
        with_moved.is_held = model.is_held;
        const std::size_t kept = rows_that_are_same(model, with_moved);
        CHECK(kept < mesh.node_count());
        CHECK(kept > mesh.node_count() / 2);

        StaticsModel freed = free_model(mesh);
        freed.is_held = model.is_held;
        freed.is_held[0] = !freed.is_held[0];
        CHECK(rows_that_are_same(model, freed) < mesh.node_count());

        StaticsModel soft = free_model(mesh, {70000, 0.3, 0});
        soft.is_held = model.is_held;
        CHECK(rows_that_are_same(model, soft) == 0);

        StaticsModel two = free_model(mesh);
        two.materials.push_back(steel);
        CHECK(rows_that_are_same(model, two) == 0);
        StaticsModel mixed = free_model(mesh);
        mixed.materials.push_back({70000, 0.3, 0}), two.materials = mixed.materials;
        mixed.tet_materials[0] = 1;
        const std::size_t of_mixed = rows_that_are_same(two, mixed);
        CHECK(of_mixed == mesh.node_count() - (order == 1 ? 4 : 10));
    }
    const Mesh mesh = solved_box(5, 1);
    const Mesh turned = with_first_node_last(mesh);
    // The first node's neighbours come in another order.
    CHECK(rows_that_are_same(free_model(mesh), free_model(turned)) == mesh.node_count());
}

TEST_CASE("a matrix is changed in place until its room ends, and has the same blocks as one that is assembled") {
    for (const int order : {1, 2}) {
        Mesh mesh = solved_box(6, order);
        RunContext context;
        const TetsOfNodes around = tets_of_nodes(mesh);
        BlockMatrix matrix = assemble_stiffness(free_model(mesh), around, context);
        std::size_t in_place = 0;
        bool is_put_together = false;
        for (int edit = 0; edit < 30 && !is_put_together; ++edit) {
            const Mesh before = mesh;
            const auto inner = std::size_t(
                std::find_if(mesh.entities.begin(), mesh.entities.end(), [](const auto& on) { return on.dim == 3; }) -
                mesh.entities.begin());
            mesh.points[inner + std::size_t(edit % 3)] += Vec3{0.001, 0, 0};
            const StaticsModel model = free_model(mesh);
            const SameRows same = same_rows(model, around, free_model(before), around, context);
            const double* values = matrix.values.data();
            matrix = changed_stiffness(std::move(matrix), same, model, around, context);
            CHECK(entries_of(matrix) == entries_of(assemble_stiffness(model, around, context)));
            is_put_together = matrix.blocks_before == 0;
            if (is_put_together) break;
            CHECK(matrix.values.data() == values);
            ++in_place;
        }
        CHECK(in_place >= 1);
        CHECK(is_put_together);
        CHECK(std::is_sorted(matrix.begins.begin(), matrix.begins.end()));
    }
}

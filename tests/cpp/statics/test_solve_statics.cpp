// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cstring>
#include <string_view>
#include <thread>

#include "catch.h"
#include "held_box.h"
#include "mesh/second_order.h"
#include "statics/loads.h"
#include "statics/solve_statics.h"

using namespace featuremesh;

namespace {

/// Tests that solve end here where the build has no PETSc; that it then says so is a test by itself.
#define NEEDS_SOLVER() \
    if (!has_linear_solver()) return

bool is_on_boundary(const Vec3& p) { return p.x == 0 || p.x == 1 || p.y == 0 || p.y == 1 || p.z == 0 || p.z == 1; }

StaticsSolution solved(const StaticsModel& model, int threads = 1) {
    RunContext context;
    context.threads = threads;
    return StaticsSolver().solve(model, context);
}

/// A bar along x, held at x = 0 and pulled down at its far end.
StaticsModel cantilever(const Mesh& mesh, double length, double force, double poisson = 0) {
    StaticsModel model = free_model(mesh, {210000, poisson, 0});
    hold(model, [](const Vec3& p) { return p.x == 0; });
    const auto shares = area_shares(mesh, triangles_of(mesh, 1));
    double area = 0;
    for (const double share : shares) area += share;
    for (std::size_t i = 0; i < shares.size(); ++i) model.loads[3 * i + 2] = -force * shares[i] / area;
    CHECK(length > 0);
    return model;
}

double deepest(const StaticsSolution& solution) {
    double most = 0;
    for (std::size_t i = 2; i < solution.displacements.size(); i += 3)
        most = std::max(most, -solution.displacements[i]);
    return most;
}

/// What was reused shows in no answer.
void check_as_fresh(const StaticsSolution& found, const StaticsSolution& fresh) {
    CHECK(found.energy_error <= StaticsSolver::tolerance);
    CHECK(found.strain_energy == Approx(fresh.strain_energy).epsilon(1e-7));
}

}  // namespace

TEST_CASE("without PETSc the message names the package") {
    if (has_linear_solver()) return;
    const Mesh mesh = solved_box(1, 1);
    REQUIRE_THROWS_AS(solved(free_model(mesh)), InputError);
}

TEST_CASE("patch test: a linear displacement of the boundary gives the same stress everywhere") {
    NEEDS_SOLVER();
    const auto linear = [](const Vec3& p) {
        return Vec3{1e-3 * p.x + 2e-4 * p.y, -3e-4 * p.y + 1e-4 * p.z, 5e-4 * p.z + 4e-4 * p.x};
    };
    const double shear = steel.shear_modulus(), mean = steel.lame_first() * (1e-3 - 3e-4 + 5e-4);
    const Stress expected{mean + 2 * shear * 1e-3,
                          mean - 2 * shear * 3e-4,
                          mean + 2 * shear * 5e-4,
                          shear * 2e-4,
                          shear * 1e-4,
                          shear * 4e-4};
    for (const int order : {1, 2}) {
        const Mesh mesh = solved_box(4, order);
        StaticsModel model = free_model(mesh);
        hold(model, is_on_boundary, linear);
        const StaticsSolution solution = solved(model);
        for (std::size_t i = 0; i < mesh.node_count(); ++i) {
            const double* u = solution.displacements.data() + 3 * i;
            CHECK(distance({u[0], u[1], u[2]}, linear(mesh.points[i])) < 3e-9);
            for (std::size_t k = 0; k < 6; ++k) CHECK(std::abs(solution.stresses[i][k] - expected[k]) < 3e-3);
        }
    }
}

TEST_CASE("a bar in tension: stress, reactions and strain energy are those of the textbook") {
    NEEDS_SOLVER();
    for (const int order : {1, 2}) {
        const Mesh mesh = solved_box(3, order, {100, 10, 10});
        StaticsModel model = free_model(mesh, {210000, 0.3, 0});
        for (std::size_t i = 0; i < mesh.node_count(); ++i)  // held so that it may grow thinner
            for (int c = 0; c < 3; ++c) model.is_held[3 * i + std::size_t(c)] = mesh.points[i][c] == 0;
        add_pressure(mesh, triangles_of(mesh, 1), -50, model.loads);
        const StaticsSolution solution = solved(model);
        for (const Stress& stress : solution.stresses) {
            CHECK(stress[0] == Approx(50).epsilon(3e-6));
            CHECK(std::abs(stress[1]) + std::abs(stress[3]) < 1e-3);
        }
        CHECK(distance(sum_of(solution.reactions), {-5000, 0, 0}) < 1e-6);
        CHECK(solution.strain_energy == Approx(0.5 * 50 * 50 / 210000.0 * 10000).epsilon(1e-6));
        CHECK(solution.energy_error <= StaticsSolver::tolerance);
        CHECK(solution.residual < 3e-5);
    }
}

TEST_CASE("a cantilever comes to the deflection of a beam with shear, and reactions balance its load") {
    NEEDS_SOLVER();
    const double length = 100, side = 10, force = 1000;
    const double beam = force * length * length * length / (3 * 210000 * side * side * side * side / 12) +
                        force * length / (5.0 / 6 * 105000 * side * side);
    double error_before = 1;
    for (const int n : {2, 4, 6}) {
        const Mesh mesh = solved_box(n, 2, {length, side, side});
        const StaticsSolution solution = solved(cantilever(mesh, length, force));
        const double error = std::abs(deepest(solution) / beam - 1);
        CHECK(error < error_before);
        error_before = error;
        CHECK(distance(sum_of(solution.reactions), {0, 0, force}) < 1e-10 * force);  // far below the tolerance
        Vec3 moment;
        for (std::size_t i = 0; i < mesh.node_count(); ++i) {
            const double* r = solution.reactions.data() + 3 * i;
            moment += cross(mesh.points[i], {r[0], r[1], r[2]});
        }
        CHECK(distance(moment, {force * side / 2, -force * length, 0}) < 1e-10 * force * length);
    }
    CHECK(error_before < 0.01);
}

TEST_CASE("the error of the mesh is that of its tets, whoever asks for it, and of the size of the true one") {
    NEEDS_SOLVER();
    const double length = 100, side = 10, force = 1000, young = 210000;
    const double beam = force * length * length * length / (3 * young * side * side * side * side / 12) +
                        force * length / (5.0 / 6 * young / 2 * side * side);
    for (const int order : {1, 2}) {
        const Mesh mesh = solved_box(4, order, {length, side, side});
        const StaticsModel model = cantilever(mesh, length, force);
        const StaticsSolution solution = solved(model);
        RunContext context;
        const DiscretisationError error = discretisation_error(model, solution.displacements, context);
        CHECK(error.whole == Approx(solution.discretisation_error).epsilon(1e-9));
        double sum = 0;
        for (const double of_tet : error.of_tets) sum += of_tet * of_tet;
        CHECK(std::sqrt(sum) == Approx(error.whole).epsilon(1e-12));
        const double of_energy = std::sqrt(1 - solution.strain_energy / (force * beam / 2));
        CHECK(error.whole / of_energy == Approx(0.95).margin(0.35));
    }
}

TEST_CASE("where materials meet stresses jump, and that is no error of the mesh") {
    NEEDS_SOLVER();
    for (const int order : {1, 2}) {
        Mesh mesh = box_mesh(4);
        mesh.order = order;
        if (order == 2) add_mid_side_nodes(mesh);
        StaticsModel model = free_model(mesh, {210000, 0, 0});
        model.materials.push_back({70000, 0, 0});
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            double height = 0;
            for (const NodeId n : mesh.tets[t]) height += mesh.points[n.index()].z / 4;
            model.tet_materials[t] = height > 0.5;
        }
        for (std::size_t n = 0; n < mesh.node_count(); ++n)
            if (is_on_boundary(mesh.points[n])) {
                for (std::size_t c = 0; c < 3; ++c) model.is_held[3 * n + c] = 1;
                model.given[3 * n] = 1e-3 * mesh.points[n].x;
            }
        const StaticsSolution solution = solved(model);
        CHECK(solution.strain_energy == Approx((210000 + 70000) / 4 * 1e-6).epsilon(1e-6));
        CHECK(solution.discretisation_error < 1e-5);
    }
}

TEST_CASE("self weight stretches a hanging bar by its own formula") {
    NEEDS_SOLVER();
    const double density = 7.85e-9, gravity = 9806, height = 100;
    const Mesh mesh = solved_box(4, 2, {10, 10, height});
    StaticsModel model = free_model(mesh, {210000, 0, density});
    hold(model, [&](const Vec3& p) { return p.z == height; });
    add_weight(mesh, model.materials, model.tet_materials, {0, 0, -gravity}, model.loads);
    const StaticsSolution solution = solved(model);
    CHECK(deepest(solution) == Approx(density * gravity * height * height / (2 * 210000)).epsilon(1e-5));
    // the supports carry what weighs on themselves, too
    CHECK(distance(sum_of(solution.reactions), {0, 0, density * gravity * 100 * height}) < 1e-9);
}

TEST_CASE("solutions have the same bytes for any number of threads") {
    NEEDS_SOLVER();
    for (const int order : {1, 2}) {
        const Mesh mesh = solved_box(order == 1 ? 12 : 6, order, {30, 10, 10});
        const StaticsModel model = cantilever(mesh, 30, 100, 0.3);
        const StaticsSolution expected = solved(model);
        for (const int threads : {2, 4}) {
            const StaticsSolution solution = solved(model, threads);
            REQUIRE(solution.displacements.size() == expected.displacements.size());
            CHECK(std::memcmp(solution.displacements.data(), expected.displacements.data(),
                              8 * expected.displacements.size()) == 0);
            CHECK(solution.stresses == expected.stresses);
        }
    }
}

TEST_CASE("10-node tets take hardly more iterations when there are more of them") {
    NEEDS_SOLVER();
    std::vector<int> iterations;
    for (const int n : {4, 8}) {
        const Mesh mesh = solved_box(n, 2, {30, 10, 10});
        iterations.push_back(solved(cantilever(mesh, 30, 100, 0.3)).iterations);
    }
    CHECK(iterations[1] <= 1.5 * iterations[0]);
    CHECK(iterations[1] <= 30);
}

TEST_CASE("what was kept changes the work, not the answer") {
    NEEDS_SOLVER();
    const int order = GENERATE(1, 2);
    const Mesh mesh = solved_box(order == 1 ? 10 : 6, order, {30, 10, 10});
    RunContext context;
    StaticsSolver solver;
    const StaticsSolution first = solver.solve(cantilever(mesh, 30, 100, 0.3), context);
    CHECK_FALSE(first.kept_preconditioner);

    Mesh edited = mesh;  // some nodes of the middle are others now, at other places
    for (std::size_t i = 0; i < edited.points.size(); ++i)
        if (edited.entities[i].dim == 3 && distance(edited.points[i], {15, 5, 5}) < 3.5) {
            edited.points[i] += Vec3{0.2, -0.1, 0.1};
            edited.node_numbers[i] = edited.next_node_number++;
        }
    CHECK(edited.next_node_number > mesh.next_node_number);
    const StaticsModel model = cantilever(edited, 30, 100, 0.3);
    const StaticsSolution kept = solver.solve(model, context), fresh = solved(model);
    CHECK(kept.kept_preconditioner);
    CHECK(kept.kept_start_share > 0.8);
    check_as_fresh(kept, fresh);
    for (std::size_t i = 0; i < kept.displacements.size(); ++i)
        CHECK(std::abs(kept.displacements[i] - fresh.displacements[i]) < 1e-6 * largest(fresh.displacements));

    const StaticsSolution again = solver.solve(model, context);
    CHECK(again.iterations == 0);  // it starts from its own solution

    StaticsModel softer = cantilever(edited, 30, 100, 0.3);
    softer.materials[0].young /= 100;
    CHECK_FALSE(solver.solve(softer, context).kept_preconditioner);
}

namespace {

/// Moves one inner node by so much, a new one now, the next one with each edit.
void move_inner_node(Mesh& mesh, int edit, const Vec3& by) {
    std::vector<std::size_t> inner;
    for (std::size_t i = 0; i < mesh.corner_count; ++i)
        if (mesh.entities[i].dim == 3) inner.push_back(i);
    const std::size_t node = inner[std::size_t(7 * edit) % inner.size()];
    mesh.points[node] += by;
    mesh.node_numbers[node] = mesh.next_node_number++;
    for (std::size_t tet = 0; mesh.order == 2 && tet < mesh.tets.size(); ++tet)
        for (std::size_t side = 0; side < tet_sides.size(); ++side) {
            const NodeId a = mesh.tets[tet][std::size_t(tet_sides[side][0])];
            const NodeId b = mesh.tets[tet][std::size_t(tet_sides[side][1])];
            if (a.index() == node || b.index() == node)
                mesh.points[mesh.tet_mids[tet][side].index()] = (mesh.point(a) + mesh.point(b)) / 2;
        }
}

}  // namespace

TEST_CASE("after many edits the solution is that of a fresh solve, and has the same bytes for any number of threads") {
    NEEDS_SOLVER();
    const int order = GENERATE(1, 2);
    Mesh mesh = solved_box(order == 1 ? 10 : 6, order, {30, 10, 10});
    RunContext context, with_threads;
    with_threads.threads = 3;
    StaticsSolver solver, threaded;
    solver.solve(cantilever(mesh, 30, 100, 0.3), context);
    threaded.solve(cantilever(mesh, 30, 100, 0.3), with_threads);
    int kept = 0;
    for (int edit = 0; edit < 12; ++edit) {
        move_inner_node(mesh, edit, {0.1, -0.05, 0.05});
        const StaticsModel model = cantilever(mesh, 30, 100, 0.3);
        const StaticsSolution found = solver.solve(model, context), other = threaded.solve(model, with_threads);
        const StaticsSolution fresh = solved(model);
        kept += found.kept_preconditioner;
        CHECK(found.displacements == other.displacements);
        check_as_fresh(found, fresh);
        for (std::size_t i = 0; i < found.displacements.size(); ++i)
            CHECK(std::abs(found.displacements[i] - fresh.displacements[i]) < 2e-6 * largest(fresh.displacements));
    }
    CHECK(kept >= 10);
}

TEST_CASE("after a small edit less than half of the iterations is left, under other loads, too") {
    NEEDS_SOLVER();
    const int order = GENERATE(1, 2);
    const Mesh mesh = solved_box(order == 1 ? 16 : 8, order, {30, 10, 10});
    Mesh edited = mesh;
    move_inner_node(edited, 3, {0.1, -0.05, 0.05});
    for (const double factor : {1.0, -2.5}) {
        RunContext context;
        StaticsSolver solver;
        solver.solve(cantilever(mesh, 30, 100, 0.3), context);
        const StaticsModel model = cantilever(edited, 30, 100 * factor, 0.3);
        const StaticsSolution found = solver.solve(model, context), fresh = solved(model);
        CHECK(found.kept_preconditioner);
        CHECK(2 * found.iterations < fresh.iterations);
        check_as_fresh(found, fresh);
    }
}

TEST_CASE("cancelled anywhere after an edit, the next solution is that of a fresh solve") {
    NEEDS_SOLVER();
    const int order = GENERATE(1, 2);
    const Mesh mesh = solved_box(order == 1 ? 6 : 3, order, {30, 10, 10});
    Mesh edited = mesh;
    move_inner_node(edited, 0, {0.1, -0.05, 0.05});
    const StaticsModel before = cantilever(mesh, 30, 100, 0.3), model = cantilever(edited, 30, 100, 0.3);
    const StaticsSolution fresh = solved(model);
    bool was_cancelled = true;
    for (int looks = 0; was_cancelled; ++looks) {
        RunContext context, cancelled;
        StaticsSolver solver;
        solver.solve(before, context);
        int left = looks;
        cancelled.on_progress = [&](std::string_view step, double) {
            std::this_thread::sleep_for(std::chrono::milliseconds(21));  // or the next look is left out
            return step == "solve" || step == "stresses" || left-- > 0;
        };
        try {
            solver.solve(model, cancelled);
            was_cancelled = false;
        } catch (const Cancelled&) {
            const StaticsSolution found = solver.solve(model, context);
            check_as_fresh(found, fresh);
        }
        REQUIRE((looks > 0 || was_cancelled));
    }
}

TEST_CASE("where an edit makes single tets stiff the smoothing that is carried over knows of them") {
    NEEDS_SOLVER();
    const Mesh mesh = solved_box(8, 2, {30, 10, 10});
    RunContext context;
    StaticsSolver solver;
    StaticsModel model = cantilever(mesh, 30, 100, 0.3);
    model.materials.push_back({210, 0.3, 0});
    std::fill(model.tet_materials.begin(), model.tet_materials.end(), 1);
    solver.solve(model, context);
    for (std::size_t i = 0; i < 24; ++i) model.tet_materials[100 + 97 * i] = 0;
    const StaticsSolution found = solver.solve(model, context), fresh = solved(model);
    CHECK(found.iterations <= 2 * fresh.iterations);  // 3.8 times with the bounds of before
    check_as_fresh(found, fresh);
}

TEST_CASE("new nodes start where they are balanced among the kept ones, or all start at rest") {
    NEEDS_SOLVER();
    const int order = GENERATE(1, 2);
    const Mesh mesh = solved_box(order == 1 ? 16 : 8, order, {30, 10, 10});
    RunContext context;
    for (const double radius : {4.8, 8.0}) {
        StaticsSolver solver;
        solver.solve(cantilever(mesh, 30, 100, 0.3), context);
        Mesh edited = mesh;
        for (std::size_t i = 0; i < edited.points.size(); ++i)
            if (edited.entities[i].dim == 3 && distance(edited.points[i], {20, 5, 5}) < radius)
                edited.node_numbers[i] = edited.next_node_number++;
        const double share = double(edited.next_node_number - mesh.next_node_number) / double(mesh.node_count());
        const StaticsModel model = cantilever(edited, 30, 100, 0.3);
        const StaticsSolution found = solver.solve(model, context), fresh = solved(model);
        CHECK_FALSE(found.kept_preconditioner);
        check_as_fresh(found, fresh);
        if (radius < 5) {
            CHECK(found.kept_start_share == Approx(1 - share));
            CHECK(found.iterations <= fresh.iterations / 2);  // nothing else than the numbers is new
        } else {
            CHECK(found.kept_start_share == 0);
            CHECK(found.iterations == fresh.iterations);
        }
    }
}

TEST_CASE("an earlier solution by node numbers is a start, whatever the loads were, and another problem's is none") {
    NEEDS_SOLVER();
    const int order = GENERATE(1, 2);
    const Mesh mesh = solved_box(order == 1 ? 10 : 6, order, {30, 10, 10});
    StaticsModel model = cantilever(mesh, 30, 100, 0.3);
    const StaticsSolution first = solved(model);
    RunContext context;
    for (const double factor : {1.0, -2.5}) {
        for (double& load : model.loads) load *= factor;
        StaticsSolver solver;
        solver.start_from(mesh.node_numbers, first.displacements);
        const StaticsSolution found = solver.solve(model, context);
        CHECK_FALSE(found.kept_preconditioner);
        CHECK(found.kept_start_share == 1);
        CHECK(found.iterations <= 1);
        CHECK(found.strain_energy == Approx(factor * factor * first.strain_energy).epsilon(1e-9));
    }
    StaticsSolver solver;
    std::vector<double> others = first.displacements;
    std::reverse(others.begin(), others.end());
    solver.start_from(mesh.node_numbers, others);
    const StaticsSolution found = solver.solve(model, context), fresh = solved(model);
    CHECK(found.kept_start_share == 0);
    CHECK(found.displacements == fresh.displacements);
    StaticsSolver with_gaps, without;
    std::vector<double> gaps = found.displacements;
    for (std::size_t i = 0; i < gaps.size(); i += 60) gaps[i] = std::nan("");
    with_gaps.start_from(mesh.node_numbers, gaps);
    CHECK(with_gaps.solve(model, context).kept_start_share == Approx(0.95).margin(0.01));
    gaps.assign(gaps.size(), 1e200);
    without.start_from(mesh.node_numbers, gaps);
    CHECK(without.solve(model, context).displacements == fresh.displacements);
    others.pop_back();
    REQUIRE_THROWS_AS(solver.start_from(mesh.node_numbers, others), InputError);
}

TEST_CASE("flat elements, on which aggregation is slow, are solved by a factor, and its reuse changes no answer") {
    NEEDS_SOLVER();
    const int order = GENERATE(1, 2);
    const double side = order == 1 ? 4000 : 10;
    const Mesh mesh = solved_box(order == 1 ? 10 : 6, order, {side, side, 1});
    RunContext context;
    StaticsSolver solver;
    StaticsModel model = cantilever(mesh, side, 2, 0.3);
    model.loads[3 * (mesh.corner_count - 1)] += 1;
    const StaticsSolution first = solver.solve(model, context);
    CHECK(first.iterations > (order == 1 ? 350 : 50));  // so many of aggregation, then those with the factor
    CHECK(first.iterations <= (order == 1 ? 400 : 200));
    CHECK(first.energy_error <= StaticsSolver::tolerance);

    for (double& load : model.loads) load *= 1.5;
    const StaticsSolution kept = solver.solve(model, context), fresh = solved(model);
    CHECK(kept.kept_preconditioner);
    CHECK(kept.iterations < fresh.iterations);
    CHECK(kept.strain_energy == Approx(fresh.strain_energy).epsilon(1e-6));
    const StaticsSolution threaded = solved(model, 4);
    CHECK(threaded.displacements == fresh.displacements);
    CHECK(threaded.stresses == fresh.stresses);
}

TEST_CASE("very flat 10-node tets are solved by a factor of their own matrix, which serves an edit, too") {
    NEEDS_SOLVER();
    const double length = 300, bend = 1e-4;  // a plate bent to an arc, which quadratic displacements give exactly
    const auto bent = [&](const Vec3& p) { return Vec3{-bend * p.x * p.z, 0, bend * p.x * p.x / 2}; };
    RunContext context, with_threads;
    with_threads.threads = 4;
    const auto model_of = [&](const Mesh& mesh) {
        StaticsModel model = free_model(mesh, {210000, 0, 0});
        std::vector<double> displacements;
        for (const Vec3& p : mesh.points)
            for (int c = 0; c < 3; ++c) displacements.push_back(bent(p)[c]);
        model.loads = resistance_to(displacements, model, tets_of_nodes(mesh), context).forces;
        hold(model, [&](const Vec3& p) { return p.x == 0; });
        return model;
    };
    const Mesh mesh = solved_box(4, 2, {length, length, 1});
    StaticsSolver solver, threaded;
    const StaticsSolution first = solver.solve(model_of(mesh), context);
    CHECK(first.preconditioned_by == PreconditionedBy::factor);
    CHECK(first.iterations < 300);  // not before it is clear that more would not do
    CHECK(first.energy_error <= StaticsSolver::tolerance);
    CHECK(first.displacements == threaded.solve(model_of(mesh), with_threads).displacements);
    for (std::size_t i = 0; i < mesh.node_count(); ++i)
        for (int c = 0; c < 3; ++c)
            CHECK(std::abs(first.displacements[3 * i + std::size_t(c)] - bent(mesh.points[i])[c]) <
                  1e-5 * largest(first.displacements));

    Mesh edited = mesh;
    move_inner_node(edited, 3, {1, -0.5, 0});
    for (std::size_t i = mesh.corner_count; i < mesh.node_count(); ++i)
        if (!(edited.points[i] == mesh.points[i])) edited.node_numbers[i] = edited.next_node_number++;
    StaticsModel later = model_of(edited);
    later.loads[3 * (mesh.corner_count / 2) + 2] += 0.1;
    const StaticsSolution found = solver.solve(later, context), fresh = solved(later);
    CHECK(found.kept_preconditioner);
    CHECK(found.preconditioned_by == PreconditionedBy::factor);
    CHECK(found.iterations <= 15);
    check_as_fresh(found, fresh);
    CHECK(found.displacements == threaded.solve(later, with_threads).displacements);
}

TEST_CASE("supports that are displaced leave the same share of the energy open as loads do") {
    NEEDS_SOLVER();
    const int order = GENERATE(1, 2);
    const double length = 300, bend = 1e-4;
    const Mesh mesh = solved_box(order == 1 ? 12 : 6, order, {length, length, 4});
    StaticsModel model = free_model(mesh, {210000, 0.3, 0});
    std::vector<double> bent;
    for (const Vec3& p : mesh.points) bent.insert(bent.end(), {-bend * p.x * p.z, 0, bend * p.x * p.x / 2});
    RunContext context;
    model.loads = resistance_to(bent, model, tets_of_nodes(mesh), context).forces;
    double twice_energy = 0;
    for (std::size_t i = 0; i < bent.size(); ++i) twice_energy += model.loads[i] * bent[i];
    const auto is_end = [&](const Vec3& p) { return p.x == 0 || p.x == length; };
    hold(model, is_end, [&](const Vec3& p) { return Vec3{-bend * p.x * p.z, 0, bend * p.x * p.x / 2}; });
    const StaticsSolution found = solved(model);
    CHECK(found.energy_error <= StaticsSolver::tolerance);
    CHECK(found.strain_energy == Approx(twice_energy / 2).epsilon(1e-6));
    std::vector<double> off = found.displacements;
    for (std::size_t i = 0; i < off.size(); ++i) off[i] -= bent[i];
    const std::vector<double> forces = resistance_to(off, model, tets_of_nodes(mesh), context).forces;
    double twice_energy_off = 0;
    for (std::size_t i = 0; i < off.size(); ++i) twice_energy_off += forces[i] * off[i];
    CHECK(std::sqrt(twice_energy_off / twice_energy) < 10 * StaticsSolver::tolerance);  // an estimate ends iterations
}

TEST_CASE("supports that move the part as a whole are followed without a stress") {
    NEEDS_SOLVER();
    const Mesh mesh = solved_box(6, 1, {300, 300, 4});
    StaticsModel model = free_model(mesh, {210000, 0.3, 0});
    const auto is_end = [](const Vec3& p) { return p.x == 0 || p.x == 300; };
    hold(model, is_end, [](const Vec3&) { return Vec3{0, 2, 0}; });
    const StaticsSolution found = solved(model);
    for (std::size_t i = 0; i < model.given.size(); ++i)
        CHECK(std::abs(found.displacements[i] - (i % 3 == 1 ? 2 : 0)) < 1e-5);
    CHECK(found.iterations < 150);  // rounding is not hunted for
}

TEST_CASE("a foil that rounding leaves no digits of ends with a sentence that names CalculiX, and spoils nothing") {
    NEEDS_SOLVER();
    const Mesh foil = solved_box(4, 2, {300, 300, 0.01}), mesh = solved_box(4, 2, {30, 10, 10});
    RunContext context;
    StaticsSolver solver;
    REQUIRE_THROWS_WITH(solver.solve(cantilever(foil, 300, 2, 0.3), context), Catch::Matchers::Contains("CalculiX"));
    REQUIRE_THROWS_AS(solver.solve(cantilever(foil, 300, 2, 0.3), context), KernelError);
    const StaticsModel model = cantilever(mesh, 30, 100, 0.3);
    const StaticsSolution found = solver.solve(model, context), fresh = solved(model);
    check_as_fresh(found, fresh);
}

TEST_CASE("impossible materials and numbers are refused") {
    const Mesh mesh = solved_box(1, 1);
    StaticsModel model = free_model(mesh, {210000, 0.5, 0});
    REQUIRE_THROWS_AS(check(model), InputError);
    model.materials[0] = {-1, 0.3, 0};
    REQUIRE_THROWS_AS(check(model), InputError);
    model.materials[0] = steel;
    model.loads[0] = std::nan("");
    REQUIRE_THROWS_AS(check(model), InputError);
}

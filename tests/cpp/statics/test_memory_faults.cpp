// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that ends in the middle of a solution: what C++ throws has to come out of PETSc's C code as an error.
#include <cstdlib>
#include <new>

#include "catch.h"
#include "held_box.h"
#include "statics/solve_statics.h"

// GCC sees `new` and this file's `delete` within one another and takes them for those of the library.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

using namespace featuremesh;

namespace {

constexpr std::size_t large = 4096;  // bytes; what is smaller is always there
thread_local long until_fault = -1;  // large pieces of memory; -1: no end

void* piece(std::size_t size) {
    if (size >= large && until_fault >= 0 && until_fault-- == 0) return nullptr;
    return std::malloc(size ? size : 1);
}

}  // namespace

void* operator new(std::size_t size) {
    void* found = piece(size);
    if (!found) throw std::bad_alloc();
    return found;
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return piece(size); }
void operator delete(void* at) noexcept { std::free(at); }
void operator delete(void* at, std::size_t) noexcept { std::free(at); }

TEST_CASE("memory that ends in the middle of a solution is an error, and the next solution is as ever") {
    if (!has_linear_solver()) return;
    const int order = GENERATE(1, 2);
    const Mesh mesh = solved_box(6, order, {30, 10, 10});
    StaticsModel model = free_model(mesh);
    hold(model, [](const Vec3& p) { return p.x == 0; });
    for (std::size_t i = 0; i < mesh.node_count(); ++i) model.loads[3 * i + 2] = -1;
    RunContext context;
    const StaticsSolution whole = StaticsSolver().solve(model, context);
    int faults = 0;
    for (long step = 1, at = 0;; at += step, step = 1 + at / 20) {
        StaticsSolver solver;
        bool is_fault = false;
        until_fault = at;
        try {
            solver.solve(model, context);
        } catch (const std::bad_alloc&) {
            is_fault = true;
        } catch (const KernelError&) {
            is_fault = true;
        }
        const bool is_over = until_fault >= 0;
        until_fault = -1;
        if (is_over) break;
        CHECK(is_fault);
        ++faults;
        solver.forget();
        CHECK(solver.solve(model, context).displacements == whole.displacements);
    }
    CHECK(faults > 20);
}

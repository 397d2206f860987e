// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind_statics.h"

#include <chrono>
#include <map>
#include <mutex>

#include "core/errors.h"
#include "core/messages.h"
#include "statics/bodies.h"
#include "statics/loads.h"
#include "statics/solve_statics.h"

namespace featuremesh {

namespace {

using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;

template <class Value>
py::array_t<Value> array_of(const std::vector<Value>& values, std::vector<py::ssize_t> shape) {
    return py::array_t<Value>(std::move(shape), values.data());
}

Indices indices_from(const py::handle& given) {
    Indices indices = Indices::ensure(given);
    if (!indices || !has_values_of(indices, given))
        throw InputError(say<Code::wrong_call>("Indices are whole numbers below 2^31."));
    return indices;
}

std::span<const std::int32_t> checked(const Indices& rows, std::size_t count) {
    const std::span<const std::int32_t> all(rows.data(), std::size_t(rows.size()));
    for (const std::int32_t row : all)
        if (row < 0 || std::size_t(row) >= count)
            throw InputError(say<Code::wrong_call>("There is no element of that index in the mesh."));
    return all;
}

std::vector<Material> materials_from(const Rows& rows) {
    if (rows.ndim() != 2 || rows.shape(1) != 3)
        throw InputError(say<Code::wrong_call>("Materials are rows of E, Poisson's ratio, density."));
    std::vector<Material> materials;
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) materials.push_back({rows.at(i, 0), rows.at(i, 1), rows.at(i, 2)});
    return materials;
}

template <class Value, class Array>
std::vector<Value> values_of(const Array& array) {
    return std::vector<Value>(array.data(), array.data() + array.size());
}

Rows weight(const py::dict& arrays, const Rows& materials, const py::object& tet_materials,
            const std::array<double, 3>& gravity) {
    const Mesh mesh = mesh_from(arrays);
    const auto known = materials_from(materials);
    const Indices rows = indices_from(tet_materials);
    const auto of_tets = checked(rows, known.size());
    if (of_tets.size() != mesh.tets.size()) throw InputError(say<Code::wrong_call>("Every element needs a material."));
    std::vector<double> loads(3 * mesh.node_count(), 0.0);
    run_released({}, 1, [&](RunContext&) {
        add_weight(mesh, known, of_tets, {gravity[0], gravity[1], gravity[2]}, loads);
    });
    return array_of(loads, {py::ssize_t(mesh.node_count()), 3});
}

Rows pressure(const py::dict& arrays, const py::object& triangles, double value) {
    const Mesh mesh = mesh_from(arrays);
    std::vector<double> loads(3 * mesh.node_count(), 0.0);
    add_pressure(mesh, checked(indices_from(triangles), mesh.triangles.size()), value, loads);
    return array_of(loads, {py::ssize_t(mesh.node_count()), 3});
}

Rows shares_of_area(const py::dict& arrays, const py::object& triangles) {
    const Mesh mesh = mesh_from(arrays);
    return array_of(area_shares(mesh, checked(indices_from(triangles), mesh.triangles.size())),
                    {py::ssize_t(mesh.node_count())});
}

Rows shares_of_length(const py::dict& arrays, const py::object& segments) {
    const Mesh mesh = mesh_from(arrays);
    return array_of(length_shares(mesh, checked(indices_from(segments), mesh.segments.size())),
                    {py::ssize_t(mesh.node_count())});
}

Indices bodies(const py::dict& arrays) {
    const Mesh mesh = mesh_from(arrays);
    return array_of(run_released({}, 1, [&](RunContext&) { return bodies_of_tets(mesh); }),
                    {py::ssize_t(mesh.tets.size())});
}

const char* name_of(PreconditionedBy by) {
    switch (by) {
        case PreconditionedBy::linear_factor:
            return "factor of linear displacements";
        case PreconditionedBy::factor:
            return "factor";
        default:
            return "aggregation";
    }
}

py::dict to_dict(const StaticsSolution& solution, const std::map<std::string, double>& seconds) {
    const auto n = py::ssize_t(solution.stresses.size());
    std::vector<double> mises;
    for (const Stress& stress : solution.stresses) mises.push_back(von_mises(stress));
    py::dict out;
    out["displacements"] = array_of(solution.displacements, {n, 3});
    out["stresses"] =
        py::array_t<double>({n, py::ssize_t(6)}, solution.stresses.empty() ? nullptr : solution.stresses[0].data());
    out["von_mises"] = array_of(mises, {n});
    out["reactions"] = array_of(solution.reactions, {n, 3});
    out["strain_energy"] = solution.strain_energy;
    out["iterations"] = solution.iterations;
    out["residual"] = solution.residual;
    out["energy_error"] = solution.energy_error;
    out["discretisation_error"] = solution.discretisation_error;
    out["preconditioner"] = name_of(solution.preconditioned_by);
    out["kept_preconditioner"] = solution.kept_preconditioner;
    out["kept_start_share"] = solution.kept_start_share;
    out["seconds"] = seconds;
    return out;
}

/// PETSc serves one thread at a time, whichever solver is whose: who starts it, solves or frees takes this.
std::timed_mutex petsc_mutex;
std::map<std::string, StaticsSolver> kept_solvers;  ///< between calls, by the caller's key

/// Throws Cancelled when the caller no longer wants to wait.
std::unique_lock<std::timed_mutex> wait_for_petsc(RunContext& context) {
    std::unique_lock lock(petsc_mutex, std::defer_lock);
    while (!lock.try_lock_for(std::chrono::milliseconds(50))) context.check_cancelled();
    return lock;
}

/// Python goes on while this waits for a solution under way, which may ask it for its progress.
void forget(const std::string& key) {
    const py::gil_scoped_release release;
    const std::lock_guard lock(petsc_mutex);
    kept_solvers.erase(key);
}

using Numbers = py::array_t<Number, py::array::c_style | py::array::forcecast>;

/// An earlier solution's displacements by node number.
struct EarlierSolution {
    std::vector<Number> numbers;
    std::vector<double> displacements;

    explicit EarlierSolution(const std::optional<std::pair<Numbers, Rows>>& given) {
        if (given) numbers = values_of<Number>(given->first), displacements = values_of<double>(given->second);
    }
};

py::dict solve(const py::dict& arrays, const py::dict& given, const std::string& keep, int threads,
               const Progress& progress, const std::optional<std::pair<Numbers, Rows>>& start) {
    const Mesh mesh = mesh_from(arrays);
    const auto held = given["held"].cast<py::array_t<bool, py::array::c_style | py::array::forcecast>>();
    const StaticsModel model{mesh,
                             materials_from(given["materials"].cast<Rows>()),
                             values_of<std::int32_t>(indices_from(given["tet_materials"])),
                             values_of<double>(given["loads"].cast<Rows>()),
                             std::vector<char>(held.data(), held.data() + held.size()),
                             values_of<double>(given["given"].cast<Rows>())};
    const EarlierSolution earlier(start);
    std::map<std::string, double> seconds;
    const StaticsSolution solution = run_released(progress, threads, [&](RunContext& context) {
        const auto lock = wait_for_petsc(context);
        StaticsSolver for_this_call;
        StaticsSolver& solver = keep.empty() ? for_this_call : kept_solvers[keep];
        try {
            solver.start_from(earlier.numbers, earlier.displacements);
            StaticsSolution found = solver.solve(model, context);
            seconds = context.seconds();
            return found;
        } catch (const Cancelled&) {  // what it had set up by then serves the next one
            throw;
        } catch (...) {
            solver.forget();
            throw;
        }
    });
    return to_dict(solution, seconds);
}

py::array_t<double> error_of_tets(const py::dict& arrays, const Rows& materials, const py::object& tet_materials,
                                  const Rows& displacements, int threads) {
    const Mesh mesh = mesh_from(arrays);
    const std::size_t n = 3 * mesh.node_count();
    const StaticsModel model{mesh,
                             materials_from(materials),
                             values_of<std::int32_t>(indices_from(tet_materials)),
                             std::vector<double>(n, 0.0),
                             std::vector<char>(n, 1),
                             values_of<double>(displacements)};
    check(model);
    const auto of_tets = [&](RunContext& context) { return discretisation_error(model, model.given, context).of_tets; };
    return array_of(run_released({}, threads, of_tets), {py::ssize_t(mesh.tets.size())});
}

std::string missing_solver() {
    std::string reason;
    return has_linear_solver(&reason) ? std::string() : reason;
}

}  // namespace

void define_statics(py::module_& module) {
    module.def("statics_missing", &missing_solver, "Why linear statics cannot be solved here; empty when it can.");
    module.def("statics_weight", &weight, py::arg("arrays"), py::arg("materials"), py::arg("tet_materials"),
               py::arg("gravity"), "(n,3) N: the weight of all tets; gravity in mm/s^2.");
    module.def("statics_pressure", &pressure, py::arg("arrays"), py::arg("triangles"), py::arg("pressure"),
               "(n,3) N: a pressure, MPa, against those triangles.");
    module.def("statics_area_shares", &shares_of_area, py::arg("arrays"), py::arg("triangles"),
               "(n,) mm^2: each node's part of the triangles' area where a force is spread over them.");
    module.def("statics_length_shares", &shares_of_length, py::arg("arrays"), py::arg("segments"),
               "(n,) mm: each node's part of the segments' length.");
    module.def("statics_bodies", &bodies, py::arg("arrays"),
               "(m,) by tet the body that it belongs to: tets that hang together by their sides.");
    module.def("solve_statics", &solve, py::arg("arrays"), py::arg("model"), py::arg("keep") = "",
               py::arg("threads") = 1, py::arg("progress") = py::none(), py::arg("start") = py::none(),
               "Solves linear statics. What is kept under the name `keep` makes the next solution of that name faster. "
               "Where nothing is, `start` may be (node_numbers (n,), displacements (n,3) mm) of an earlier one.");
    module.def("statics_error", &error_of_tets, py::arg("arrays"), py::arg("materials"), py::arg("tet_materials"),
               py::arg("displacements"), py::arg("threads") = 1,
               "(m,) by tet its part of the discretisation error; the sum of their squares is its square.");
    module.def("forget_statics", &forget, py::arg("keep"), "Frees what is kept under that name.");
}

}  // namespace featuremesh

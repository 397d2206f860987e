// SPDX-License-Identifier: GPL-3.0-or-later
// What the binding files share: one define function per module, and the dict forms described in featuremesh_engine.pyi.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/callers_progress.h"
#include "core/errors.h"
#include "update/part_mesh.h"

namespace featuremesh {

namespace py = pybind11;

void define_about(py::module_& module);
void define_errors(py::module_& module);
void define_features(py::module_& module);
void define_difference(py::module_& module);
void define_mesh(py::module_& module);
void define_messages(py::module_& module);
void define_update(py::module_& module);

RawDocument raw_document_from(const py::dict& raw);
py::dict to_dict(const FeatureDifference& difference);
/// {"code", "template", "parameters": {name: value}}; None where there is nothing to say.
py::object to_python(const Message& message);
py::list to_list(const std::vector<Message>& messages);
/// ["Face12", ...]
py::list names_of_entities(const std::vector<Entity>& entities);
/// Throws InputError for what is no name of an entity.
std::vector<Entity> entities_from(const std::vector<std::string>& names);
py::dict arrays_of(const Mesh& mesh, const py::object& owner);
Mesh mesh_from(const py::dict& arrays);
/// The lengths that kept nodes were made for.
MadeFor made_for_from(const py::dict& arrays);
std::vector<SizeSource> adopted_sizes_from(const py::dict& arrays);
/// The options with what the mesh of the arrays was made with rather than asked for.
MeshOptions options_made_with(const py::dict& arrays, MeshOptions asked);
py::object motion_matrix(const RigidMotion& motion);

/// Has the array the values that were given? Numbers that are no whole ones, or too large for it, were changed.
template <class Scalar, int flags>
bool has_values_of(const py::array_t<Scalar, flags>& array, const py::handle& given) {
    if constexpr (!std::is_integral_v<Scalar>) return true;
    const auto original = py::array::ensure(given);
    return original.dtype().equal(array.dtype()) ||
           py::module_::import("numpy").attr("array_equal")(array, original).template cast<bool>();
}

using Progress = std::optional<py::function>;
/// More than any machine has: oneTBB makes room for all that are asked for.
constexpr int most_threads = 1024;

/// Runs engine work without the GIL, with the caller's progress function. What that raises ends the work, and is
/// raised.
template <class Work>
auto run_released(const Progress& progress, int threads, Work work) {
    RunContext context;
    context.threads = std::min(threads, most_threads);
    std::function<bool(std::string_view, double)> ask;
    if (progress)
        ask = [&](std::string_view step, double share) {
            const py::gil_scoped_acquire gil;
            return (*progress)(std::string(step), share).template cast<bool>();
        };
    CallersProgress asked(context, std::move(ask));
    const py::gil_scoped_release released;
    return asked.run([&] { return work(context); });
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include <Standard_Failure.hxx>

#include "bindings.h"
#include "core/activity.h"
#include "core/errors.h"
#include "core/messages.h"

namespace featuremesh {

namespace {

/// The Python error says the message in English and has it as `message`.
void raise(const py::object& type, const Message& message) {
    const py::object error = type(message.in_english());
    error.attr("message") = to_python(message);
    PyErr_SetObject(type.ptr(), error.ptr());
}

}  // namespace

void define_errors(py::module_& module) {
    static py::exception<Error> error(module, "Error", PyExc_RuntimeError);
    static py::exception<InputError> input(module, "InputError", error.ptr());
    static py::exception<KernelError> kernel(module, "KernelError", error.ptr());
    static py::exception<MeshError> mesh(module, "MeshError", error.ptr());
    static py::exception<StateError> state(module, "StateError", error.ptr());
    static py::exception<Cancelled> cancelled(module, "Cancelled", error.ptr());
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const InputError& e) {
            raise(input, e.message);
        } catch (const KernelError& e) {
            raise(kernel, e.message);
        } catch (const MeshError& e) {
            raise(mesh, e.message);
        } catch (const StateError& e) {
            raise(state, e.message);
        } catch (const Cancelled& e) {
            raise(cancelled, e.message);
        } catch (const Error& e) {
            raise(error, e.message);
        } catch (const Standard_Failure& e) {
            const std::string why = std::string(e.DynamicType()->Name()) + " " + e.GetMessageString();
            raise(kernel, say<Code::kernel_failed>(why));
        }
    });
    module.def("write_activity_of_crash_to", &write_activity_of_crash_to, py::arg("descriptor"),
               "From now on a crash first writes what its thread was working on (\"surface, Face12\") to the file "
               "descriptor.");
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include <Standard_Failure.hxx>

#include "bindings.h"
#include "core/activity.h"
#include "core/errors.h"

namespace featuremesh {

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
            PyErr_SetString(input.ptr(), e.what());
        } catch (const KernelError& e) {
            PyErr_SetString(kernel.ptr(), e.what());
        } catch (const MeshError& e) {
            PyErr_SetString(mesh.ptr(), e.what());
        } catch (const StateError& e) {
            PyErr_SetString(state.ptr(), e.what());
        } catch (const Cancelled& e) {
            PyErr_SetString(cancelled.ptr(), e.what());
        } catch (const Error& e) {
            PyErr_SetString(error.ptr(), e.what());
        } catch (const Standard_Failure& e) {
            const std::string message =
                std::string("The geometry kernel failed: ") + e.DynamicType()->Name() + " " + e.GetMessageString();
            PyErr_SetString(kernel.ptr(), message.c_str());
        }
    });
    module.def("write_activity_of_crash_to", &write_activity_of_crash_to, py::arg("descriptor"),
               "From now on a crash first writes what its thread was working on (\"surface, Face12\") to the file "
               "descriptor.");
}

}  // namespace featuremesh

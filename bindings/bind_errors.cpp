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
            input(e.what());
        } catch (const KernelError& e) {
            kernel(e.what());
        } catch (const MeshError& e) {
            mesh(e.what());
        } catch (const StateError& e) {
            state(e.what());
        } catch (const Cancelled& e) {
            cancelled(e.what());
        } catch (const Error& e) {
            error(e.what());
        } catch (const Standard_Failure& e) {
            kernel((std::string("The geometry kernel failed: ") + e.DynamicType()->Name() + " " + e.GetMessageString()).c_str());
        }
    });
    module.def("write_activity_of_crash_to", &write_activity_of_crash_to, py::arg("descriptor"),
               "From now on a crash first writes what its thread was working on (\"surface, Face12\") to the file descriptor.");
}

}  // namespace featuremesh

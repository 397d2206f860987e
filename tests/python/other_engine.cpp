// SPDX-License-Identifier: GPL-3.0-or-later
// An engine that speaks another protocol, for test_engine.py: it can say so, and nothing else.
#include <pybind11/pybind11.h>

namespace py = pybind11;

PYBIND11_MODULE(featuremesh_engine, module) {
    module.def("about",
               [] { return py::dict(py::arg("version") = OTHER_VERSION, py::arg("protocol") = OTHER_PROTOCOL); });
    module.attr("PartMesh") = py::none();
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/version.h>
#include <tbb/version.h>

#include <Standard_Version.hxx>

#include "bindings.h"

namespace featuremesh {

namespace {

#define FEATUREMESH_TEXT(x) #x
#define FEATUREMESH_TEXT_OF(x) FEATUREMESH_TEXT(x)

/// Of this interface. An addon says which numbers it can speak; a change that an older addon cannot understand counts
/// it up.
constexpr int protocol = 4;

py::dict about() {
    using namespace py::literals;
    return py::dict("version"_a = FEATUREMESH_VERSION, "protocol"_a = protocol, "occt"_a = OCC_VERSION_COMPLETE,
                    "cgal"_a = FEATUREMESH_TEXT_OF(CGAL_VERSION), "tbb"_a = TBB_runtime_version());
}

}  // namespace

void define_about(py::module_& module) {
    module.attr("__version__") = FEATUREMESH_VERSION;
    module.attr("protocol") = protocol;
    module.def("about", &about, "Versions of the engine, of this interface and of the engine's libraries.");
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind_statics.h"
#include "bindings.h"

PYBIND11_MODULE(featuremesh_engine, module) {
    using namespace featuremesh;
    module.doc() =
        "FeatureMesh's engine: cellular model, feature difference and local variational tetrahedral meshing.";
    define_about(module);
    define_errors(module);
    define_features(module);
    define_difference(module);
    define_mesh(module);
    define_messages(module);
    define_update(module);
    define_statics(module);
}

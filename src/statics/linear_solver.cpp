// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics/linear_solver.h"

#include <dlfcn.h>

#include "core/errors.h"
#include "core/messages.h"

namespace featuremesh {

namespace {

using Make = LinearSolver* (*)();

struct Library {
    Make make = nullptr;
    std::string reason;
};

/// Looked for beside the library that this is part of (its RUNPATH).
const Library& petsc() {
    static const Library library = [] {
        Library found;
        void* handle = dlopen("featuremesh_petsc.so", RTLD_NOW | RTLD_LOCAL);
        if (handle) found.make = reinterpret_cast<Make>(dlsym(handle, "featuremesh_make_petsc_solver"));
        if (!found.make) {
            const char* said = dlerror();
            found.reason = said ? said : "it holds no solver";
        }
        return found;
    }();
    return library;
}

}  // namespace

bool has_linear_solver(std::string* reason) {
    if (reason) *reason = petsc().reason;
    return petsc().make != nullptr;
}

std::unique_ptr<LinearSolver> make_linear_solver() {
    if (!petsc().make) throw InputError(say<Code::no_petsc>(petsc().reason));
    return std::unique_ptr<LinearSolver>(petsc().make());
}

}  // namespace featuremesh

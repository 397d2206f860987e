// SPDX-License-Identifier: GPL-3.0-or-later
// PETSc's objects with owners, and its errors as ours. Only petsc_*.h and petsc_solver.cpp know PETSc.
#pragma once

#include <new>
#include <utility>

#include "core/errors.h"
#include "core/messages.h"
#include "statics/petsc_headers.h"

namespace featuremesh {

inline void check(PetscErrorCode code) {
    if (!code) return;
    const char* text = nullptr;
    PetscErrorMessage(code, &text, nullptr);
    throw KernelError(say<Code::petsc_failed>(text ? text : "unknown error"));
}

/// An object of PETSc that is destroyed with this one.
template <class Object, PetscErrorCode (*destroy)(Object*)>
class Owned {
  public:
    Owned() = default;
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;
    ~Owned() { reset(); }
    void reset() {
        if (object_) destroy(&object_);
        object_ = nullptr;
    }
    /// Leaves the object to itself: what an error has interrupted PETSc may not be able to destroy.
    void abandon() { object_ = nullptr; }
    Object* fresh() {
        reset();
        return &object_;
    }
    operator Object() const { return object_; }
    friend void swap(Owned& a, Owned& b) { std::swap(a.object_, b.object_); }

  private:
    Object object_ = nullptr;
};
using Matrix = Owned<Mat, MatDestroy>;
using Vector = Owned<Vec, VecDestroy>;
using Preconditioner = Owned<PC, PCDestroy>;

/// Calls work that may throw from C code, which no exception may cross: memory that is not there is an error, too.
template <class Work>
PetscErrorCode guarded(const Work& work) noexcept {
    try {
        work();
    } catch (const std::bad_alloc&) {
        return PetscErrorCode(PETSC_ERR_MEM);
    } catch (...) {
        return PetscErrorCode(PETSC_ERR_LIB);
    }
    return PetscErrorCode(0);
}

/// Makes `preconditioner` one that does what `by.apply(in, out)` does.
template <class By>
void use_shell(PC preconditioner, By& by) {
    check(PCSetType(preconditioner, PCSHELL));
    check(PCShellSetContext(preconditioner, &by));
    check(PCShellSetApply(preconditioner, [](PC pc, Vec in, Vec out) -> PetscErrorCode {
        void* self = nullptr;
        PetscCall(PCShellGetContext(pc, &self));
        return guarded([&] { static_cast<By*>(self)->apply(in, out); });
    }));
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// What the libraries throw becomes one of our errors.
#pragma once

#include <Standard_Failure.hxx>
#include <new>
#include <string>

#include "core/errors.h"
#include "core/message.h"
#include "core/messages.h"

namespace featuremesh {

/// Whether work failed for want of time or memory. That says nothing of the part: no other mesh is made because a
/// machine is slow or small.
inline bool is_of_machine(const Error& failure) {
    const Code code = failure.message.code();
    return code == Code::out_of_memory || code == Code::step_does_not_end || code == Code::step_was_ended;
}

template <class Function>
auto with_our_errors(Function work) {
    const auto first_line = [](const char* text) { return std::string(text).substr(0, std::string(text).find('\n')); };
    try {
        return work();
    } catch (const Error&) {
        throw;
    } catch (const Standard_Failure& failure) {
        throw KernelError(say<Code::kernel_failed_meshing>(first_line(failure.GetMessageString())));
    } catch (const std::bad_alloc&) {
        throw MeshError(say<Code::out_of_memory>());
    } catch (const std::exception& failure) {
        throw MeshError(say<Code::part_not_filled>(first_line(failure.what())));
    }
}

/// Why work failed for a reason that lies in the part; empty where it did not. All else is thrown.
template <class Function>
Message why_failed(Function work) {
    try {
        with_our_errors(work);
        return {};
    } catch (const Cancelled&) {
        throw;
    } catch (const Error& failure) {
        if (is_of_machine(failure)) throw;
        return failure.message;
    }
}

}  // namespace featuremesh

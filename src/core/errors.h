// SPDX-License-Identifier: GPL-3.0-or-later
// The few ways in which work ends early. A message says what, where (names the user sees) and what to try.
#pragma once

#include <stdexcept>
#include <utility>

#include "core/message.h"

namespace featuremesh {

/// Base of all errors of the engine; what() is the message in English.
struct Error : std::runtime_error {
    explicit Error(Message said) : std::runtime_error(said.in_english()), message(std::move(said)) {}
    Message message;
};
/// The caller's fault: a wrong size, an open shape, an unknown name.
struct InputError : Error {
    using Error::Error;
};
/// The geometry kernel could not do what was asked of it.
struct KernelError : Error {
    using Error::Error;
};
/// No valid mesh could be made.
struct MeshError : Error {
    using Error::Error;
};
/// A saved state is damaged, foreign or from a newer schema.
struct StateError : Error {
    using Error::Error;
};
/// The user cancelled.
struct Cancelled : Error {
    Cancelled();
};

}  // namespace featuremesh

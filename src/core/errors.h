// SPDX-License-Identifier: GPL-3.0-or-later
// The few ways in which work ends early. A message says what, where (names the user sees) and what to try.
#pragma once

#include <stdexcept>
#include <string>

namespace featuremesh {

/// Base of all errors of the engine.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
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
    Cancelled() : Error("cancelled") {}
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>

#include "core/geometry.h"
#include "mesh/mesh.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// The wanted edge length, mm, as a function; what the filling knows of the sizing field.
struct WantedSize {
    std::function<double(const Vec3&)> at;
    double largest = 0;
    bool is_uniform = true;
    /// About the largest. A graded lattice has this size, halved again and again, so that where most of a part wants
    /// one size the lattice should come to just that, not to up to 1.4 times more or less.
    double root = largest;
    /// Over a way the size changes by no more than this times the way; unknown where it is infinite.
    double slope = std::numeric_limits<double>::infinity();
};

/// Keeps a reference to the field. The root is what the triangles of the surface want, doubled or halved, in the mean.
WantedSize wanted_size(const SizingField& sizing, const Mesh& surface);

}  // namespace featuremesh

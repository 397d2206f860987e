// SPDX-License-Identifier: GPL-3.0-or-later
// The mechanism of improvement as the tests call it.
#pragma once

#include "volume/improvement/improve.h"
#include "volume/improvement/operations.h"
#include "volume/tets/box_of_tets.h"

namespace featuremesh {

inline Objective objective_for(double target_deg, double least_volume = 0, double poor_shape = 0) {
    return Objective({.target_dihedral_deg = target_deg, .least_volume = least_volume, .poor_shape = poor_shape});
}

/// With all that vertices inside can do.
inline Improvement improve_inside(TetComplex& complex, double target_deg, const Budget& budget = {}, int threads = 1) {
    RunContext context;
    context.threads = threads;
    const Objective objective = objective_for(target_deg);
    LocalMesh mesh(complex);
    return improve(mesh, objective,
                   list_of(edge_ring(mesh, objective), vertex_move(mesh, objective), cone_refill(mesh, objective)), {},
                   budget, context);
}

/// How often an operation was done, or planned.
inline std::size_t made(const Improvement& improvement, std::string_view operation) {
    for (const auto& count : improvement.counts)
        if (count.operation == operation) return count.made;
    return 0;
}
inline std::size_t planned(const Improvement& improvement, std::string_view operation) {
    for (const auto& count : improvement.counts)
        if (count.operation == operation) return count.planned;
    return 0;
}

}  // namespace featuremesh

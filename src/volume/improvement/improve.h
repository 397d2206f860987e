// SPDX-License-Identifier: GPL-3.0-or-later
// The one loop that makes tets better by local operations.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/run_context.h"
#include "volume/improvement/local_mesh.h"
#include "volume/improvement/objective.h"
#include "volume/improvement/operation.h"
#include "volume/tets/tet_complex.h"

namespace featuremesh {

/// The tets to begin with. Others that have changed on their account follow where they miss the target; shapes are
/// looked after in the region alone. Empty: all.
using Region = std::vector<int>;

struct Budget {
    int passes = 30;
    /// Of dear operations, in vain or not; each that was not in vain earns some more. Where next to nothing gains
    /// (thin walls) only the worst tets get what costs most.
    std::size_t dear_plans = 1'000'000, dear_plans_per_gain = 0;
};

enum class Stop { all_good, nothing_gains, out_of_passes };

struct Improvement {
    struct Count {
        std::string_view operation;
        std::size_t planned = 0, made = 0;
    };
    Stop why = Stop::all_good;
    std::size_t before = 0, left = 0;  ///< tets that miss the target
    std::size_t forced = 0;            ///< of those left: the worst angle lies between two boundary triangles
    std::size_t changes = 0;
    std::size_t planned_ahead = 0, outdated = 0;  ///< tets planned for on all threads; of these: once more later
    std::vector<Count> counts;                    ///< by operation
};

/// Takes the tets in need of work, worst first, in passes until nothing gains. For each the operations are tried in
/// order until one has a change to make. What failed is not tried again until something near it has changed. The same
/// bytes each time, for any number of threads: they plan ahead, and what was overtaken is planned again. Boundary
/// triangles and fixed vertices stay as they are. Throws Cancelled.
Improvement improve(LocalMesh& mesh, const Objective& objective, const Operations& operations, Region region,
                    const Budget& budget, RunContext& context);

/// Tets that miss the target.
std::size_t count_bad(const TetComplex& complex, const Objective& objective, RunContext& context);
/// Tets that are too thin, or have no volume at all.
std::size_t count_thin(const TetComplex& complex, const Objective& objective, RunContext& context);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows of a stiffness matrix are those of an earlier one, bit for bit, and need not be assembled again.
#pragma once

#include "core/run_context.h"
#include "statics/model.h"
#include "statics/stiffness.h"

namespace featuremesh {

/// Those rows of a model's matrix that the one of an earlier model has: of nodes whose tets are the same in the same
/// order, with the same nodes at the same places, held and made of the same.
SameRows same_rows(const StaticsModel& model, const TetsOfNodes& around, const StaticsModel& earlier,
                   const TetsOfNodes& around_earlier, RunContext& context);

}  // namespace featuremesh

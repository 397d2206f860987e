// SPDX-License-Identifier: GPL-3.0-or-later
// Which face of the final shape a face between material and void lies on.
#pragma once

#include <vector>

#include "cells/cell_model.h"

namespace featuremesh {

/// Sets CellFace::final_face on all faces with material behind or before them, not both, and owners_of_final_face. By
/// identity where the kernel kept the face, else by an inner point of either on the other. Material must be decided.
void match_final_faces(CellModel& model, const Brep& final_shape, RunContext& context);

}  // namespace featuremesh

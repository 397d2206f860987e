// SPDX-License-Identifier: GPL-3.0-or-later
// General Fuse of solids into cells and faces that know which of them they came from.
#pragma once

#include <string>
#include <vector>

#include "cells/cell_model.h"
#include "core/work.h"

namespace featuremesh {

/// One solid that takes part; an owner without a feature cuts but owns nothing.
struct FuseArgument {
    Owner owner;
    TopoDS_Shape solid;
};

struct FuseOptions {
    double fuzzy = 0;                 ///< mm, added to the shapes' own tolerances
    Work work = work_of_seconds(20);  ///< no more than this
};

/// Cells with owners and volumes, faces with owners and the cells beside them; material and final faces are not decided
/// yet.
struct FusedComplex {
    std::vector<Cell> cells;
    std::vector<CellFace> faces;
    std::string trouble;           ///< what went wrong, in words; empty when nothing did
    bool is_over_limit = false;    ///< is it that it was too much work?
    Work work = 0;                 ///< that was done
    std::vector<Owner> offenders;  ///< arguments whose cells do not add up to their own volume
};

/// Never throws for the kernel's sake: that is told in `trouble`. Throws Cancelled.
FusedComplex fuse(std::vector<FuseArgument> arguments, const FuseOptions& options, RunContext& context);

/// The same, one argument after the other into the cells so far. Slower, but what the kernel cannot intersect is left
/// out and told in `offenders`, and the others keep their cells. No argument gets more than a third of the work.
FusedComplex fuse_one_by_one(std::vector<FuseArgument> arguments, const FuseOptions& options, RunContext& context);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Curves in the parameters of a periodic surface, brought beside one another.
#pragma once

#include <vector>

class BRepAdaptor_Surface;

namespace featuremesh {

struct Parameters {
    double u = 0, v = 0;
};

/// Periods of a surface's parameters, 0 where there is none.
Parameters period_of(const BRepAdaptor_Surface& surface);

/// An edge of a face's border in its direction: from vertex `from` at `begin` to vertex `to` at `end`.
struct BorderStep {
    int from = 0, to = 0;
    Parameters begin, end;
};

/// Whole multiple of the period nearest to `distance`, by component; 0 for a parameter that has no period.
Parameters whole_periods(const Parameters& distance, const Parameters& period);

/// By step, what is to be added to its parameters so that the steps follow on one another. The kernel lets an edge's
/// curve on a face lie whole periods away from those of the edges beside it. Such a step is brought to the end of the
/// one before it, unless that could be several; all zeros where there is none.
std::vector<Parameters> period_shifts(const std::vector<BorderStep>& border, const Parameters& period);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace featuremesh {

/// Calls `improve(step)`, which says whether it found something better, with the step `first`, and with half of it
/// after each call that found nothing, until `is_done()` or the step is `last` or less. A thousand calls at most: a
/// search that ends by itself makes fewer, but each call may gain by rounding alone.
template <class IsDone, class Improve>
void search_by_shrinking_steps(double first, double last, const IsDone& is_done, const Improve& improve) {
    constexpr int most_calls = 1000;
    double step = first;
    for (int i = 0; i < most_calls && step > last && !is_done(); ++i)
        if (!improve(step)) step *= 0.5;
}

}  // namespace featuremesh

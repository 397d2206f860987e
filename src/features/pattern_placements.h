// SPDX-License-Identifier: GPL-3.0-or-later
// Where a pattern's parameters put its occurrences.
#pragma once

#include <gp_Trsf.hxx>

#include <cstdint>
#include <vector>

#include "features/document_view.h"
#include "features/raw_document.h"

namespace featuremesh {

struct Occurrence {
    gp_Trsf placement;
    std::int64_t number = 0;  ///< stays where one of several transformations gets more occurrences
};

/// All of a pattern, the first (the identity) included.
using Occurrences = std::vector<Occurrence>;

/// The shape under a placement, made anew where that mirrors or scales.
TopoDS_Shape placed(const TopoDS_Shape& shape, const gp_Trsf& placement);

/// All readings of the parameters worth trying, the likeliest first; empty when the direction, axis or plane cannot be
/// resolved. In the final shape's frame.
std::vector<Occurrences> candidate_occurrences(const RawRecord& pattern, const DocumentView& document);

}  // namespace featuremesh

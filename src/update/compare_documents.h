// SPDX-License-Identifier: GPL-3.0-or-later
// What changed between two states of a part's document, for whoever looks at them: no mesh is made.
#pragma once

#include <string>
#include <vector>

#include "difference/feature_difference.h"
#include "difference/followed_faces.h"
#include "difference/made_faces.h"
#include "difference/place_partners.h"
#include "features/raw_document.h"

namespace featuremesh {

struct ComparisonOptions {
    double resolution = 0;     ///< mm, see Resolution; 0: a hundredth of the new part's diagonal
    bool builds_cells = true;  ///< without cells it is quicker, and owners of faces are found by points of them
};

struct DocumentDifference {
    FeatureDifference difference;  ///< its faces know whether they are inner ones
    std::vector<EdgeChange> edges;
};

/// Throws InputError when a document has no shape that can be read.
DocumentDifference compare_documents(const RawDocument& old_document, const RawDocument& new_document,
                                     const ComparisonOptions& options, RunContext& context);

/// As follow_faces does, of two documents.
std::vector<FollowedFace> follow_faces_of_documents(const RawDocument& old_document, const SketchElements& old_elements,
                                                    const RawDocument& new_document, const SketchElements& new_elements,
                                                    RunContext& context);

/// Where the faces, edges and vertices of an object of the document lie on the document's final shape. Throws
/// InputError when it has no shape of that object.
PlacePartners partners_on_final_shape(const RawDocument& document, const std::string& object);

}  // namespace featuremesh

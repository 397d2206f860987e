// SPDX-License-Identifier: GPL-3.0-or-later
// The cellular model (Bidarra, Madeira, Neels and Bronsvoort 2005): every piece of space knows which features own it.
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>
#include <array>
#include <string>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/message.h"
#include "core/run_context.h"
#include "features/feature_tree.h"

namespace featuremesh {

/// One volume of one feature.
struct Owner {
    FeatureId feature;
    int volume = 0;  ///< index into Feature::volumes
    auto operator<=>(const Owner&) const = default;
};

struct Cell {
    TopoDS_Solid solid;
    std::vector<Owner> owners;  ///< sorted
    bool material = false;
    double volume = 0;  ///< mm^3
    Box box;
};

struct CellFace {
    TopoDS_Face face;
    std::vector<Owner> owners;    ///< the feature faces it is part of, sorted
    std::array<CellId, 2> cells;  ///< behind and before it; none for outside
    FaceId final_face;  ///< the face of the final shape it lies on; none inside the material (unless solids touch
                        ///< there) or outside
};

struct CellReport {
    double material_volume = 0, final_volume = 0;  ///< mm^3; the books close when they agree to 1e-6
    std::vector<std::string> fallbacks;            ///< fuzzy fuse, feature by feature, opaque features: in words
    std::vector<Message> findings;                 ///< what is odd about the part itself: solids that overlap
    std::vector<FeatureId> untrusted;              ///< features to be treated as changed
};

struct CellModel {
    std::vector<Cell> cells;
    std::vector<CellFace> faces;
    std::vector<std::vector<Owner>> owners_of_final_face;  ///< by FaceId of the final shape; none without a fuse
    std::vector<double> feature_volumes;                   ///< mm^3, by FeatureId: what its volumes fill together
    CellReport report;
};

/// By FeatureId: the sum of the cells it owns, mm^3.
std::vector<double> volumes_of_features(const std::vector<Cell>& cells, std::size_t feature_count);

/// Of what may be any feature's: the first volume of every feature that has one.
std::vector<Owner> owners_of_anything(const FeatureTree& tree);

/// Of a part of faces or edges there are no cells. General Fuse of all feature volumes with owner lists from the
/// builder's history, material by classification against the final shape. All attempts together have 24 s worth of
/// work, see docs/design/cells.md.
CellModel build_cells(const FeatureTree& tree, const Brep& final_shape, RunContext& context);

}  // namespace featuremesh

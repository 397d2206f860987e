// SPDX-License-Identifier: GPL-3.0-or-later
// All tolerances of the engine, scaled to the model.
#pragma once

namespace featuremesh {

struct Tolerances {
    /// Diagonal of the final shape's box, mm.
    double diagonal = 1.0;

    /// A boundary node is this close to its CAD entity: FreeCAD looks for it within the entity's tolerance (1e-7 mm).
    double on_entity() const { return 1e-8 > 1e-15 * diagonal ? 1e-8 : 1e-15 * diagonal; }
    /// Two CAD points, curves or surfaces are the same when no further apart than this.
    double same_geometry() const { return 1e-7 > 1e-9 * diagonal ? 1e-7 : 1e-9 * diagonal; }
    /// Two vertices of a solid nearer than this share a node: elements between them would have no volume to speak of.
    double negligible() const { return 9e-7 * diagonal; }
    /// Nodes of an edge keep as far from other edges that touch it: nearer, two chains could not be told apart.
    double contact() const { return 1.1e-5 * diagonal; }
    /// A tet of less volume than this, mm^3, is as good as flat.
    double least_volume() const { return 1.1e-12 * diagonal * diagonal * diagonal; }
    /// The edge of an even tet of that volume: elements that are all over shorter are as good as flat.
    double least_length() const { return 2.1e-4 * diagonal; }
    /// The volumes of the material cells add up to the final shape's within this share.
    static constexpr double volume_books = 1e-6;
    /// A direction cosine this far from 1 is another direction.
    static constexpr double same_direction = 1e-9;
};

}  // namespace featuremesh

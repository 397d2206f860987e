// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the mid-side nodes of 10-node tets on the exact CAD edges and faces.
#pragma once

#include <string>
#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"
#include "sizing/sizing_field.h"
#include "volume/curved/straight_sides.h"

namespace featuremesh {

/// A 10-node mesh, or why there is none.
struct SecondOrder {
    Mesh mesh;                        ///< empty where elements stay folded
    std::vector<SizeSource> shorter;  ///< edge lengths with which it may work, or get better where the aim is missed
    std::vector<Entity> place;        ///< the face at which that is, or the solid
    double smallest = 1;              ///< scaled Jacobian where the aim is missed
    StraightSides straight = {};      ///< where elements stay folded and nothing is kept, with straight sides there

    bool is_valid() const { return !mesh.tets.empty(); }
};

/// Makes a 4-node mesh a 10-node one: sides on CAD edges and faces get their mid-side node on the entity, half way in
/// the edge's arc length, others in the middle. Where an element's scaled Jacobian would be below 0.2, nodes move
/// (those on entities along them). Elements of `kept` (a 10-node mesh, its elements in
/// front in the same order) keep their nodes bit for bit.
SecondOrder try_second_order(const Brep& brep, Mesh mesh, const Mesh* kept, RunContext& context);
/// Makes 3-node triangles and their segments 6-node and 3-node ones; no node moves. Of `kept` as above.
Mesh curved_without_tets(const Brep& brep, Mesh mesh, const Mesh* kept, RunContext& context);
/// As try_second_order; throws MeshError that names the face where elements stay folded.
Mesh curve_to_second_order(const Brep& brep, Mesh mesh, const Mesh* kept, RunContext& context);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of a feature (the holes of one sketch, the instances of a pattern), matched by geometry, not by number.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

#include "core/geometry.h"
#include "core/message.h"
#include "difference/feature_motion.h"
#include "difference/underlying_geometry.h"
#include "features/feature_tree.h"

namespace featuremesh {

/// The solids of a shape; where it has none its shells and faces of no shell, or else its wires and edges of no wire.
std::vector<TopoDS_Shape> pieces_of(const TopoDS_Shape& shape);

/// One piece of one volume.
struct FeaturePiece {
    TopoDS_Shape shape;
    Effect effect = Effect::adds;
    VolumeOutline outline;
    Box box;  ///< of the outline's points
};
std::vector<FeaturePiece> pieces_of(const Feature& feature);

struct PieceMatch {
    std::vector<int> new_of;           ///< by old piece; -1 for none
    std::vector<RigidMotion> motions;  ///< by old piece
    std::size_t same = 0, moved = 0, added = 0, removed = 0;
};
/// Those that stayed first, then those that moved, tried with `hint` before any other motion.
PieceMatch match_pieces(const std::vector<FeaturePiece>& was, const std::vector<FeaturePiece>& is,
                        const RigidMotion& hint, const Sameness& sameness);

/// "1 of 6 holes moved by (-5, 0, 0) mm from x 110 mm, y 70 mm to x 105 mm, y 70 mm"; says nothing when nothing
/// happened. Positions are the middles of what of the pieces is within the box of the part, without the directions in
/// which that is all of it.
Message describe(const PieceMatch& match, const std::vector<FeaturePiece>& was, const std::vector<FeaturePiece>& is,
                 const Box& old_part, const Box& new_part);

}  // namespace featuremesh

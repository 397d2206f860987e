// SPDX-License-Identifier: GPL-3.0-or-later
// Old boundary, moved, against new boundary: which faces lie on the same underlying surface, and where the borders of
// their trims differ.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"
#include "difference/boundary_model.h"
#include "difference/underlying_geometry.h"

namespace featuremesh {

/// The old boundary under a motion and the new one; only underlying surfaces with a face that touches `domain` matter,
/// all when there is none.
struct BoundaryPair {
    const BoundaryModel& old_model;
    const BoundaryModel& new_model;
    RigidMotion motion;
    std::optional<Box> domain;
    Sameness sameness;
};

/// An edge as a stretch of a curve that several edges may share.
struct Stretch {
    int curve = -1;              ///< index into BoundaryMatch::curves; -1 for a pole
    double first = 0, last = 0;  ///< curve parameters, first < last; of a closed curve first is in [0, period)
    bool along = true;           ///< the edge runs in the direction of the curve
};

/// Part of the border of one trim that the other does not have.
struct ChangedPiece {
    int curve = -1;
    double first = 0, last = 0;
    bool is_border = false;  ///< left or right of it, not both, is the symmetric difference of the trims
};

/// All faces of both states on one underlying surface with the material in the same direction.
struct SurfaceGroup {
    std::vector<FaceId> old_faces, new_faces;
    std::vector<ChangedPiece> pieces;
    std::vector<Vec3> points;  ///< vertices that one state does not have, in the new state's place

    bool in_domain = false;  ///< else nothing was compared

    bool is_unchanged() const { return pieces.empty() && points.empty(); }
};

struct BoundaryMatch {
    std::vector<UnderlyingCurve> curves;        ///< in the new state's place
    std::vector<Stretch> old_edges, new_edges;  ///< by EdgeId
    std::vector<VertexId> new_vertex_of;        ///< by old VertexId
    std::vector<SurfaceGroup> groups;
    std::vector<int> group_of_old_face, group_of_new_face;
    std::vector<char> old_normal_as_group,
        new_normal_as_group;  ///< by FaceId: the oriented normal is the one the group counts by
};

BoundaryMatch match_boundaries(const BoundaryPair& pair);

/// A box that holds the moved box.
Box moved(const Box& box, const RigidMotion& motion);

/// 2 pi for circles and ellipses, 0 for curves that do not come round.
double period_of(const UnderlyingCurve& curve);

/// Parameters of the curve no further apart are the same; `length` in mm.
double parameter_tolerance(const UnderlyingCurve& curve, double length);

/// The parts of a stretch of the curve within one period, from 0 on; all of it where the curve does not come round.
/// `length` as above.
std::vector<Stretch> within_period(const Stretch& stretch, const UnderlyingCurve& curve, double length);

}  // namespace featuremesh

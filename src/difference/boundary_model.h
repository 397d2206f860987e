// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a final shape as trimmed underlying surfaces, ready to be compared under any motion.
#pragma once

#include <optional>
#include <vector>

#include "brep/brep.h"
#include "brep/face_trim.h"
#include "brep/solid_probe.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "difference/underlying_geometry.h"

namespace featuremesh {

/// An edge in the border of a face; the face lies to its left seen against the face's normal, or left and right.
struct EdgeUse {
    EdgeId edge;
    bool forward = true;
    bool is_internal = false;  ///< drawn into the face, not at its border
};

struct BoundaryFace {
    UnderlyingSurface underlying;
    bool normal_is_outward = true;                         ///< the oriented face's normal has the sense of `outward_at`
    bool material_behind = true, material_before = false;  ///< against and along the oriented normal
    std::vector<EdgeUse> uses;                             ///< without degenerated edges
    Box box;                                               ///< holds it, not tightly
};

struct BoundaryEdge {
    UnderlyingCurve curve;
    Vec3 first, last;  ///< at the ends of the range
    Box box;
    bool is_degenerated = false;
};

class BoundaryModel {
  public:
    explicit BoundaryModel(const Brep& brep);

    const Brep& brep() const { return brep_; }
    const std::vector<BoundaryFace>& faces() const { return faces_; }
    const std::vector<BoundaryEdge>& edges() const { return edges_; }
    /// Where the parameters are relative to the face's trim. Not for several threads at once.
    Containment classify(FaceId face, std::array<double, 2> uv) const;

  private:
    void take_edge(EdgeId id);
    void take_face(FaceId id);
    Box box_of_face(const BoundaryFace& face, FaceId id) const;
    void find_sense(FaceId id, BoundaryFace& face) const;

    Brep brep_;
    std::vector<BoundaryFace> faces_;
    std::vector<BoundaryEdge> edges_;
    mutable std::vector<std::optional<FaceTrim>> trims_;
};

}  // namespace featuremesh

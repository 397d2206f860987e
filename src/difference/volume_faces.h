// SPDX-License-Identifier: GPL-3.0-or-later
// Owners of a face of the final shape without a fuse.
#pragma once

#include <TopoDS_Face.hxx>
#include <vector>

#include "cells/cell_model.h"
#include "difference/carriers.h"
#include "features/face_probe.h"

namespace featuremesh {

/// The faces of all volumes of all features. Not for concurrent use.
class VolumeFaces {
  public:
    explicit VolumeFaces(const FeatureTree& tree);
    /// Owners of the volume faces on the carrier of a face of the final shape that hold some of 36 points spread over
    /// it; sorted. What lies between those points is not found.
    std::vector<Owner> owners_on(const TopoDS_Face& final_face) const;
    /// By FaceId; a face on which no volume has one may be any feature's.
    std::vector<std::vector<Owner>> owners_of_faces(const Brep& final_shape) const;

  private:
    struct OwnedFace {
        Owner owner;
        SurfaceCarrier carrier;
        FaceProbe probe;
    };
    std::vector<OwnedFace> faces_;  // by owner
    std::vector<Owner> anybody_;
};

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Owners of a face of the final shape without a fuse.
#pragma once

#include <TopoDS_Face.hxx>
#include <span>
#include <utility>
#include <vector>

#include "brep/face_probe.h"
#include "cells/cell_model.h"
#include "core/geometry.h"
#include "difference/underlying_geometry.h"
#include "features/feature_tree.h"

namespace featuremesh {

/// A point of a face with its parameters there.
struct SurfacePoint {
    Vec3 point;
    double u = 0, v = 0;
};
/// Those of 36 points, spread evenly over the parameters of a face, that lie in its trim.
std::vector<SurfacePoint> points_in_trim(const TopoDS_Face& face);

/// The faces of all volumes of all features. Not for concurrent use.
class VolumeFaces {
  public:
    /// `reference`: a place at the part, but at no symmetry of it.
    VolumeFaces(const FeatureTree& tree, const Vec3& reference);
    /// Owners, of the features that are marked, of the volume faces on the underlying surface of a face of the final
    /// shape that hold some of 36 points spread over it, or the only one who has faces there; sorted. What lies between
    /// those points is not found. `box` holds the face.
    std::vector<Owner> owners_on(const TopoDS_Face& final_face, const Box& box, std::span<const char> is_wanted) const;

  private:
    struct OwnedFace {
        Owner owner;
        UnderlyingSurface underlying;
        FaceProbe probe;
    };
    /// Those of a feature on that underlying surface whose boxes meet the box, by owner.
    std::vector<const OwnedFace*> faces_of(std::size_t feature, const UnderlyingSurface& underlying,
                                           const Box& box) const;

    Vec3 reference_;
    std::vector<std::vector<OwnedFace>> of_feature_;                        // by owner
    std::vector<std::vector<std::pair<double, std::size_t>>> by_sort_key_;  // of these, the places in the lists
};

}  // namespace featuremesh

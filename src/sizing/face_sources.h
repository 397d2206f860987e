// SPDX-License-Identifier: GPL-3.0-or-later
// Covers a face with balls of the size that is wanted there.
#pragma once

#include <algorithm>
#include <numbers>
#include <vector>

#include "brep/brep.h"
#include "sizing/sizing_field.h"
#include "sizing/source_tree.h"
#include "sizing/wall_rays.h"

namespace featuremesh {

/// What is asked for on one face.
struct FaceWish {
    double local = std::numeric_limits<double>::infinity();  ///< mm
    double per_circle = 0;            ///< elements around a full circle of the curvature; 0 is off
    double across_gap = 0;            ///< elements across a wall; 0 is off
    const WallRays* walls = nullptr;  ///< for across_gap
};

/// Edge length that puts `per_circle` elements around a circle of this curvature (1/mm).
inline double circle_size(double curvature, double per_circle) {
    return 2 * std::numbers::pi / (curvature * per_circle);
}
/// Curvature and gaps ask for nothing below this: poles and kinks would ask for nothing at all. On free-form curves and
/// surfaces a large curvature is more often a wrinkle than a feature.
inline double curvature_floor(const SizingOptions& options, bool is_free_form) {
    return std::max(options.min_size, (is_free_form ? 0.05 : 0.01) * options.size);
}

/// Appends the balls; none where nothing below options.size is wanted. The face is halved in its parameters until the
/// pieces are about two of the wanted edge lengths long.
void cover_face(const Brep& brep, FaceId face, const FaceWish& wish, const SizingOptions& options,
                std::vector<SourceBall>& out);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes by the curvature of faces and edges.
#pragma once

#include <memory>

#include "brep/brep.h"
#include "core/ids.h"
#include "sizing/size_provider.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// Curvature and thin walls ask for nothing below this on a face, mm: poles and kinks would ask for nothing at all. On
/// free-form surfaces a large curvature is more often a wrinkle than a feature; on a cone the floor is a quarter of
/// what its widest circle asks for, since its apex would ask for nothing.
double curvature_floor(const Brep& brep, FaceId face, const SizingOptions& options);

/// `options.elements_per_circle` elements around a full circle of the larger principal curvature of faces, and of the
/// curvature of edges: an edge length of 2 pi / (curvature * elements). Planes, lines, and cylinders, spheres and tori
/// that ask for nothing, cost nothing.
std::unique_ptr<SizeProvider> curvature_provider(const Brep& brep, const SizingOptions& options);

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
// What asks for sizes: local sizes, curvature, thin walls, narrow faces. Each is one file, listed in
// size_providers.cpp.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "sizing/source_ball.h"
#include "sizing/zone_field.h"

namespace featuremesh {

constexpr double no_size = std::numeric_limits<double>::infinity();  ///< nothing is asked for

/// A point of a face with what its surface does there.
struct SurfacePoint {
    Vec3 point, du, dv;
    Vec3 normal;           ///< of the surface, unit; zero at a pole
    double curvature = 0;  ///< largest absolute principal curvature, 1/mm; 0 at a pole
};

/// The size that is wanted at each point of a face, mm; empty where the face is of no interest.
struct FaceWish {
    std::function<double(const SurfacePoint&)> size;
    /// Less may be wanted anywhere between points that ask for nothing, so that pieces down to the global size are
    /// looked at.
    bool may_be_anywhere = false;
};

/// The size that is wanted where an edge has that curvature (1/mm), mm; empty where the edge is of no interest.
using EdgeWish = std::function<double(double curvature)>;

/// Where sizes are asked for; away from there they grow.
struct SizePlaces {
    std::vector<SourceBall> balls;
    std::vector<ZoneField> zones;
};

/// One kind of reason for a size. Of all that providers ask for in one place the smallest counts; between the places it
/// grows. Refers to the part and the options that it was made for.
class SizeProvider {
  public:
    SizeProvider() = default;
    SizeProvider(const SizeProvider&) = delete;
    SizeProvider& operator=(const SizeProvider&) = delete;
    virtual ~SizeProvider() = default;

    virtual double on(VertexId) const { return no_size; }  ///< mm
    virtual EdgeWish on(EdgeId) const { return {}; }
    virtual FaceWish on(FaceId) const { return {}; }
    /// Places of its own, where the entities do not say it.
    virtual void cover(SizePlaces&, const RunContext&) const {}
};

}  // namespace featuremesh

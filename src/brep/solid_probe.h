// SPDX-License-Identifier: GPL-3.0-or-later
// Inside or outside: points against solids, and sound inner points of solids and faces.
#pragma once

#include <memory>
#include <optional>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"

class TopoDS_Shape;
class TopoDS_Face;

namespace featuremesh {

/// Of a point, in a solid or in the trim of a face.
enum class Containment { inside, outside, on };

/// Classifies points against the solids of a shape by shooting rays at the faces whose boxes they meet. A ray that
/// grazes a face or meets an edge proves nothing and is replaced by another; the kernel's classifier has the last word.
/// Intersectors are made when first needed and kept, so one probe serves many points but only one thread.
class SolidProbe {
  public:
    explicit SolidProbe(const TopoDS_Shape& solids);
    SolidProbe(const Brep& brep, SolidId solid);  ///< quicker: the boxes of the faces are known
    ~SolidProbe();
    SolidProbe(const SolidProbe&) = delete;
    SolidProbe& operator=(const SolidProbe&) = delete;

    /// `on` when p is closer to a face than 1e-7 mm along one of the rays.
    Containment containment_of(const Vec3& p) const;
    /// Distance to the nearest face along a unit direction, further than `skip`; nothing when the ray meets none.
    std::optional<double> first_hit(const Vec3& from, const Vec3& direction, double skip) const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

struct FacePoint {
    Vec3 point, normal;  ///< normal points out of the material that the oriented face bounds
};
/// A point well inside the trimmed face; nothing for a face without area.
std::optional<FacePoint> point_on(const TopoDS_Face& face);

/// A point inside a solid: the middle of the longest of a few stretches from a face inwards; nothing for a degenerate
/// solid.
std::optional<Vec3> point_inside(const TopoDS_Shape& solid);

}  // namespace featuremesh

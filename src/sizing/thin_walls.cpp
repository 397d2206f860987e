// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/thin_walls.h"

#include <TopoDS_Face.hxx>
#include <algorithm>
#include <optional>

#include "core/dimension.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "sizing/curvature.h"
#include "sizing/wall_rays.h"

namespace featuremesh {
namespace {

class ThinWallProvider : public SizeProvider {
  public:
    ThinWallProvider(const Brep& brep, const SizingOptions& options) : brep_(brep), options_(options) {
        if (options.elements_across_gap > 0 && brep.dimension() == Dimension::solids)
            rays_.emplace(brep, std::max(0.02 * options.size, 1e-3 * brep.box().diagonal()));
    }

    FaceWish on(FaceId face) const override {
        if (!rays_) return {};
        return {[this, face, floor = curvature_floor(brep_, face, options_)](const SurfacePoint& p) {
                    if (squared_length(p.normal) == 0) return options_.size;
                    return std::max(floor, thickness(face, p) / options_.elements_across_gap);
                },
                true};
    }

  private:
    /// Of the thinner of the walls behind and before it, mm; no more than is of interest.
    double thickness(FaceId face, const SurfacePoint& p) const {
        const double limit = options_.elements_across_gap * options_.size;
        const Vec3 outward = brep_.face(face).Orientation() == TopAbs_REVERSED ? -p.normal : p.normal;
        const auto solids = brep_.solids_beside(face);
        double least = limit;
        if (solids[0].is_valid()) least = std::min(least, rays_->thickness(face, p.point, -outward, limit));
        if (solids[1].is_valid()) least = std::min(least, rays_->thickness(face, p.point, outward, limit));
        return least;
    }

    const Brep& brep_;
    const SizingOptions& options_;
    std::optional<WallRays> rays_;
};

}  // namespace

std::unique_ptr<SizeProvider> thin_wall_provider(const Brep& brep, const SizingOptions& options) {
    return std::make_unique<ThinWallProvider>(brep, options);
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/local_sizes.h"

#include <BRepClass3d_SolidClassifier.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <array>

#include "core/geometry.h"
#include "core/ids.h"
#include "sizing/face_cover.h"
#include "sizing/source_ball.h"
#include "sizing/source_tree.h"

namespace featuremesh {
namespace {

/// Covers the inside of one of several solids by halving its box; what its faces cover already tells the depth.
class SolidCover {
  public:
    SolidCover(const TopoDS_Solid& solid, double size, double smallest_cell, const std::vector<SourceBall>& on_faces,
               std::vector<SourceBall>& out)
        : classifier_(solid), size_(size), smallest_cell_(smallest_cell), out_(out) {
        std::vector<SourceBall> faces = on_faces;
        for (SourceBall& ball : faces) ball.size = 0;
        distance_to_faces_ = SourceTree(std::move(faces), 1.0, std::numeric_limits<double>::infinity());
    }

    void run(const Box& box) {
        const double radius = 0.5 * box.diagonal();
        const Vec3 center = box.center();
        const bool is_small = radius <= smallest_cell_;
        if (is_small || distance_to_faces_.at(center) >= radius) {
            classifier_.Perform({center.x, center.y, center.z}, 1e-7);
            if (is_small || classifier_.State() == TopAbs_IN)
                if (classifier_.State() != TopAbs_OUT) out_.push_back({center, radius, size_});
            return;
        }
        const Vec3 half = box.size() * 0.5;
        for (int octant = 0; octant < 8; ++octant) {
            const Vec3 low{box.low.x + (octant & 1 ? half.x : 0), box.low.y + (octant & 2 ? half.y : 0),
                           box.low.z + (octant & 4 ? half.z : 0)};
            run({low, low + half});
        }
    }

  private:
    BRepClass3d_SolidClassifier classifier_;
    const double size_, smallest_cell_;
    SourceTree distance_to_faces_;
    std::vector<SourceBall>& out_;
};

FaceWish everywhere(double size) {
    return {[size](const SurfacePoint&) { return size; }};
}

class LocalSizeProvider : public SizeProvider {
  public:
    LocalSizeProvider(const Brep& brep, const SizingOptions& options) : brep_(brep), limit_(options.size) {
        const std::array<std::size_t, 4> counts{brep.vertex_count(), brep.edge_count(), brep.face_count(),
                                                brep.solid_count()};
        for (int dim = 0; dim < 4; ++dim) sizes_[dim].assign(counts[dim], options.size);
        for (const LocalSize& local : options.local) {
            const auto [dim, index] = local.entity;
            if (dim < 0 || dim > 3 || index < 0 || static_cast<std::size_t>(index) >= counts[dim]) continue;
            double& size = sizes_[dim][static_cast<std::size_t>(index)];
            size = std::min(size, local.size);
        }
        for (std::size_t f = 0; f < brep.face_count(); ++f)
            for (const SolidId solid : brep.solids_beside(FaceId(f)))
                if (solid.is_valid()) sizes_[2][f] = std::min(sizes_[2][f], sizes_[3][solid.index()]);
    }

    double on(VertexId vertex) const override { return sizes_[0][vertex.index()]; }
    EdgeWish on(EdgeId edge) const override {
        const double size = sizes_[1][edge.index()];
        if (size >= limit_) return {};
        return [size](double) { return size; };
    }
    FaceWish on(FaceId face) const override {
        const double size = sizes_[2][face.index()];
        return size < limit_ ? everywhere(size) : FaceWish{};
    }
    void cover(SizePlaces& out, const RunContext& context) const override {
        if (brep_.solid_count() < 2) return;
        for (std::size_t s = 0; s < brep_.solid_count(); ++s) {
            context.check_cancelled();
            if (sizes_[3][s] < limit_) cover_solid(SolidId(s), sizes_[3][s], out.balls);
        }
    }

  private:
    void cover_solid(SolidId solid, double size, std::vector<SourceBall>& out) const {
        const std::array<FaceWish, 1> wish{everywhere(size)};
        Box box;
        std::vector<SourceBall> on_faces;
        for (std::size_t f = 0; f < brep_.face_count(); ++f) {
            const auto solids = brep_.solids_beside(FaceId(f));
            if (solids[0] == solid || solids[1] == solid) cover_face(brep_, FaceId(f), wish, limit_, on_faces);
        }
        for (const SourceBall& ball : on_faces) box.add(ball.center);
        if (box.is_empty()) return;
        SolidCover(brep_.solid(solid), size, std::max(2 * size, box.diagonal() / 48), on_faces, out).run(box);
    }

    const Brep& brep_;
    const double limit_;
    std::array<std::vector<double>, 4> sizes_;  ///< by dimension and entity
};

}  // namespace

std::unique_ptr<SizeProvider> local_size_provider(const Brep& brep, const SizingOptions& options) {
    return std::make_unique<LocalSizeProvider>(brep, options);
}

}  // namespace featuremesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/shape_sources.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <GeomAbs_CurveType.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "brep/occt_geometry.h"
#include "sizing/face_sources.h"
#include "sizing/lost_sizes.h"
#include "sizing/narrow_faces.h"
#include "sizing/wall_rays.h"

namespace featuremesh {
namespace {

/// The local sizes by entity; the smallest one counts where several are given.
struct LocalSizes {
    std::vector<double> vertices, edges, faces, solids;
};

LocalSizes local_sizes(const Brep& brep, const SizingOptions& options, RunContext& context) {
    LocalSizes sizes;
    const std::array<std::vector<double>*, 4> by_dim{&sizes.vertices, &sizes.edges, &sizes.faces, &sizes.solids};
    const std::array<std::size_t, 4> counts{brep.vertex_count(), brep.edge_count(), brep.face_count(),
                                            brep.solid_count()};
    for (int dim = 0; dim < 4; ++dim) by_dim[dim]->assign(counts[dim], options.size);
    for (const std::string& line : lost_sizes(brep, options)) context.log(line);
    for (const LocalSize& local : options.local) {
        const auto [dim, index] = local.entity;
        if (dim < 0 || dim > 3 || index < 0 || static_cast<std::size_t>(index) >= counts[dim]) continue;
        double& size = (*by_dim[dim])[static_cast<std::size_t>(index)];
        size = std::min(size, local.size);
    }
    // what is asked for in a solid is asked for on its faces
    for (std::size_t f = 0; f < brep.face_count(); ++f)
        for (const SolidId side : brep.sides_of(FaceId(f)))
            if (side.is_valid()) sizes.faces[f] = std::min(sizes.faces[f], sizes.solids[side.index()]);
    return sizes;
}

/// Covers one edge with balls, by halving its pieces until they are as short as wanted.
class EdgeCover {
  public:
    EdgeCover(const TopoDS_Edge& edge, double local, double per_circle, const SizingOptions& options,
              std::vector<SourceBall>& out)
        : curve_(edge),
          local_(local),
          per_circle_(curve_.GetType() == GeomAbs_Line ? 0 : per_circle),
          options_(options),
          out_(out) {}

    void run() {
        if (local_ >= options_.size && per_circle_ <= 0) return;
        const double first = curve_.FirstParameter(), last = curve_.LastParameter();
        const int pieces = curve_.GetType() == GeomAbs_BSplineCurve ? std::clamp(curve_.NbKnots() - 1, 4, 64)
                           : curve_.GetType() == GeomAbs_Line       ? 1
                                                                    : 8;
        for (int i = 0; i < pieces; ++i)
            cover(first + (last - first) * i / pieces, first + (last - first) * (i + 1) / pieces, 0);
    }

  private:
    double wanted(double t) const {
        double size = local_;
        if (per_circle_ <= 0) return size;
        gp_Pnt p;
        gp_Vec d1, d2;
        curve_.D2(t, p, d1, d2);
        const double speed = d1.Magnitude(), bend = d1.Crossed(d2).Magnitude();
        if (bend > 0 && speed > 0)
            size = std::min(size, std::max(curvature_floor(options_, curve_.GetType() > GeomAbs_Circle),
                                           circle_size(bend / (speed * speed * speed), per_circle_)));
        return size;
    }
    void cover(double from, double to, int depth) {
        const double middle = 0.5 * (from + to);
        const Vec3 a = to_vec3(curve_.Value(from)), m = to_vec3(curve_.Value(middle)), b = to_vec3(curve_.Value(to));
        const double length = distance(a, m) + distance(m, b);
        const double size =
            std::min({wanted(middle), wanted(from + 0.05 * (to - from)), wanted(to - 0.05 * (to - from))});
        if (size >= options_.size) return;
        if (length > 2 * size && depth < 16) {
            cover(from, middle, depth + 1);
            cover(middle, to, depth + 1);
            return;
        }
        out_.push_back({m, std::max(distance(a, m), distance(m, b)), size});
    }

    const BRepAdaptor_Curve curve_;
    const double local_, per_circle_;
    const SizingOptions& options_;
    std::vector<SourceBall>& out_;
};

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

void cover_solids(const Brep& brep, const SizingOptions& options, const LocalSizes& sizes, RunContext& context,
                  std::vector<SourceBall>& out) {
    for (std::size_t s = 0; s < brep.solid_count(); ++s) {
        if (sizes.solids[s] >= options.size) continue;
        Box box;
        std::vector<SourceBall> on_faces;
        for (std::size_t f = 0; f < brep.face_count(); ++f) {
            const auto sides = brep.sides_of(FaceId(f));
            if (sides[0] != SolidId(s) && sides[1] != SolidId(s)) continue;
            FaceWish wish;
            wish.local = sizes.solids[s];
            cover_face(brep, FaceId(f), wish, options, on_faces);
        }
        for (const SourceBall& ball : on_faces) box.add(ball.center);
        context.check_cancelled();
        if (!box.is_empty())
            SolidCover(brep.solid(SolidId(s)), sizes.solids[s], std::max(2 * sizes.solids[s], box.diagonal() / 48),
                       on_faces, out)
                .run(box);
    }
}

}  // namespace

std::vector<SourceBall> shape_sources(const Brep& brep, const SizingOptions& options, RunContext& context) {
    const LocalSizes sizes = local_sizes(brep, options, context);
    std::vector<SourceBall> sources;
    for (std::size_t v = 0; v < brep.vertex_count(); ++v)
        if (sizes.vertices[v] < options.size)
            sources.push_back({brep.point_of(VertexId(v)), 0.5 * sizes.vertices[v], sizes.vertices[v]});
    for (std::size_t e = 0; e < brep.edge_count(); ++e)
        if (!brep.is_degenerated(EdgeId(e)))
            EdgeCover(brep.edge(EdgeId(e)), sizes.edges[e], options.elements_per_circle, options, sources).run();
    std::optional<WallRays> walls;
    if (options.elements_across_gap > 0)
        walls.emplace(brep, std::max(0.02 * options.size, 1e-3 * brep.box().diagonal()));
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        context.check_cancelled();
        FaceWish wish;
        wish.local = sizes.faces[f];
        wish.per_circle = options.elements_per_circle;
        wish.across_gap = options.elements_across_gap;
        wish.walls = walls ? &*walls : nullptr;
        cover_face(brep, FaceId(f), wish, options, sources);
        if (options.refines_narrow_faces) cover_narrow_face(brep, FaceId(f), options, sources);
    }
    if (brep.solid_count() > 1) cover_solids(brep, options, sizes, context, sources);
    return sources;
}

}  // namespace featuremesh

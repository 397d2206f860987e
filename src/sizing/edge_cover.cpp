// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/edge_cover.h"

#include <BRepAdaptor_Curve.hxx>
#include <GeomAbs_CurveType.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>

#include "brep/occt_geometry.h"
#include "core/geometry.h"

namespace featuremesh {
namespace {

class EdgeCover {
  public:
    EdgeCover(const TopoDS_Edge& edge, std::span<const EdgeWish> wishes, double limit, std::vector<SourceBall>& out)
        : curve_(edge), wishes_(wishes), limit_(limit), out_(out) {}

    void run() {
        const double first = curve_.FirstParameter(), last = curve_.LastParameter();
        const int pieces = curve_.GetType() == GeomAbs_BSplineCurve ? std::clamp(curve_.NbKnots() - 1, 4, 64)
                           : curve_.GetType() == GeomAbs_Line       ? 1
                                                                    : 8;
        for (int i = 0; i < pieces; ++i)
            cover(first + (last - first) * i / pieces, first + (last - first) * (i + 1) / pieces, 0);
    }

  private:
    double curvature(double t) const {
        gp_Pnt p;
        gp_Vec d1, d2;
        curve_.D2(t, p, d1, d2);
        const double speed = d1.Magnitude(), bend = d1.Crossed(d2).Magnitude();
        return bend > 0 && speed > 0 ? bend / (speed * speed * speed) : 0;
    }
    double wanted(double t) const {
        const double bend = curvature(t);
        double size = no_size;
        for (const EdgeWish& wish : wishes_) size = std::min(size, wish(bend));
        return size;
    }
    void cover(double from, double to, int depth) {
        const double middle = 0.5 * (from + to);
        const Vec3 a = to_vec3(curve_.Value(from)), m = to_vec3(curve_.Value(middle)), b = to_vec3(curve_.Value(to));
        const double length = distance(a, m) + distance(m, b);
        const double size =
            std::min({wanted(middle), wanted(from + 0.05 * (to - from)), wanted(to - 0.05 * (to - from))});
        if (size >= limit_) return;
        if (length > 2 * size && depth < 16) {
            cover(from, middle, depth + 1);
            cover(middle, to, depth + 1);
            return;
        }
        out_.push_back({m, std::max(distance(a, m), distance(m, b)), size});
    }

    const BRepAdaptor_Curve curve_;
    const std::span<const EdgeWish> wishes_;
    const double limit_;
    std::vector<SourceBall>& out_;
};

}  // namespace

void cover_edge(const Brep& brep, EdgeId edge, std::span<const EdgeWish> wishes, double limit,
                std::vector<SourceBall>& out) {
    if (!wishes.empty() && !brep.is_degenerated(edge)) EdgeCover(brep.edge(edge), wishes, limit, out).run();
}

}  // namespace featuremesh
